"""Graphite on paper: a soft wash, two layers of drawn hatching, and the ink as pencil line (notes, section 7)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import GBuffer
from storyblender.look.raster import Image, blur, luminance, noise, shrink
from storyblender.look.surface import PERSON

_PAPER = np.array([0.985, 0.965, 0.925], np.float32)
_TONE_IN = (0.0, 0.10, 0.20, 0.32, 0.42, 0.60, 0.74, 0.95)
_TONE_OUT = (0.34, 0.41, 0.51, 0.58, 0.69, 0.80, 0.93, 1.0)
"""Soft steps: flat, rise, flat, rise. The darkest tone leaves room for a line: a sleeve is seen before a black coat."""
_SKIN_IN = (0.0, 0.08, 0.24, 0.42, 0.62, 0.85)
_SKIN_OUT = (0.40, 0.51, 0.72, 0.86, 0.97, 1.0)
"""Display luminance of skin to its tone: lighter than things as bright, so that a face is read by its features."""
_KEY, _MIDDLE = 0.62, 0.33
"""Display luminance that becomes bare paper, and the mean of the frame in which it does. It follows the root of the
mean: a night is lifted, so that it stays a drawing, but stays a night; a beach keeps a tone for its sand."""
_LEAST_KEY, _MOST_KEY = 0.46, 0.85
_ROWS = 540
_TILE = 512
_LEAST_SIZE = 0.6
"""Strokes are made for a picture 540 rows high and grow with it; smaller than this they would be but noise."""
_SLOPING, _LEVEL = 0.7, 0.9
"""Upward part of a normal from which a surface begins to be drawn as ground, and is."""
_PITCH = 5.0
"""Pixels between two strokes."""
_STROKE = 18
"""Length of a stroke over the pitch."""
_SHADE, _DEEP = 0.84, 0.52
"""Tones below which strokes are laid, and strokes across them."""
_GROUND = 1.02
"""The same on level ground: even a light one gets a few strokes, and so lies there instead of being left out."""
_WAVER = 1.6
"""Pixels by which a line may leave its way."""
_GRAPHITE = 0.90
"""Darkness of the hardest line, as a share of the strength asked for."""


@dataclass(frozen=True)
class _PencilPaper:
    """What does not depend on the picture: the tooth of the paper and the habits of the hand.

    Attributes:
        tooth: (h, w) roughness of the paper, -0.5 to 0.5.
        down: (h, w) how hard the shade must be before a stroke leaves graphite here; the first layer.
        across: The same of the layer across it.
        flat: The same of strokes that lie with the ground.
        pressure: (h, w) of the hand along lines, about 1.
        near: (4, h * w) the pixels a line's pixel is taken from: the hand wavers.
        weight: (4, h * w) how much of each.
    """

    tooth: Image
    down: Image
    across: Image
    flat: Image
    pressure: Image
    near: NDArray[np.int32]
    weight: NDArray[np.float32]


def draw_pencil(display: Image, ink: Image, flesh: Image, level: Image, strength: float) -> Image:
    """Return the drawing as a display picture.

    Args:
        display: (h, w, 3) the graded colour picture; only its brightness is used.
        ink: (h, w) darkness of the lines.
        flesh: (h, w) share of skin; faces are kept light.
        level: (h, w) share of level ground; its strokes lie with it.
        strength: Darkness of the line, 0 to 1.
    """
    sheet = _sheet(*ink.shape)
    seen = luminance(display)
    soft = blur(seen, 1)
    key = min(max(_KEY * math.sqrt(float(soft.mean()) / _MIDDLE), _LEAST_KEY), _MOST_KEY)
    tone = np.clip((soft - 0.05) / key, 0, 1) ** 0.8
    wash = np.interp(tone, _TONE_IN, _TONE_OUT).astype(np.float32)
    wash += (np.interp(soft, _SKIN_IN, _SKIN_OUT).astype(np.float32) - wash) * flesh
    wash *= _texture(seen)
    drawn = _hatched(wash, level, sheet) * (1 - flesh * (1 - _features(seen, flesh)))
    line = _GRAPHITE * strength * _by_hand(ink, sheet)
    return (np.clip(drawn, 0, 1) * (1 - line))[..., None] * _PAPER


def level_ground(gbuffer: GBuffer) -> Image:
    """Return (h, w) the share of level ground, 0 to 1: floors, sand, water, table tops; never people."""
    up = (gbuffer.normal[..., 2].astype(np.float32) - _SLOPING) / (_LEVEL - _SLOPING)
    return np.clip(up, 0, 1) * ~np.isin(gbuffer.surface, PERSON)


def _features(tone: Image, flesh: Image) -> Image:
    """Return how dark eyes, brows and lips are against the skin around them, 0.25 to 1: they outlast the lifting."""
    radius = max(1, round(9 * tone.shape[0] / _ROWS / 2))
    around = blur(shrink(tone * flesh, 2), radius) / np.maximum(blur(shrink(flesh, 2), radius), 1e-3)
    around = np.maximum(around, 1e-3).repeat(2, axis=0).repeat(2, axis=1)
    return np.clip(1.25 * tone / around - 0.1, 0.25, 1)


def _texture(seen: Image) -> Image:
    """Return how dark strands, folds and joints are against what is around them, 0.84 to 1: they outlast the key."""
    radius = max(1, round(3 * seen.shape[0] / _ROWS))
    around = np.maximum(blur(shrink(seen, 2), radius), 1e-2).repeat(2, axis=0).repeat(2, axis=1)
    return np.clip(1.6 * seen / around - 0.57, 0.84, 1)


def _hatched(wash: Image, level: Image, sheet: _PencilPaper) -> Image:
    """Return the wash with strokes in its shade, other strokes across them in its dark, and the tooth showing."""
    shade, down = _SHADE + (_GROUND - _SHADE) * level, sheet.down + (sheet.flat - sheet.down) * level
    first = np.clip((shade - wash) * 2.2, 0, 0.9) - down
    second = np.clip((_DEEP - wash) * 2.6, 0, 0.9) - sheet.across
    drawn = wash * (1 - (0.38 - 0.26 * wash) * np.clip(first * 4, 0, 1)) * (1 - 0.28 * np.clip(second * 4, 0, 1))
    drawn += 0.05 * (1 - wash)
    # Graphite catches on the tooth: most where the tone is between bare and full.
    drawn += sheet.tooth * (0.05 + 0.36 * wash * (1 - wash))
    return 0.04 + 0.94 * drawn


def _by_hand(ink: Image, sheet: _PencilPaper) -> Image:
    """Return the lines as a hand draws them: they waver, swell with the pressure and break on the tooth."""
    wavering = np.einsum("kn,kn->n", ink.ravel()[sheet.near], sheet.weight).reshape(ink.shape)
    return np.clip(wavering * sheet.pressure + 0.5 * sheet.tooth * wavering, 0, 1)


@lru_cache(maxsize=2)
def _sheet(height: int, width: int) -> _PencilPaper:
    """Return the sheet for pictures of this size; the same in every frame, so that a film does not boil."""
    size = max(height / _ROWS, _LEAST_SIZE)
    tile = noise(_TILE, 0.6, 5) - 0.5
    tooth = np.tile(tile, (-(-height // _TILE), -(-width // _TILE)))[:height, :width]
    down, aside, hand = (_drift(height, width, size, seed) for seed in (1, 2, 3))
    rows, columns = np.mgrid[0:height, 0:width].astype(np.float32)
    pitch = _PITCH * size
    near, weight = _wavering(rows + _WAVER * size * down, columns + _WAVER * size * aside)
    return _PencilPaper(
        tooth,
        _strokes(rows, columns, 58, pitch, hand, 1),
        _strokes(rows, columns, 22, 0.9 * pitch, hand, 2),
        _strokes(rows, columns, 3, 1.1 * pitch, 0.5 * hand, 3),
        np.clip(1 + 0.45 * hand, 0.6, 1.15),
        near,
        weight,
    )


def _wavering(rows: Image, columns: Image) -> tuple[NDArray[np.int32], NDArray[np.float32]]:
    """Return the four pixels round each (h, w) place of a picture, and the share of each (bilinear)."""
    height, width = rows.shape
    y, x = np.clip(rows, 0, height - 1.001), np.clip(columns, 0, width - 1.001)
    top, left = y.astype(np.int32), x.astype(np.int32)
    below, right = y - top, x - left
    first = top * width + left
    near = np.stack([first, first + 1, first + width, first + width + 1])
    above, here = 1 - below, 1 - right
    weight = np.stack([above * here, above * right, below * here, below * right])
    return near.reshape(4, -1), weight.astype(np.float32).reshape(4, -1)


def _drift(height: int, width: int, size: float, seed: int) -> Image:
    """Return a slow wave over the sheet, about -1 to 1."""
    cell = round(12 * size)
    coarse = noise(256, 0.8, seed)[: -(-height // cell), : -(-width // cell)]
    return 3 * (blur(coarse.repeat(cell, 0).repeat(cell, 1), cell)[:height, :width] - 0.5)


def _strokes(rows: Image, columns: Image, angle: float, pitch: float, bow: Image, seed: int) -> Image:
    """Return strokes side by side: 0 at the heart of one pressed hard, about 1 between them and where one ends.

    Args:
        rows: (h, w) of every pixel.
        columns: (h, w) of every pixel.
        angle: Of the strokes from the horizontal, degrees, rising to the right.
        pitch: Pixels from stroke to stroke.
        bow: (h, w) how far they bend aside, half a pitch at 1.
        seed: Of their lengths and pressure.
    """
    turn = np.radians(angle)
    across = (columns * np.sin(turn) + rows * np.cos(turn)) / pitch + 0.6 * bow + 8
    number = across.astype(np.int32)
    chance = np.random.default_rng(seed).random((2, 1024), np.float32)
    along = (columns * np.cos(turn) - rows * np.sin(turn)) / (_STROKE * pitch) + 4 * chance[0][number % 1024] + 1024
    part = along.astype(np.int32)
    off_line, to_end = 2 * np.abs(across - number - 0.5), 2 * np.abs(along - part - 0.5)
    pressed = chance[1][(7 * number + 131 * part) % 1024]
    return (0.62 * off_line + 0.28 * pressed + np.clip(1.8 * (to_end - 0.8), 0, 0.35)).astype(np.float32)
