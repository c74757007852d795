"""What keeps people alive between their cues: when eyes blink, glance and shift, and where a look goes."""

from __future__ import annotations

import math

import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.motion.channel import clamp

HORIZON = 180.0
"""Seconds of blinks and glances made up in advance; no shot is longer."""


def angles_of(vector: Vector) -> tuple[float, float]:
    """Return yaw and pitch in degrees of a direction, seen by somebody who faces -Y.

    The yaw fades out towards the zenith, where it would spin.
    """
    level = math.hypot(vector.x, vector.y)
    steady = clamp(2.5 * level / max(1e-6, vector.length))
    return steady * math.degrees(math.atan2(vector.x, -vector.y)), math.degrees(math.atan2(vector.z, level))


def moments_of(rng: np.random.Generator, first: float, shortest: float, longest: float) -> list[float]:
    """Return seconds at which something happens again and again.

    Args:
        rng: For the gaps.
        first: Second.
        shortest: Gap in seconds.
        longest: Gap in seconds.
    """
    gaps: NDArray[np.float64] = rng.uniform(shortest, longest, int(HORIZON / shortest))
    return [first, *(first + np.cumsum(gaps)).tolist()]
