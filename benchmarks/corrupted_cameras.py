"""Accepted cameras corrupted by seed: orbited, panned, zoomed, raised, rolled, or all of it at once. Pure numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np

from storyblender.geometry.orbit import Orbit, dolly, orbit, pan, roll


def _orbited(camera: Orbit, rng: np.random.Generator) -> Orbit:
    """Go 30 to 75 degrees around the subject: 2 to 5 of the paper's steps."""
    return orbit(camera, _either_way(rng, 30.0, 75.0))


def _panned(camera: Orbit, rng: np.random.Generator) -> Orbit:
    """Shift the camera by 0.25 to 0.6 heights of the picture, any way: 3 to 8 steps."""
    angle, by = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(0.25, 0.6))
    return pan(camera, by * math.cos(angle), by * math.sin(angle))


def _zoomed(camera: Orbit, rng: np.random.Generator) -> Orbit:
    """Go 3 to 7 steps nearer or farther: to between 0.4 and 2.7 of the distance."""
    return dolly(camera, _either_way(rng, 3.0, 7.0))


def _raised(camera: Orbit, rng: np.random.Generator) -> Orbit:
    """Go 20 to 45 degrees up around the subject, 85 at most: 2 to 5 steps."""
    return orbit(camera, 0.0, float(rng.uniform(20.0, 45.0)))


def _rolled(camera: Orbit, rng: np.random.Generator) -> Orbit:
    """Lean the horizon by 8 to 24 degrees: 2 to 6 steps."""
    return roll(camera, _either_way(rng, 8.0, 24.0))


def _all_at_once(camera: Orbit, rng: np.random.Generator) -> Orbit:
    """Do all five, one after the other."""
    for change in (_orbited, _panned, _zoomed, _raised, _rolled):
        camera = change(camera, rng)
    return camera


CORRUPTIONS: Mapping[str, Callable[[Orbit, np.random.Generator], Orbit]] = {
    "orbited": _orbited, "panned": _panned, "zoomed": _zoomed, "raised": _raised, "rolled": _rolled,
    "all at once": _all_at_once,
}  # fmt: skip


def corrupted_camera(camera: Orbit, kind: str, seed: int) -> Orbit:
    """Return a camera with one kind of corruption; its lens and film stay.

    Args:
        camera: An accepted camera.
        kind: A key of ``CORRUPTIONS``.
        seed: Of what is drawn.
    """
    return CORRUPTIONS[kind](camera, np.random.default_rng((seed, [*CORRUPTIONS].index(kind))))


def _either_way(rng: np.random.Generator, least: float, most: float) -> float:
    return float(rng.choice((-1, 1)) * rng.uniform(least, most))
