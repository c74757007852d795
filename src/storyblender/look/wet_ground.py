"""Wet ground and still water: the picture mirrored in the plane of the ground, brighter at a glance, in puddles.

Works on the picture alone: every pixel above the ground is thrown to where its mirror image would be seen. What is
not in the frame is not mirrored; the sky stands in for it.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import GBuffer
from storyblender.look.illumination import sky_light
from storyblender.look.raster import Image, blur_rows, every, noise
from storyblender.look.surface import Surface
from storyblender.memory.scene_context import Lighting, Sky

_STRENGTH = 0.6
"""Of a perfect mirror at a glancing angle; more reads as glass (notes: sets and light, 1.8)."""
_STEP = 2
"""Mirrored at half size: water blurs anyway."""
_SMEAR = (2, 6)
"""Rows over which ripples draw the image out, at 270 rows."""
_PUDDLE_METRES = 14.0


def wetness(plan: Lighting, roofed: float) -> float:
    """Return how wet the ground is, 0 to 1: by rain; a little on clear nights too, as streets are hosed for film.

    Args:
        plan: Light plan: its rain, and its ``set_luminance``, which is low at night.
        roofed: 0 under the open sky to 1 in a closed room.
    """
    if plan.rain > 0:
        return min(1.0, 0.55 + 0.45 * plan.rain)
    return 0.35 * (1 - roofed) * float(np.clip((0.06 - plan.set_luminance) / 0.03, 0, 1))


def add_wet_ground(picture: Image, gbuffer: GBuffer, sky: Sky, wet: float, *, water: bool) -> Image:
    """Mirror the picture in the surfaces that can be wet.

    Args:
        picture: (h, w, 3) linear, with its air.
        gbuffer: At the picture's size; the size is even.
        sky: What is mirrored where the frame shows nothing.
        wet: 0 dry to 1.
        water: Mirror in what is smooth by itself too; path-traced light has done so already.
    """
    can_be = gbuffer.surface == Surface.WET
    smooth = np.clip(1.3 - gbuffer.roughness / 0.25, 0, 1)[gbuffer.material] * can_be
    amount = np.where(smooth > 0, smooth * water, np.float32(wet) * can_be * _puddles(gbuffer))
    if not amount.any():
        return picture
    low = gbuffer.reduced(_STEP)
    positions = low.positions()
    low_wet = low.surface == Surface.WET
    level = float(np.median(positions[..., 2][low_wet])) if low_wet.any() else 0.0
    mirrored = _mirror(every(picture, _STEP), low, positions, level, low_wet, sky)
    mirrored = np.repeat(np.repeat(mirrored, _STEP, axis=0), _STEP, axis=1)
    rays = gbuffer.view.rays()
    glance = 1 - np.abs(rays[..., 2]) / np.linalg.norm(rays, axis=2)
    share = _STRENGTH * (0.05 + 0.95 * glance**4) * amount
    return picture * (1 - 0.7 * share[..., None]) + mirrored * share[..., None]


def _mirror(
    picture: Image, gbuffer: GBuffer, positions: Image, level: float, wet: NDArray[np.bool_], sky: Sky
) -> Image:
    """Return what a mirror at the height ``level`` would show, drawn out downwards."""
    height, width = wet.shape
    above = ~gbuffer.sky & ~wet & (positions[..., 2] > level + 0.02)
    image = positions[above] * np.array([1, 1, -1], np.float32) + np.array([0, 0, 2 * level], np.float32)
    column, row, depth = gbuffer.view.project(image)
    x, y = np.floor(column).astype(np.int64), np.floor(row).astype(np.int64)
    seen = (depth > 0.05) & (x >= 0) & (x < width) & (y >= 0) & (y < height)
    # Written from far to near, so that the nearest stays.
    order = np.argsort(-depth[seen], kind="stable")
    color = np.zeros_like(picture)
    weight = np.zeros((height, width, 1), np.float32)
    color[y[seen][order], x[seen][order]] = picture[above][seen][order]
    weight[y[seen][order], x[seen][order]] = 1
    color, weight = color * wet[..., None], weight * wet[..., None]
    for radius in _SMEAR:
        rows = max(1, round(radius * height / 270))
        color, weight = (color + blur_rows(color, rows)) / 2, (weight + blur_rows(weight, rows)) / 2
    cover = np.clip(weight * 2.5, 0, 1)
    open_sky = sky_light(sky, gbuffer.view.rays() * np.array([1, 1, -1], np.float32))
    return color / np.maximum(weight, 1e-3) * cover + open_sky * (1 - cover)


def _puddles(gbuffer: GBuffer) -> Image:
    """Return 0.25 (damp) to 1 (standing water), fixed to the ground."""
    pattern, positions = _pattern(), gbuffer.positions()
    size = pattern.shape[0]
    x, y = (
        np.mod(np.clip(positions[..., axis], -1e3, 1e3) * (size / _PUDDLE_METRES), size).astype(np.int32) % size
        for axis in (0, 1)
    )
    return np.clip((pattern[y, x] - 0.36) * 5, 0.25, 1)


@lru_cache(maxsize=1)
def _pattern() -> Image:
    return noise(256, 1.7, 9)
