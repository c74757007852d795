"""Ambient occlusion from depth: corners and contacts darken where the sky and the bounce cannot reach."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import View
from storyblender.look.raster import Image, Window, blur, dot

_RADIUS = 0.45
"""Metres over which neighbours count."""
_TAPS = 10
_GOLDEN = 2.399963
_STRENGTH = 1.9


def ambient_occlusion(depth: Image, view: View, normal: Image, window: Window | None = None) -> Image:
    """Return the open share, 0.15 to 1, of every pixel (spiral samples in screen space, measured in metres).

    Args:
        depth: (h, w) metres, at the resolution of the light.
        view: The camera, at this size.
        normal: (h, w, 3) world, float32; of the window only.
        window: The part to work out; None is the whole picture.
    """
    height, width = depth.shape
    window = window or view.whole
    far, (aside, up) = depth[window.cut], view.slopes()
    x, y = aside[window.left : window.right] * far, up[window.top : window.bottom, None] * far
    right, upward, back = (dot(normal, axis) for axis in view.axes.T.astype(np.float32))
    reach = np.clip(_RADIUS * view.pixels_per_metre / np.maximum(far, 0.1), 2, width * 0.06)
    rows = np.arange(window.top, window.bottom, dtype=np.float32)[:, None]
    columns = np.arange(window.left, window.right, dtype=np.float32)
    cosines, sines = _turns(height, width)
    across, down = cosines[window.cut] * reach, sines[window.cut] * reach
    shade = np.zeros(window.shape, np.float32)
    for tap in range(_TAPS):
        distance = math.sqrt((tap + 0.5) / _TAPS)
        cosine, sine = distance * math.cos(tap * _GOLDEN), distance * math.sin(tap * _GOLDEN)
        column = _pixel(across * cosine - down * sine + columns, width)
        row = _pixel(down * cosine + across * sine + rows, height)
        # Gathering one depth and working its place out is twice as fast as gathering the place.
        there = depth.take((row * width + column).astype(np.intp))
        toward_x, toward_y, toward_z = _along(column, aside, there, x), _along(row, up, there, y), far - there
        length = np.sqrt(toward_x * toward_x + toward_y * toward_y + toward_z * toward_z) + np.float32(1e-4)
        rise = toward_x * right
        rise += toward_y * upward
        rise += toward_z * back
        rise /= length
        rise -= np.float32(0.12)
        np.maximum(rise, 0, out=rise)
        rise *= length < _RADIUS * 1.6
        shade += rise
    return blur(np.clip(1 - _STRENGTH * shade / _TAPS, 0.15, 1), 1)


def _along(pixels: Image, slopes: NDArray[np.float32], depth: Image, start: Image) -> Image:
    """Return how far each pixel's place lies along a side of the picture from where the ray starts, in ``pixels``."""
    pixels *= slopes[1] - slopes[0]
    pixels += slopes[0]
    pixels *= depth
    pixels -= start
    return pixels


def _pixel(place: Image, size: int) -> Image:
    """Return the whole number of the row or column that a place lies in, the outermost for what lies beyond."""
    np.maximum(place, 0, out=place)
    np.minimum(place, size - 1, out=place)
    return np.floor(place, out=place)


@cache
def _turns(height: int, width: int) -> tuple[Image, Image]:
    """Return (h, w) cosines and sines that turn each pixel's spiral: the same in every frame, so it cannot flicker."""
    turn = np.random.default_rng(1).random((height, width), np.float32) * np.float32(2 * np.pi)
    return np.cos(turn), np.sin(turn)
