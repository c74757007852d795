"""Ground is never of one colour: it has damp, worn and grown places, metres wide, that no tile of a texture can hold.

They are laid over the light, which has few pixels, not over the albedo: next to nothing to work out.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from storyblender.look.gbuffer import GBuffer
from storyblender.look.raster import Image, noise

_SIZE = 256
"""Cells of the pattern along each side."""
_METRES = 20.0
"""Metres that the pattern covers before it repeats."""
_LEVEL = 0.8
"""Least upward part of a normal that is ground."""


def ground_patches(gbuffer: GBuffer, positions: Image) -> Image:
    """Return (h, w, 1) factors on the light, about 1: what patchy ground makes of it, 1 everywhere else.

    Args:
        gbuffer: At the size of the light.
        positions: (h, w, 3) world, metres.
    """
    factors = np.ones((*gbuffer.ids.shape, 1), np.float32)
    amount = gbuffer.patchy[gbuffer.material]
    at = np.flatnonzero((amount > 0) & (gbuffer.normal[..., 2] > _LEVEL))
    if len(at):
        cell = (positions[..., :2].reshape(-1, 2)[at] * (_SIZE / _METRES)).astype(np.int64) % _SIZE
        factors.flat[at] = 1 + amount.flat[at] * (3 * _pattern()[cell[:, 1], cell[:, 0]] - 1.5)
    return factors


@lru_cache(maxsize=1)
def _pattern() -> Image:
    return noise(_SIZE, 1.4, 11)
