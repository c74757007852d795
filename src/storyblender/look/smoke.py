"""Smoke, steam and dust as air: soft puffs that thin out what is behind them. Pure numpy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.look.raster import Image, dot
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Light

_THICK = 1.2
"""Optical depth through the middle of a lone puff."""
_TONE = 2.2
"""Luminance of thick smoke over that of the set around it."""
_ERF = np.float32(1.2025)
"""erf(x) is near tanh(1.2025 x), to two hundredths."""


@dataclass(frozen=True)
class Puff:
    """A ball of smoke, thickest in its middle.

    Attributes:
        center: World.
        radius: Metres at which it is almost gone.
        color: Scene-linear, of the smoke itself.
    """

    center: Vec3
    radius: float
    color: Color


def through_smoke(puffs: Sequence[Puff], depth: Image, rays: Image, eye: NDArray[np.float64]) -> Image:
    """Return the share, 0 to 1, of light that comes through the puffs before each pixel.

    The density of a puff falls off as a Gaussian, whose integral along a ray is an error function.

    Args:
        puffs: In the air.
        depth: (h, w) metres along the camera axis.
        rays: (h, w, 3) world, scaled to depth 1.
        eye: (3,) camera position.
    """
    length = np.sqrt(dot(rays, rays))
    way = np.minimum(depth, 1e4) * length
    thickness = np.zeros_like(way, dtype=np.float32)
    for puff in puffs:
        spread = np.float32(puff.radius / 2)
        toward = (np.asarray(puff.center) - eye).astype(np.float32)
        nearest = dot(rays, toward) / length
        aside = np.maximum(np.float32(toward @ toward) - nearest * nearest, 0)
        reach = _ERF / (np.float32(math.sqrt(2)) * spread)
        passed = (np.tanh((way - nearest) * reach) + np.tanh(nearest * reach)) / 2
        thickness += np.float32(_THICK) * np.exp(-aside / (2 * spread * spread)) * np.clip(passed, 0, 1)
    return np.exp(-thickness).astype(np.float32)


def add_smoke(
    picture: Image, puffs: Sequence[Puff], through: Image, lamps: Sequence[Light], set_luminance: float
) -> Image:
    """Veil a linear picture by what ``through_smoke`` says comes through; smoke has the colour of the light in it.

    Args:
        picture: (..., 3) linear.
        puffs: In the air.
        through: (...) from ``through_smoke``.
        lamps: Of the set.
        set_luminance: Mean luminance of the set.
    """
    if not puffs:
        return picture
    watts = sum(lamp.power for lamp in lamps)
    light = sum((lamp.power / watts * np.asarray(lamp.color) for lamp in lamps), np.zeros(3)) if watts else np.ones(3)
    own = np.mean([puff.color for puff in puffs], axis=0)
    color = (light * own / max(float((light * own).max()), 1e-3) * set_luminance * _TONE).astype(np.float32)
    return picture * through[..., None] + color * (1 - through[..., None])
