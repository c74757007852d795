"""Bodies as capsules: penetration depth of two people, from the segments of their bones. Pure numpy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

BONE_RADII: dict[str, float] = {
    "hips": 0.07, "spine": 0.066, "chest": 0.07, "upper_chest": 0.07, "neck": 0.028, "head": 0.05,
    "thigh": 0.04, "shin": 0.027,
}  # fmt: skip
"""Radius of a bone capsule as a share of the stature, slightly thinner than the body; arms may touch: left out."""


def capsule_penetration(one: Floats, one_radii: Floats, other: Floats, other_radii: Floats) -> float:
    """Return the largest penetration depth of the capsules of two bodies in metres; 0 if they do not intersect.

    Args:
        one: (n, 2, 3) ends of the segments, world metres.
        one_radii: (n,) metres.
        other: (m, 2, 3) ends of the other's segments, world metres.
        other_radii: (m,) metres.
    """
    first, second = one[:, None], other[None]
    gap = _segment_distance(first[..., 0, :], first[..., 1, :], second[..., 0, :], second[..., 1, :])
    return float(max(0.0, (one_radii[:, None] + other_radii[None] - gap).max(initial=0.0)))


def _segment_distance(p: Floats, q: Floats, r: Floats, s: Floats) -> Floats:
    """Return the distances of the segments p-q and r-s, broadcast over their leading axes."""
    along, across, between = q - p, s - r, p - r
    a, e, f = (along**2).sum(-1), (across**2).sum(-1), (across * between).sum(-1)
    b, c = (along * across).sum(-1), (along * between).sum(-1)
    a, e = np.maximum(a, 1e-12), np.maximum(e, 1e-12)
    slope, flat = a * e - b * b, 1e-9 * a * e
    skew = slope > flat  # neither parallel nor a point
    first = np.clip(np.where(skew, (b * f - c * e) / np.where(skew, slope, 1.0), -c / a), 0.0, 1.0)
    second = (b * first + f) / e
    first = np.where(second < 0, np.clip(-c / a, 0, 1), np.where(second > 1, np.clip((b - c) / a, 0, 1), first))
    second = np.clip(second, 0.0, 1.0)
    away = between + along * first[..., None] - across * second[..., None]
    return np.sqrt((away**2).sum(-1))
