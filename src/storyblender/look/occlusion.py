"""Ambient occlusion from depth: corners and contacts darken where the sky and the bounce cannot reach."""

from __future__ import annotations

import numpy as np

from storyblender.look.gbuffer import View
from storyblender.look.raster import Image, blur

_RADIUS = 0.45
"""Metres over which neighbours count."""
_TAPS = 10
_GOLDEN = 2.399963
_STRENGTH = 1.9


def ambient_occlusion(depth: Image, view: View, positions: Image, normal: Image) -> Image:
    """Return the open share, 0.15 to 1, of every pixel (spiral samples in screen space, measured in world space).

    Args:
        depth: (h, w) metres, at the resolution of the light.
        view: The camera, at this size.
        positions: (h, w, 3) world.
        normal: (h, w, 3) world, float32.
    """
    height, width = depth.shape
    reach = np.clip(_RADIUS * view.pixels_per_metre / np.maximum(depth, 0.1), 2, width * 0.06)
    rows, columns = np.mgrid[0:height, 0:width].astype(np.float32)
    # A fixed seed: the grain is the same in every frame, so it cannot flicker.
    turn = np.random.default_rng(1).random((height, width), np.float32) * 2 * np.pi
    shade = np.zeros((height, width), np.float32)
    for tap in range(_TAPS):
        angle, distance = turn + tap * _GOLDEN, np.sqrt((tap + 0.5) / _TAPS) * reach
        x = np.clip(columns + distance * np.cos(angle), 0, width - 1).astype(np.int32)
        y = np.clip(rows + distance * np.sin(angle), 0, height - 1).astype(np.int32)
        toward = positions[y, x] - positions
        length = np.sqrt(np.einsum("hwc,hwc->hw", toward, toward)) + 1e-4
        rise = np.einsum("hwc,hwc->hw", toward, normal) / length
        shade += np.clip(rise - 0.12, 0, 1) * (length < _RADIUS * 1.6)
    return blur(np.clip(1 - _STRENGTH * shade / _TAPS, 0.15, 1), 1)
