"""Measures of a finished picture: share of the largest flat surface, and brightness. Pure numpy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_ROWS = 18
"""Number of rows of square blocks that the picture is divided into."""
_PLAIN = 0.012
"""Standard deviation of the brightness (0 to 1) in a block, below which the block counts as flat."""
_ALIKE = 0.05
"""Largest distance of the mean colours (0 to 1) of two blocks that show the same surface."""


@dataclass(frozen=True)
class PictureMeasure:
    """Measures of the pixels of a frame.

    Attributes:
        flat: Share of the picture that is the largest plain surface of one colour.
        brightness: Mean of the display values, 0 to 1.
    """

    flat: float
    brightness: float


def measure_picture(pixels: NDArray[np.uint8]) -> PictureMeasure:
    """Measure a picture.

    Args:
        pixels: (h, w, 3) display values, 0 to 255.
    """
    side = max(1, pixels.shape[0] // _ROWS)
    rows, columns = pixels.shape[0] // side, pixels.shape[1] // side
    values = pixels[: rows * side, : columns * side, :3].astype(np.float32) / 255
    blocks = values.reshape(rows, side, columns, side, 3).transpose(0, 2, 1, 3, 4).reshape(rows * columns, -1, 3)
    plain = blocks.mean(axis=2).std(axis=1) < _PLAIN
    colors = blocks.mean(axis=1)[plain]
    largest = 0
    while len(colors):
        same = np.abs(colors - colors[0]).max(axis=1) < _ALIKE
        largest = max(largest, int(same.sum()))
        colors = colors[~same]
    return PictureMeasure(flat=largest / len(blocks), brightness=float(values.mean()))
