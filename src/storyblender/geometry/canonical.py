"""Which way up, which way front and in which unit: brings a foreign model to the canonical frame. Pure numpy.

The paper's Asset Formatter asks a vision model; these are the cues that need none: what a thing can stand on, its
mirror plane, where its upper mass lies, and the sizes things have. File formats fix an up axis, so the file's own
pose is kept unless the geometry speaks clearly against it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Triangles = NDArray[np.int64]

UP_PRIOR = 2.1
"""How much worse the file's own up may score before another is taken: it must be about to fall over."""
MIRROR_MARGIN = 0.08
"""How much better a side mirror must be than the front-back mirror before the model is turned."""
BACK_RISE = 0.15
"""Share of its height by which one end must be higher than the other to tell back from front."""
SAMPLES = 20_000
"""Points that stand for the surface."""
UNITS: tuple[tuple[str, float], ...] = (("metre", 1.0), ("centimetre", 0.01), ("millimetre", 0.001), ("inch", 0.0254))
LIKELY = ((0.02, 32.0), (0.1, 8.0), (0.1, 8.0))
"""Metres: the largest extent that makes a metre, a centimetre, a millimetre file believable."""


@dataclass(frozen=True)
class Alignment:
    """How to bring a model to the canonical frame.

    Attributes:
        rotation: (3, 3) canonical from file.
        unit: Metres of one unit of the file.
        unit_name: Its name.
        certainty: 0..1; low where two readings score alike.
    """

    rotation: Floats
    unit: float
    unit_name: str
    certainty: float


def align(vertices: Floats, triangles: Triangles) -> Alignment:
    """Return how to turn and scale a model.

    Args:
        vertices: (n, 3) in the file's frame and unit, Z up as its importer gives it.
        triangles: (m, 3) vertex indices.
    """
    up, up_margin = _up(vertices, triangles)
    upright = vertices @ up.T
    turn, front_margin = _front(upright, triangles)
    rotation = turn @ up
    name, unit = _unit(float(np.ptp(vertices, axis=0).max()))
    return Alignment(rotation, unit, name, float(np.clip(min(up_margin, front_margin), 0, 1)))


def stability(vertices: Floats, triangles: Triangles) -> float:
    """Return 0..2: how well the model stands on what touches the ground when +Z is up.

    The share of its footprint that its support polygon covers, plus how far inside that polygon its mass lies.
    """
    low, extent = vertices.min(axis=0), np.maximum(np.ptp(vertices, axis=0), 1e-9)
    touching = vertices[vertices[:, 2] < low[2] + 0.02 * extent[2], :2]
    hull = convex_hull(touching)
    if len(hull) < 3:
        return 0.0
    share = polygon_area(hull) / (extent[0] * extent[1])
    centers, areas = _centers(vertices, triangles)
    mass = np.average(centers[:, :2], axis=0, weights=areas)
    return float(share + np.clip(_depth_inside(hull, mass) / (0.25 * extent[:2].min()), -1, 1))


def convex_hull(points: Floats) -> Floats:
    """Return the corners of the convex hull of (n, 2) points, counter-clockwise (monotone chain)."""
    ordered = np.unique(points.round(9), axis=0)
    if len(ordered) < 3:
        return ordered

    def chain(sequence: Floats) -> list[Floats]:
        line: list[Floats] = []
        for point in sequence:
            while len(line) > 1 and _cross(line[-1] - line[-2], point - line[-2]) <= 0:
                line.pop()
            line.append(point)
        return line[:-1]

    return np.array(chain(ordered) + chain(ordered[::-1]))


def polygon_area(corners: Floats) -> float:
    """Return the area of a (n, 2) polygon."""
    return abs(float(_cross(corners, np.roll(corners, -1, axis=0)).sum())) / 2


def _cross(a: Floats, b: Floats) -> Floats:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _depth_inside(hull: Floats, point: Floats) -> float:
    """Return the distance from a point to the hull's nearest edge; negative outside."""
    edges = np.roll(hull, -1, axis=0) - hull
    return float((_cross(edges, point - hull) / np.maximum(np.linalg.norm(edges, axis=1), 1e-12)).min())


