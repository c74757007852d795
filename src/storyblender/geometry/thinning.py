"""Thins out a very fine surface quickly: points of one small cell of space become one point. Pure numpy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_GROWTH = 1.25
"""Factor by which cells grow until few enough faces are left."""


def thin_out(vertices: Floats, triangles: Ints, most: int) -> tuple[Ints, NDArray[np.bool_]]:
    """Return the vertex that stands for each vertex, and which triangles stay, so that about ``most`` do at most.

    Args:
        vertices: (n, 3).
        triangles: (m, 3) vertex indices.
        most: Triangles.
    """
    corners = vertices[triangles]
    area = (
        float(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()) / 2
    )
    cell = max(np.sqrt(2 * area / most), float(np.ptp(vertices, axis=0).max()) * 1e-6)
    while True:
        stand_in = _one_in_each_cell(vertices, cell)
        moved = stand_in[triangles]
        kept = (moved[:, 0] != moved[:, 1]) & (moved[:, 1] != moved[:, 2]) & (moved[:, 2] != moved[:, 0])
        if kept.sum() <= most:
            return stand_in, kept
        cell *= _GROWTH


def _one_in_each_cell(vertices: Floats, cell: float) -> Ints:
    """Return the index of the vertex nearest to the middle of those in the same cell, for each vertex."""
    x, y, z = ((vertices - vertices.min(axis=0)) / cell).astype(np.int64).T
    _, of = np.unique((x << 42) | (y << 21) | z, return_inverse=True)
    count = np.bincount(of)
    middle = np.stack([np.bincount(of, vertices[:, axis]) / count for axis in range(3)], axis=1)
    off = ((vertices - middle[of]) ** 2).sum(axis=1)
    order = np.lexsort((off, of))
    first = order[np.r_[True, of[order[1:]] != of[order[:-1]]]]
    return first[of]
