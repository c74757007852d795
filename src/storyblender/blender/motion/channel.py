"""Channels: values over time, made of timed targets.

A target may be a function of time, so a blend from "hand at my side" to "hand on a moving cup" is right at every frame.
A channel keeps its newest key: sitting and holding last until another key is set.
"""

from __future__ import annotations

import math
from bisect import insort
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
TargetOf = Callable[[float], Any]
"""A target that moves: seconds to values (an array, a tuple or a mathutils vector)."""
Target = ArrayLike | TargetOf
Easing = Callable[[float], float]

LONG_AGO = -1e9


def smooth(w: float) -> float:
    """Return the minimum-jerk easing of a share ``w`` in 0..1: the usual motion of limbs."""
    return w * w * w * (w * (6 * w - 15) + 10)


def smoothstep(w: float) -> float:
    """Return the cubic easing of a share ``w`` in 0..1: softer at the ends than linear, firmer than ``smooth``."""
    return w * w * (3 - 2 * w)


def ease_out(w: float) -> float:
    """Return an easing of a share ``w`` in 0..1 that is fast at first: strokes and blows."""
    return 1 - (1 - w) ** 3


def clamp(x: float, low: float = 0.0, high: float = 1.0) -> float:
    """Return ``x`` limited to ``low``..``high``."""
    return low if x < low else high if x > high else x


@dataclass(frozen=True)
class ChannelKey:
    """Blend to ``target`` from ``start`` on, in ``duration`` seconds.

    ``bump`` is added to the first three values along a half sine: a hand goes around, not through.
    """

    start: float
    duration: float
    target: Target
    ease: Easing = smooth
    bump: Floats | None = None

    def at(self, t: float) -> Floats:
        """Return the target's values at ``t`` seconds."""
        return np.asarray(self.target(t) if callable(self.target) else self.target, float)


def linear(a: Floats, b: Floats, w: float) -> Floats:
    """Return the linear blend of two arrays of one shape; ``w`` is the share of ``b``, 0..1."""
    return a * (1 - w) + b * w


class Channel:
    """One animated value, scalar or vector.

    Args:
        value: Value until the first key.
        mix: Blend of two values by the share (0..1) of the second; directions need more than ``linear``.
    """

    def __init__(self, value: Target, mix: Callable[[Floats, Floats, float], Floats] = linear) -> None:
        self.keys, self.mix = [ChannelKey(LONG_AGO, 0.0, value)], mix

    def set(
        self, start: float, duration: float, target: Target, ease: Easing = smooth, bump: ArrayLike | None = None
    ) -> float:
        """Add a key and return the second at which its target is reached.

        Args:
            start: Second at which the blend begins.
            duration: Seconds of the blend.
            target: Values to reach, or a function from seconds to them.
            ease: Maps the elapsed share of the blend, 0..1, to the share of the target.
            bump: (3,) added to the first three values along a half sine, so that a hand goes around something.
        """
        key = ChannelKey(start, duration, target, ease, None if bump is None else np.asarray(bump, float))
        insort(self.keys, key, key=lambda each: each.start)
        return start + duration

    def remove_from(self, start: float) -> None:
        """Remove the keys that start at ``start`` seconds or later."""
        self.keys = [key for key in self.keys if key.start < start - 1e-6] or self.keys[:1]

    def snapshot(self) -> Channel:
        """Return a copy with the present keys."""
        copy = Channel(0.0, self.mix)
        copy.keys = list(self.keys)
        return copy

    def __call__(self, t: float) -> Floats:
        """Return the values at ``t`` seconds: the newest finished key with every started key blended over it."""
        keys = self.keys
        done = len(keys) - 1
        while done and keys[done].start + keys[done].duration > t:
            done -= 1
        value = keys[done].at(t)
        for key in keys[done + 1 :]:
            if key.start >= t:
                break
            w = key.ease(clamp((t - key.start) / key.duration))
            value = self.mix(value, key.at(t), w)
            if key.bump is not None:
                value[:3] += key.bump * math.sin(math.pi * w)
        return value
