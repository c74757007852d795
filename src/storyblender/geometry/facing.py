"""Finds which side of an upright thing is its front, by its proportions and by the side that is flat. Pure numpy.

What stands against a wall has a flat back, and doors, drawers, handles, a hearth or a hollow before it. What is as long
as it should be wide stands across. The result is a turn by quarters; what tells nothing stays as it is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from storyblender.memory.base import Vec3

Floats = NDArray[np.float64]

_LONGER = 1.3
"""Ratio of width and depth, or depth and width, from which it says which way a thing stands."""
_HOLLOWER = 0.015
"""Share of a thing's depth by which its front is hollower than its back, at least."""
_ROOF, _BEHIND = 0.7, 0.03
"""Share of a car's height from which all is roof, and how far it is behind the middle, as a share of the length."""
_CELLS, _SAMPLES = 24, 20_000


def crosswise(extent: Floats, usual: Vec3) -> bool:
    """Return whether a thing is clearly long where such things are wide, or the other way round.

    Args:
        extent: (3,) width, depth and height.
        usual: Width, depth and height of such a thing.
    """
    ratio, wanted = np.log(max(extent[0], 1e-9) / max(extent[1], 1e-9)), np.log(usual[0] / usual[1])
    return bool(abs(wanted) > np.log(_LONGER) and abs(ratio) > np.log(_LONGER) and ratio * wanted < 0)


def quarters_to_hollow_front(vertices: Floats, triangles: NDArray[np.int64], allowed: tuple[int, ...]) -> int:
    """Return by how many quarters a thing turns, counter-clockwise from above, so that its flat back is at +Y.

    Args:
        vertices: (n, 3) upright.
        triangles: (m, 3) vertex indices.
        allowed: Quarters among which is chosen; the first one stays unless another is clearly better.
    """
    points = _scattered(vertices, triangles)
    hollow = {side: _hollowness(points, *side) for side in ((0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0))}
    fronts = [(1, -1.0), (0, -1.0), (1, 1.0), (0, 1.0)]  # what is at the front after 0, 1, 2, 3 quarters
    gains = {each: hollow[fronts[each]] - hollow[fronts[(each + 2) % 4]] for each in allowed}
    best = max(gains, key=lambda each: gains[each])
    return best if gains[best] > max(_HOLLOWER, gains[allowed[0]] + _HOLLOWER) else allowed[0]


def drives_backwards(vertices: Floats, triangles: NDArray[np.int64]) -> bool:
    """Return whether a car has its roof before its middle: the bonnet is longer than the boot."""
    points = _scattered(vertices, triangles)
    low, extent = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-9)
    roof = points[points[:, 2] > low[2] + _ROOF * extent[2]]
    return bool((roof[:, 1].mean() - low[1]) / extent[1] - 0.5 < -_BEHIND)


def _scattered(vertices: Floats, triangles: NDArray[np.int64]) -> Floats:
    """Return points spread evenly over a surface."""
    corners = vertices[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    reach = np.cumsum(areas) / max(float(areas.sum()), 1e-30)
    chosen = corners[np.minimum(np.searchsorted(reach, (np.arange(_SAMPLES) + 0.5) / _SAMPLES), len(corners) - 1)]
    shares = np.random.default_rng(0).random((_SAMPLES, 2))
    shares = np.where(shares.sum(axis=1, keepdims=True) > 1, 1 - shares, shares)
    first, second, third = chosen.transpose(1, 0, 2)
    return first + shares[:, :1] * (second - first) + shares[:, 1:] * (third - first)


def _hollowness(points: Floats, axis: int, sign: float) -> float:
    """Return how far a side is behind its foremost point, on average over its outline, as a share of the depth."""
    low, extent = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-9)
    cells = np.minimum((points - low) / extent * _CELLS, _CELLS - 1).astype(np.int64)
    column, row = cells[:, 1 - axis], cells[:, 2]
    reach = (points[:, axis] - low[axis]) / extent[axis]
    reach = reach if sign > 0 else 1 - reach
    foremost = np.full(_CELLS * _CELLS, -np.inf)
    np.maximum.at(foremost, column * _CELLS + row, reach)
    return float(1 - foremost[np.isfinite(foremost)].mean())
