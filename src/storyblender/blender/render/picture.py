"""Writes finished pictures: 8 bit PNG without metadata, so that equal pixels are equal files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image


def write_png(image: NDArray[np.uint8], path: Path, *, quick: bool = False) -> None:
    """Write a uint8 (h, w, 3) sRGB picture.

    Args:
        image: Pixels.
        path: Its folder exists.
        quick: Spend less time on making the file small.
    """
    Image.fromarray(image).save(path, format="PNG", compress_level=1 if quick else 6)
