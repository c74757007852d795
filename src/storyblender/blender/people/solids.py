"""Solid primitives for accessories and animal heads: ellipsoids, bars and lofted skins, as sheets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from storyblender.blender.people.sheet import Sheet, rigid_sheet
from storyblender.geometry import solids
from storyblender.geometry.solids import Floats


def skinned(rings: Sequence[ArrayLike], weights: Floats, *, caps: bool = True) -> Sheet:
    """Return a lofted sheet over cross-sections with the same number of points.

    Args:
        rings: k arrays of (n, 3) points, metres.
        weights: Bone weights, (35,) for the whole sheet or one row per point.
        caps: Whether to close both ends.
    """
    stack = np.asarray([np.asarray(ring, float) for ring in rings])
    count, around = stack.shape[:2]
    faces: list[tuple[int, ...]] = list(solids.skin_faces(count, around, True))
    if caps:
        faces += [tuple(range(around))[::-1], tuple(range((count - 1) * around, count * around))]
    points = stack.reshape(-1, 3)
    if solids.signed_volume(points, faces) < 0:
        faces = [face[::-1] for face in faces]
    return rigid_sheet(points, faces, weights)


def ball(
    center: ArrayLike, half: ArrayLike, weights: Floats, *, softness: float = 1.0, rotation: ArrayLike = (0, 0, 0)
) -> Sheet:
    """Return a superellipsoid.

    Args:
        center: (3,) metres.
        half: Semi-axes, (3,) metres.
        weights: (35,) of all its vertices.
        softness: 1 is an ellipsoid, 0.3 a cushion.
        rotation: Degrees about X, then Y, then Z.
    """
    matrix = solids.transform(center, rotation, 1.0)
    rings = solids.superellipsoid_rings(np.asarray(half, float), softness, 18, 10)
    return skinned([ring @ matrix[:3, :3].T + matrix[:3, 3] for ring in rings], weights)


def bar(points: ArrayLike, radius: float | Sequence[float], weights: Floats, *, closed: bool = False) -> Sheet:
    """Return a round bar along a path.

    Args:
        points: (N, 3) metres.
        radius: Metres, one value or one per point.
        weights: (35,) of all its vertices.
        closed: Whether the path is a ring.
    """
    rings = solids.tube_rings(np.asarray(points, float), radius, 8, closed)
    if not closed:
        return skinned(rings, weights)
    return skinned([*rings, rings[0]], weights, caps=False)
