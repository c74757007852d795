"""Where feet stand in a recorded motion: low and hardly moving, heel or ball."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.mocap import RATE
from storyblender.geometry.solids import Floats

_LOW_ANKLE, _LOW_TOE = 0.08, 0.06
"""Legs over where the ankle, or the ball of the foot, is when it stands."""
_SLOW: Final = 0.4
"""Legs a second."""
_LEAST: Final = 4
"""Poses of a contact, and most poses of a gap in one."""


def find_stands(ankles: Floats, toes: Floats) -> NDArray[np.bool_]:
    """Return in which poses (N, 2) each foot stands.

    Args:
        ankles: (N, 2, 3) in legs, Z up; left, right.
        toes: (N, 2, 3) the balls of the feet.
    """
    found = np.zeros(ankles.shape[:2], bool)
    for points, low in ((ankles, _LOW_ANKLE), (toes, _LOW_TOE)):
        floor = np.percentile(points[..., 2].min(axis=1), 5)
        steps = np.linalg.norm(np.diff(points[..., :2], axis=0), axis=-1) * RATE
        speeds = np.maximum(np.pad(steps, ((1, 0), (0, 0)), mode="edge"), np.pad(steps, ((0, 1), (0, 0)), mode="edge"))
        found |= (points[..., 2] - floor < low) & (speeds < _SLOW)
    for side in (0, 1):
        for wanted in (False, True):  # gaps first
            for start, end in runs_of(found[:, side] == wanted):
                inside = start > 0 and end < len(found)
                if end - start < _LEAST and (wanted or inside):
                    found[start:end, side] = not wanted
    return found


def runs_of(flags: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and the one-past-last index of each run of true flags (N,)."""
    edges = np.flatnonzero(np.diff(np.r_[0, flags.astype(int), 0]))
    return [(int(start), int(end)) for start, end in zip(edges[::2], edges[1::2], strict=True)]
