"""Graphite on paper: four soft tones, two directions of hatching, and the ink as pencil line (notes, section 7)."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from storyblender.look.raster import Image, blur, luminance, noise

_PAPER = np.array([0.985, 0.965, 0.925], np.float32)
_TONE_IN = (0.0, 0.12, 0.20, 0.34, 0.42, 0.62, 0.72, 1.0)
_TONE_OUT = (0.20, 0.27, 0.42, 0.52, 0.68, 0.78, 0.93, 1.0)
"""Soft steps: flat, rise, flat, rise."""
_KEY = 0.62
"""Display luminance that becomes bare paper in a frame of middle brightness."""
_NIGHT = 0.26
"""Mean display luminance below which the wash is lifted, so that a night stays a drawing and not a black sheet."""


def draw_pencil(display: Image, ink: Image, flesh: Image, strength: float) -> Image:
    """Return the drawing as a display picture.

    Args:
        display: (h, w, 3) the graded colour picture; only its brightness is used.
        ink: (h, w) darkness of the lines.
        flesh: (h, w) share of skin; faces are kept light.
        strength: Darkness of the line, 0 to 1.
    """
    height, width = ink.shape
    tone = blur(luminance(display), 1)
    key = _KEY * min(1.0, max(0.55, float(tone.mean()) / _NIGHT))
    tone = np.clip((tone - 0.05) / key, 0, 1) ** 0.8
    wash = np.interp(tone, _TONE_IN, _TONE_OUT).astype(np.float32)
    wash -= _hatching(wash)
    face = np.maximum(0.35 * wash + 0.65 * (0.62 + 0.36 * tone), 0.62) * _features(luminance(display), flesh)
    wash = wash * (1 - flesh) + face * flesh
    wash = np.clip(0.06 + 0.9 * wash + _grain(height, width), 0, 1)
    return wash[..., None] * _PAPER * (1 - strength * ink[..., None])


def _features(tone: Image, flesh: Image) -> Image:
    """Return how dark eyes, brows and lips are against the skin around them, 0.25 to 1: they outlast the lifting."""
    radius = max(2, round(9 * tone.shape[0] / 540))
    around = blur(tone * flesh, radius) / np.maximum(blur(flesh, radius), 1e-3)
    return np.clip(1.25 * tone / np.maximum(around, 1e-3) - 0.1, 0.25, 1)


def _hatching(wash: Image) -> Image:
    """Return the strokes: one direction in the shade, the other across it in the dark."""
    rows, columns = np.mgrid[0 : wash.shape[0], 0 : wash.shape[1]].astype(np.float32)
    pitch = 2 * np.pi / 7
    down = np.clip((np.sin((columns + rows) * pitch) - 0.3) * 4, 0, 1) * np.clip((0.6 - wash) * 12, 0, 1)
    across = np.clip((np.sin((columns - rows * 0.9) * pitch) - 0.35) * 4, 0, 1) * np.clip((0.4 - wash) * 12, 0, 1)
    return 0.07 * down + 0.06 * across


@lru_cache(maxsize=2)
def _grain(height: int, width: int) -> Image:
    size = 1 << (max(height, width) - 1).bit_length()
    return (noise(size, 0.6, 5)[:height, :width] - 0.5) * 0.07
