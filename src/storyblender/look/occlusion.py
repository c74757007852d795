"""Ambient occlusion from depth: corners and contacts darken where the sky and the bounce cannot reach."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from storyblender.look.gbuffer import View
from storyblender.look.raster import Image, Window, blur

_RADIUS = 0.45
"""Metres over which neighbours count."""
_TAPS = 10
_GOLDEN = 2.399963
_STRENGTH = 1.9


def ambient_occlusion(depth: Image, view: View, positions: Image, normal: Image, window: Window | None = None) -> Image:
    """Return the open share, 0.15 to 1, of every pixel (spiral samples in screen space, measured in world space).

    Args:
        depth: (h, w) metres, at the resolution of the light.
        view: The camera, at this size.
        positions: (h, w, 3) world.
        normal: (h, w, 3) world, float32; of the window only.
        window: The part to work out; None is the whole picture.
    """
    height, width = depth.shape
    window = window or view.whole
    planes = [np.ascontiguousarray(positions[..., axis]) for axis in range(3)]
    here = [plane[window.cut] for plane in planes]
    facing = [np.ascontiguousarray(normal[..., axis]) for axis in range(3)]
    reach = np.clip(_RADIUS * view.pixels_per_metre / np.maximum(depth[window.cut], 0.1), 2, width * 0.06)
    rows = np.arange(window.top, window.bottom, dtype=np.float32)[:, None]
    columns = np.arange(window.left, window.right, dtype=np.float32)
    cosines, sines = _turns(height, width)
    across, down = cosines[window.cut] * reach, sines[window.cut] * reach
    shade = np.zeros(window.shape, np.float32)
    for tap in range(_TAPS):
        distance = math.sqrt((tap + 0.5) / _TAPS)
        cosine, sine = distance * math.cos(tap * _GOLDEN), distance * math.sin(tap * _GOLDEN)
        x = np.clip(columns + (across * cosine - down * sine), 0, width - 1).astype(np.int32)
        y = np.clip(rows + (down * cosine + across * sine), 0, height - 1).astype(np.int32)
        place = (y * width + x).astype(np.intp)
        toward = [plane.take(place) - start for plane, start in zip(planes, here, strict=True)]
        length = np.sqrt(sum(step * step for step in toward)) + 1e-4
        rise = sum(step * way for step, way in zip(toward, facing, strict=True)) / length
        shade += np.clip(rise - 0.12, 0, 1) * (length < _RADIUS * 1.6)
    return blur(np.clip(1 - _STRENGTH * shade / _TAPS, 0.15, 1), 1)


@cache
def _turns(height: int, width: int) -> tuple[Image, Image]:
    """Return (h, w) cosines and sines that turn each pixel's spiral: the same in every frame, so it cannot flicker."""
    turn = np.random.default_rng(1).random((height, width), np.float32) * np.float32(2 * np.pi)
    return np.cos(turn), np.sin(turn)
