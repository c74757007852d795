"""Fine relief on surfaces: light that was worked out on smooth ones, as the normals in a normal map would have it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from storyblender.look.gbuffer import GBuffer
from storyblender.look.illumination import light_field
from storyblender.look.raster import LUMA, Image, luminance, shrink
from storyblender.memory.scene_context import Light

_FROM_ABOVE = 0.3
"""How much more of the light from all sides comes from above than from the side."""
_STRENGTH = 0.5
"""Lamps have a size and light comes back from everywhere, which softens relief (held against Cycles)."""
_DARKEST, _LIGHTEST = 0.35, 1.9


def emboss(light: Image, gbuffer: GBuffer, lamps: Sequence[Light]) -> None:
    """Give surfaces with a normal map the relief that these lamps show of it, in place.

    Args:
        light: (h, w, 3) illumination of the smooth surfaces.
        gbuffer: Its height and width multiples of h and w.
        lamps: All of the frame; what stands between them and the surface is in ``light`` already.
    """
    if gbuffer.relief is None:
        return
    step = gbuffer.view.height // light.shape[0]
    shown = shrink(gbuffer.relief.astype(np.float32), step)
    rows, columns = np.nonzero(np.linalg.norm(shown, axis=-1) > 0.5)
    if not len(rows):
        return
    rough = _unit(shown[rows, columns])
    sampled = rows * step + step // 2, columns * step + step // 2
    smooth = _unit(gbuffer.normal[sampled].astype(np.float32))
    x, y = gbuffer.view.slopes()
    rays = np.stack([x[sampled[1]], y[sampled[0]], np.full(len(rows), -1, np.float32)], axis=1)
    places = (rays * gbuffer.depth[sampled][:, None]) @ gbuffer.view.axes.T + gbuffer.view.eye
    told, plain = (_given(lamps, places.astype(np.float32), normal) for normal in (rough, smooth))
    whole = luminance(light[rows, columns])
    around = np.maximum(whole - plain, 0)
    more = told - plain + around * (_FROM_ABOVE * (rough[:, 2] - smooth[:, 2]))
    # Less light than the lamps give means a shadow, which takes the same share of the relief.
    form = 1 + _STRENGTH * more / np.maximum(np.maximum(whole, plain), 1e-6)
    light[rows, columns] *= np.clip(form, _DARKEST, _LIGHTEST)[:, None]


def _given(lamps: Sequence[Light], places: Image, normal: Image) -> Image:
    """Return the (n,) luminance that lamps give to (n, 3) places with these normals, nothing in between."""
    total = np.zeros(len(places), np.float32)
    for lamp in lamps:
        amount = light_field(lamp, places[None], normal[None]).amount[0]
        total += amount * np.float32(LUMA @ np.asarray(lamp.color, np.float32))
    return total


def _unit(vectors: Image) -> Image:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-6)
