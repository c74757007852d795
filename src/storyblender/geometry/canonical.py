"""Finds the upright rotation of an imported model. Pure numpy.

The paper's Asset Formatter asks a vision model, which decides where a language crew has one. A file format says most of
it as well: glTF and Blender know up and front and are in metres, so their pose and size are kept as long as they are
plausible. An .obj says nothing, and is tipped up only where it could not stand as it is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from storyblender.memory.asset_sheet import ModelPose
from storyblender.memory.base import Vec3

Floats = NDArray[np.float64]
Triangles = NDArray[np.int64]

_WAYS = {
    "front": np.array([0.0, -1.0, 0.0]),
    "back": np.array([0.0, 1.0, 0.0]),
    "left": np.array([-1.0, 0.0, 0.0]),
    "right": np.array([1.0, 0.0, 0.0]),
    "top": np.array([0.0, 0.0, 1.0]),
    "bottom": np.array([0.0, 0.0, -1.0]),
}
"""Where the sides of a model point to."""
UPRIGHT_MARGIN = 2.1
"""Least difference of ``measure_stability`` by which another up axis must beat the file's own."""


def find_upright_rotation(vertices: Floats, triangles: Triangles) -> Floats:
    """Return the (3, 3) rotation that stands a model upright; the identity unless it would fall over as it is.

    Args:
        vertices: (n, 3), Z up as its importer gives it.
        triangles: (m, 3) vertex indices.
    """
    x, y, z = np.eye(3)
    candidates = [np.array(rows) for rows in ((x, y, z), (x, z, -y), (x, -z, y), (x, -y, -z), (-z, y, x), (z, y, -x))]
    scores = np.array([measure_stability(vertices @ turn.T, triangles) for turn in candidates])
    best = int(scores.argmax())
    return candidates[best] if scores[best] > scores[0] + UPRIGHT_MARGIN else candidates[0]


TIPS = tuple(np.linalg.matrix_power(np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]), turns) for turns in (0, 1, 3, 2))
"""Ways to stand a model up by tipping it: as it is, as if it were Z up already, and their opposites."""
_PROPORTION_MARGIN, _LIKE = 0.5, 0.45
"""By how much another way up must fit the usual proportions better, and how well at least, to be taken."""


_STEADIER = 0.3
"""By how much a model must stand better on its head, by ``measure_stability``."""


def find_likely_tip(vertices: Floats, triangles: Triangles, usual: Vec3) -> Floats | None:
    """Return the (3, 3) rotation that stands a model up in the usual proportions of such a thing.

    Args:
        vertices: (n, 3), Z up as its importer gives it.
        triangles: (m, 3) vertex indices.
        usual: Width, depth and height of such a thing, in any unit.

    Returns:
        None if it has them as it is, or in no way, so that they say nothing.
    """
    errors = [proportion_error(np.ptp(vertices @ turn.T, axis=0), usual) for turn in TIPS]
    if min(errors) > _LIKE or errors[0] - min(errors) < _PROPORTION_MARGIN:
        return None
    first, *others = [turn for turn, error in zip(TIPS, errors, strict=True) if error < min(errors) + 1e-6]
    stands = measure_stability(vertices @ first.T, triangles) + _STEADIER
    return next((turn for turn in others if measure_stability(vertices @ turn.T, triangles) > stands), first)


def proportion_error(extent: Floats, usual: Vec3) -> float:
    """Return how much the proportions differ: mean of the logarithms' differences; width and depth may be exchanged."""
    usual_sides, sides = (np.log(np.maximum([*sorted(each[:2]), each[2]], 1e-9)) for each in (usual, extent))
    differences = sides - usual_sides
    return float(np.abs(differences - np.median(differences)).mean())


def rotation_of(pose: ModelPose) -> Floats:
    """Return the (3, 3) rotation that brings a model's own top up to +Z, and its front to -Y if it has one.

    Args:
        pose: With a top; one without a front is tipped by the shortest way.

    Raises:
        ValueError: The front is the top, or opposite it.
    """
    assert pose.top is not None, "the pose is decided"
    up = _WAYS[pose.top]
    front = _WAYS[pose.front] if pose.front is not None else np.array([0.0, -1.0, 0.0])
    if pose.front is None and front @ up:
        front = np.array([0.0, 0.0, up[1]])
    if front @ up:
        raise ValueError(f"the front of a model cannot be its {pose.front} when its {pose.top} is the top")
    return np.array([np.cross(-front, up), -front, up])


def measure_stability(vertices: Floats, triangles: Triangles) -> float:
    """Return how well the model stands when +Z is up, from -1 (falls over) to 2 (stable).

    The value is the share of its footprint under its support polygon, plus the depth of its mass inside that polygon.

    Args:
        vertices: (n, 3) with +Z up, in any unit.
        triangles: (m, 3) vertex indices.
    """
    low, extent = vertices.min(axis=0), np.maximum(np.ptp(vertices, axis=0), 1e-9)
    touching = vertices[vertices[:, 2] < low[2] + 0.02 * extent[2], :2]
    hull = convex_hull(touching)
    if len(hull) < 3:
        return 0.0
    share = polygon_area(hull) / (extent[0] * extent[1])
    centers, areas = _triangle_centres_and_areas(vertices, triangles)
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
    """Return the area of an (n, 2) polygon, in squares of its unit."""
    return abs(float(_cross(corners, np.roll(corners, -1, axis=0)).sum())) / 2


def _cross(a: Floats, b: Floats) -> Floats:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _depth_inside(hull: Floats, point: Floats) -> float:
    """Return the distance from a point to the hull's nearest edge; negative outside."""
    edges = np.roll(hull, -1, axis=0) - hull
    return float((_cross(edges, point - hull) / np.maximum(np.linalg.norm(edges, axis=1), 1e-12)).min())


def _triangle_centres_and_areas(vertices: Floats, triangles: Triangles) -> tuple[Floats, Floats]:
    corners = vertices[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return corners.mean(axis=1), np.maximum(np.linalg.norm(normal, axis=1) / 2, 1e-12)
