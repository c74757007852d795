"""Idle life between cues: random times of blinks, glances and weight shifts, and the angles of a gaze."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.motion.channel import clamp
from storyblender.blender.motion.skeleton import facing_yaw
from storyblender.catalog.motions import stressed_moment

Speech = tuple[float, float, float, float]
"""Start and end of a speech in seconds, how far it opens the mouth (0 to 1), and syllables a second."""
BLINK_SECONDS = 0.17
HORIZON = 180.0
"""Seconds of blinks and glances generated in advance; no shot is longer."""


def angles_of(vector: Vector) -> tuple[float, float]:
    """Return yaw and pitch of a direction in degrees, relative to a person who faces -Y.

    Near the vertical, where yaw is undefined, it fades to 0.
    """
    level = math.hypot(vector.x, vector.y)
    steady = clamp(2.5 * level / max(1e-6, vector.length))
    return steady * math.degrees(facing_yaw(vector)), math.degrees(math.atan2(vector.z, level))


def lid_at(t: float, blinks: Sequence[float], speeches: Sequence[Speech]) -> float:
    """Return how far blinks close the lids at ``t`` seconds, 0 to 1; none where a picture shows a speech.

    Args:
        t: Second of the shot.
        blinks: Seconds at which blinks begin.
        speeches: What the person says.
    """
    stressed = [stressed_moment(start, end) for start, end, _, _ in speeches]
    return max(
        (1.0 if 0.03 < t - start < 0.13 else 0.6
         for start in blinks
         if start <= t < start + BLINK_SECONDS and not any(start - 0.1 < each < start + 0.3 for each in stressed)),
        default=0.0,
    )  # fmt: skip


def mouth_at(t: float, speeches: Sequence[Speech]) -> float:
    """Return how far speech opens the mouth at ``t`` seconds, 0 to 1; widest where a picture shows it."""
    widest = 0.0
    for start, end, opening, rate in speeches:
        if start <= t < end:
            u = t - stressed_moment(start, end)
            syllable = abs(math.cos(math.pi * u * rate)) * (0.45 + 0.55 * abs(math.cos(1.7 * u)))
            widest = max(widest, opening * syllable * clamp(8 * (t - start)) * clamp(8 * (end - t)))
    return widest


def moments_of(rng: np.random.Generator, first: float, shortest: float, longest: float) -> list[float]:
    """Return the times in seconds of a recurring event with random gaps.

    Args:
        rng: Random generator for the gaps.
        first: Second of the first event.
        shortest: Shortest gap in seconds.
        longest: Longest gap in seconds.
    """
    gaps: NDArray[np.float64] = rng.uniform(shortest, longest, int(HORIZON / shortest))
    return [first, *(first + np.cumsum(gaps)).tolist()]