def _centers(vertices: Floats, triangles: Triangles) -> tuple[Floats, Floats]:
    corners = vertices[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return corners.mean(axis=1), np.maximum(np.linalg.norm(normal, axis=1) / 2, 1e-12)


def _up(vertices: Floats, triangles: Triangles) -> tuple[Floats, float]:
    """Return the rotation that puts the model on its feet, and by how much it wins."""
    x, y, z = np.eye(3)
    candidates = [np.array(rows) for rows in ((x, y, z), (x, z, -y), (x, -z, y), (x, -y, -z), (-z, y, x), (z, y, -x))]
    scores = np.array([stability(vertices @ turn.T, triangles) for turn in candidates])
    scores[0] += UP_PRIOR
    best = int(scores.argmax())
    return candidates[best], float(scores[best] - np.delete(scores, best).max() + 0.2)


def _front(vertices: Floats, triangles: Triangles) -> tuple[Floats, float]:
    """Return the yaw (as a matrix) that brings the front to -Y, and how clear the cues are."""
    points, areas = _samples(vertices, triangles)
    lopsided = [_asymmetry(points, areas, axis) for axis in (0, 1)]
    sideways = lopsided[0] - lopsided[1] > MIRROR_MARGIN  # its left and right are along Y
    axis = 0 if sideways else 1
    rise = _rise(np.r_[vertices, points], axis)
    back = np.sign(rise) if abs(rise) > BACK_RISE else 1.0
    quarter = {(1, 1.0): 0, (1, -1.0): 2, (0, 1.0): 1, (0, -1.0): 3}[(axis, float(back))]
    angle = quarter * np.pi / 2
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]).round(12)
    return turn, 0.4 + abs(rise) + abs(lopsided[0] - lopsided[1])


def _rise(points: Floats, axis: int, slices: int = 8) -> float:
    """Return -1..1: how much higher the far end of an axis is than its near end, as with the back of a seat."""
    low, extent = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-9)
    which = np.clip(((points[:, axis] - low[axis]) / extent[axis] * slices).astype(int), 0, slices - 1)
    top = np.zeros(slices)
    np.maximum.at(top, which, (points[:, 2] - low[2]) / extent[2])
    top = np.where(top > 0, top, top.mean())
    return float(top[-3:].mean() - top[:3].mean())


def _samples(vertices: Floats, triangles: Triangles) -> tuple[Floats, Floats]:
    """Return points spread over the surface by area (a low-discrepancy sequence), and the area each stands for."""
    corners = vertices[triangles]
    _, areas = _centers(vertices, triangles)
    counts = np.ceil(SAMPLES * areas / areas.sum()).astype(int)
    which = np.repeat(np.arange(len(triangles)), counts)
    index = np.arange(len(which))
    first, second = (index * 0.7548776662466927) % 1, (index * 0.5698402909980532) % 1
    folded = first + second > 1
    first, second = np.where(folded, 1 - first, first), np.where(folded, 1 - second, second)
    weights = np.stack([1 - first - second, first, second], axis=1)
    return np.einsum("sk,skd->sd", weights, corners[which]), (areas / counts)[which]


def _asymmetry(points: Floats, areas: Floats, axis: int, cells: int = 9) -> float:
    """Return 0..1: how much of the surface finds no partner across the middle plane of an axis."""
    low, extent = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-9)
    grid = np.clip(((points - low) / extent * cells).astype(int), 0, cells - 1)
    count = np.zeros((cells, cells, cells))
    np.add.at(count, tuple(grid.T), areas)
    return float(np.abs(count - np.flip(count, axis=axis)).sum() / (2 * count.sum()))


def _unit(largest: float) -> tuple[str, float]:
    """Return the unit under which the largest extent is likely; metres where they are."""
    for (name, metres), (least, most) in zip(UNITS, LIKELY, strict=False):
        if least <= largest * metres <= most:
            return name, metres
    return UNITS[0]


def unit_for(measured: float, wanted: float) -> tuple[str, float]:
    """Return the unit that brings a measured extent nearest to the wanted one in metres."""
    return min(UNITS, key=lambda unit: abs(np.log(max(measured * unit[1], 1e-9) / wanted)))
