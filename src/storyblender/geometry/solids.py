"""Solid primitives as plain arrays: rings to skin, boxes with chamfers, texture layouts in metres."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Face = tuple[int, ...]

_OTHER_AXES = np.array([(1, 2), (0, 2), (0, 1)])
"""The two axes that a projection along each axis keeps."""


def translation(location: ArrayLike) -> Floats:
    """Return the (4, 4) matrix that moves by ``location``."""
    matrix = np.eye(4)
    matrix[:3, 3] = location
    return matrix


def transform(location: ArrayLike, rotation: ArrayLike, scale: float | ArrayLike) -> Floats:
    """Return the (4, 4) matrix that scales, then turns about X, Y, Z in this order, then moves.

    Args:
        location: (3,) metres.
        rotation: (3,) degrees about the fixed axes X, Y and Z.
        scale: One factor, or (3,) factors along x, y, z.
    """
    x, y, z = np.radians(np.asarray(rotation, float))
    about_x = np.array([[1, 0, 0], [0, math.cos(x), -math.sin(x)], [0, math.sin(x), math.cos(x)]])
    about_y = np.array([[math.cos(y), 0, math.sin(y)], [0, 1, 0], [-math.sin(y), 0, math.cos(y)]])
    about_z = np.array([[math.cos(z), -math.sin(z), 0], [math.sin(z), math.cos(z), 0], [0, 0, 1]])
    matrix = translation(location)
    matrix[:3, :3] = about_z @ about_y @ about_x @ np.diag(np.broadcast_to(np.asarray(scale, float), 3))
    return matrix


def z_to(axis: ArrayLike) -> Floats:
    """Return the (4, 4) smallest rotation that turns +Z to ``axis``."""
    goal = np.asarray(axis, float) / np.linalg.norm(axis)
    matrix = np.eye(4)
    if goal[2] < -0.999999:
        matrix[:3, :3] = np.diag([1.0, -1.0, -1.0])
        return matrix
    v = np.cross((0.0, 0.0, 1.0), goal)
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    matrix[:3, :3] = np.eye(3) + cross + cross @ cross / (1 + goal[2])
    return matrix


def box(size: ArrayLike, bevel: float = 0.0) -> tuple[Floats, list[Face]]:
    """Return vertices and outward faces of a box about the origin.

    Args:
        size: (3,) full extents along x, y, z, metres.
        bevel: Metres that each edge is cut back on both its faces, as one chamfer; 0 leaves eight corners.
    """
    half = np.asarray(size, float) / 2
    signs = np.array(list(itertools.product((-1, 1), repeat=3)), float)
    corners = signs * half
    if bevel <= 1e-5:
        plain: list[Face] = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        return corners, plain
    vertices, faces = _chamfered(signs, half, bevel), _chamfered_faces()
    return vertices, list(faces) if bevel < half.min() else [_outward(vertices, face) for face in faces]


def _chamfered(signs: Floats, half: Floats, bevel: float) -> Floats:
    """Return the vertices of a chamfered box: three of each corner, one on each face it touches (3 * corner + axis)."""
    inward = np.repeat(-signs * bevel, 3, axis=0)
    inward[np.arange(24), np.tile(np.arange(3), 8)] = 0
    return np.repeat(signs * half, 3, axis=0) + inward


@cache
def _chamfered_faces() -> tuple[Face, ...]:
    """Return the faces of a chamfered box, outwards: the same for every box that its chamfers leave a face of."""
    signs = np.array(list(itertools.product((-1, 1), repeat=3)), float)
    flat: list[Face] = []
    for axis, face in enumerate(((0, 1, 3, 2), (0, 4, 5, 1), (0, 2, 6, 4))):
        flat.append(tuple(3 * corner + axis for corner in face))
        other = tuple(3 * (corner | (4 >> axis)) + axis for corner in face)
        flat.append(other[::-1])
    for a in range(8):
        for axis in range(3):
            b = a | (4 >> axis)
            if a != b:
                first, second = [other for other in range(3) if other != axis]
                flat.append((3 * a + first, 3 * b + first, 3 * b + second, 3 * a + second))
        flat.append((3 * a, 3 * a + 1, 3 * a + 2))
    vertices = _chamfered(signs, np.full(3, 0.5), 0.1)
    return tuple(_outward(vertices, face) for face in flat)


def _outward(vertices: Floats, face: Face) -> Face:
    points = vertices[list(face)]
    normal = np.cross(points[1] - points[0], points[2] - points[1])
    return face if normal @ points.mean(axis=0) > 0 else face[::-1]


def rounded_box_rings(size: ArrayLike, radius: float, steps: int) -> list[Floats]:
    """Return cross-sections, bottom to top, of a box with round edges about the origin.

    Args:
        size: (3,) full extents along x, y, z, metres.
        radius: Metres of the edges' quarter circles, less than half the smallest extent.
        steps: Segments of each quarter circle.
    """
    half = np.asarray(size, float) / 2
    core = half - radius
    steep = math.radians(80)  # the last ring before the flat cap: a full quarter would collapse its corners
    angles = np.linspace(0, steep, steps + 1)
    turns = np.concatenate([np.linspace(q, q + 1, steps + 1) * math.pi / 2 for q in range(4)])
    sign_x = np.repeat([1, -1, -1, 1], steps + 1)
    sign_y = np.repeat([1, 1, -1, -1], steps + 1)
    rings = []
    for side in (-1, 1):
        for angle in angles[::side]:
            reach = radius * math.cos(angle)
            x = sign_x * core[0] + reach * np.cos(turns)
            y = sign_y * core[1] + reach * np.sin(turns)
            z = side * (core[2] + radius * math.sin(angle) / math.sin(steep))
            rings.append(np.c_[x, y, np.full(len(x), z)])
    return rings


def superellipsoid_rings(half: ArrayLike, exponent: float, segments: int, rings: int) -> list[Floats]:
    """Return ``rings`` + 1 cross-sections, bottom to top, of a superellipsoid about the origin.

    Args:
        half: (3,) semi-axes, metres.
        exponent: 1 is an ellipsoid, 0 a box.
        segments: Points of each cross-section.
        rings: Bands between the cross-sections.
    """
    semi = np.asarray(half, float)

    def power(values: ArrayLike) -> Floats:
        value = np.asarray(values, float)
        return np.sign(value) * np.abs(value) ** exponent

    around = np.arange(segments) * (2 * math.pi / segments)
    sections = []
    for elevation in np.linspace(-math.pi / 2, math.pi / 2, rings + 1):
        reach = max(float(power(abs(math.cos(elevation)))), 1e-3) if abs(elevation) < 1.5707 else 1e-3
        height = float(power(math.sin(elevation)))
        sections.append(
            np.c_[
                semi[0] * reach * power(np.cos(around)),
                semi[1] * reach * power(np.sin(around)),
                np.full(segments, semi[2] * height),
            ]
        )
    return sections


def tube_rings(points: ArrayLike, radius: float | Sequence[float], segments: int, closed: bool) -> list[Floats]:
    """Return circular sections along a path, mitred at its bends, carried along without twist.

    Args:
        points: (n, 3) path, metres; neighbours must differ.
        radius: Metres; or one per point.
        segments: Points of each section.
        closed: Join the last point to the first; the first section is then repeated at the end.
    """
    path = np.asarray(points, float)
    count = len(path)
    radii = np.broadcast_to(np.asarray(radius, float), count)
    ahead = np.roll(path, -1, axis=0) - path
    behind = path - np.roll(path, 1, axis=0)
    if not closed:
        ahead[-1], behind[0] = behind[-1], ahead[0]
    ahead = ahead / np.linalg.norm(ahead, axis=1, keepdims=True)
    behind = behind / np.linalg.norm(behind, axis=1, keepdims=True)
    tangent = ahead + behind
    tangent = tangent / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    side = np.cross(tangent[0], np.eye(3)[np.abs(tangent[0]).argmin()])
    around = np.arange(segments) * (2 * math.pi / segments)
    rings = []
    for place, direction, before, reach in zip(path, tangent, behind, radii, strict=True):
        side = side - direction * (side @ direction)
        side = side / np.linalg.norm(side)
        third = np.cross(direction, side)
        ring = np.cos(around)[:, None] * side + np.sin(around)[:, None] * third
        bend = np.cross(before, direction)
        length = float(np.linalg.norm(bend))
        if 1e-6 < length < 0.9:  # widen across the bend, so that the bar keeps its thickness in the mitre
            across = np.cross(direction, bend / length)
            ring = ring + np.outer(ring @ across, across) * (1 / math.sqrt(1 - length**2) - 1)
        rings.append(place + reach * ring)
    if closed:
        rings.append(rings[0])
    return rings


def skin_faces(rings: int, points: int, closed: bool) -> list[Face]:
    """Return the quads between consecutive sections; corner indices count the points section by section.

    Args:
        rings: Number of sections.
        points: Points of each section.
        closed: The sections are loops.
    """
    width = points if closed else points - 1
    return [
        (i * points + j, i * points + (j + 1) % points, (i + 1) * points + (j + 1) % points, (i + 1) * points + j)
        for i in range(rings - 1)
        for j in range(width)
    ]


def skin_uv(stack: Floats, closed: bool, tile: float, grain: bool) -> Floats:
    """Return (corners, 2) metres for ``skin_faces``, with whole tiles around a loop.

    Args:
        stack: (k, n, 3) sections.
        closed: The sections are loops.
        tile: Metres of one texture repeat.
        grain: Lay u along the path of the sections (wood, bark), instead of around it (brick).
    """
    around = np.roll(stack, -1, axis=1) - stack
    steps = np.linalg.norm(around, axis=2).mean(axis=0)
    across = np.r_[0.0, np.cumsum(steps)]
    if closed and across[-1] > 0:
        across = across * (max(1.0, round(across[-1] / tile)) * tile / across[-1])
    along = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(stack, axis=0), axis=2).mean(axis=1))]
    width = stack.shape[1] if closed else stack.shape[1] - 1
    i, j = np.meshgrid(np.arange(len(stack) - 1), np.arange(width), indexing="ij")
    corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
    layout = np.stack([np.stack([along[a], across[b]], -1) for a, b in corners], axis=2).reshape(-1, 2)
    return layout if grain else layout[:, ::-1]


def box_uv(vertices: Floats, faces: Sequence[Sequence[int]], grain: bool) -> Floats:
    """Return (corners, 2) metres, each face projected along the axis it faces most.

    Args:
        vertices: (n, 3) in the part's own frame.
        faces: Corner indices.
        grain: Lay u along the longer side of each face (wood), instead of along the horizontal (brick).
    """
    sizes = np.array([len(face) for face in faces], int)
    starts = np.cumsum(sizes) - sizes
    layout = np.zeros((int(sizes.sum()), 2))
    for size in {len(face) for face in faces}:  # all quads at once, all triangles at once
        these = np.flatnonzero(sizes == size)
        points = vertices[np.array([faces[index] for index in these])]
        after = np.concatenate((points[:, 1:], points[:, :1]), axis=1)
        (x, y, z), (after_x, after_y, after_z) = points.transpose(2, 0, 1), after.transpose(2, 0, 1)
        crosses = np.stack((y * after_z - z * after_y, z * after_x - x * after_z, x * after_y - y * after_x))
        axis = np.abs(crosses.sum(axis=2)).argmax(axis=0)
        flat = np.take_along_axis(points, _OTHER_AXES[axis][:, None, :], axis=2)
        if grain:
            spans = flat.max(axis=1) - flat.min(axis=1)
            tall = spans[:, 1] > spans[:, 0]
            flat[tall] = flat[tall][:, :, ::-1]
        layout[starts[these][:, None] + np.arange(size)] = flat
    return layout


def signed_volume(vertices: Floats, faces: Sequence[Sequence[int]]) -> float:
    """Return the volume about the centroid, in cubes of the vertices' unit; negative if the faces point inwards.

    Args:
        vertices: (n, 3).
        faces: Corner indices of each face, in order around it.
    """
    centred = vertices - vertices.mean(axis=0)
    fans = np.array([(face[0], a, b) for face in faces for a, b in itertools.pairwise(face[1:])])
    first, second, third = (centred[fans[:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->", first, np.cross(second, third))) / 6
