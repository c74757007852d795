"""Idle life between cues: random times of blinks, glances and weight shifts, and the angles of a gaze."""

from __future__ import annotations

import math

import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.motion.channel import clamp
from storyblender.blender.motion.skeleton import facing_yaw

HORIZON = 180.0
"""Seconds of blinks and glances generated in advance; no shot is longer."""


def angles_of(vector: Vector) -> tuple[float, float]:
    """Return yaw and pitch of a direction in degrees, relative to a person who faces -Y.

    Near the vertical, where yaw is undefined, it fades to 0.
    """
    level = math.hypot(vector.x, vector.y)
    steady = clamp(2.5 * level / max(1e-6, vector.length))
    return steady * math.degrees(facing_yaw(vector)), math.degrees(math.atan2(vector.z, level))


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
