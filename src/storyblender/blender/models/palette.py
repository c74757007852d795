"""Vertex colours as a picture: one field for each colour, and for each face the place of its field."""

from __future__ import annotations

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image

_FIELD = 4
"""Pixels across one colour's field, so that filtering does not mix neighbours."""
_MOST = 4096
"""Colours; of more, like ones share a field."""


def palette_of(
    paint: NDArray[np.float32], sizes: NDArray[np.int32], faces: NDArray[np.intp]
) -> tuple[bytes, NDArray[np.float32]]:
    """Return a PNG of the mean colours of faces, and the (len(faces), 2) texture coordinates of each face's field.

    Args:
        paint: (c, 3) scene-linear colours of all corners.
        sizes: (f,) corners of each face.
        faces: Those that are wanted.
    """
    starts = np.cumsum(sizes) - sizes
    means = (np.add.reduceat(paint, starts, axis=0) / sizes[:, None])[faces]
    encoded = np.where(means <= 0.0031308, means * 12.92, 1.055 * np.clip(means, 0, 1) ** (1 / 2.4) - 0.055)
    levels = np.rint(encoded * 255).astype(np.uint8)
    lost = 0
    colors, which = np.unique(levels, axis=0, return_inverse=True)
    while len(colors) > _MOST:
        lost += 1
        colors, which = np.unique(levels >> lost, axis=0, return_inverse=True)
    colors = (colors << lost) | ((1 << lost) >> 1)
    side = int(np.ceil(np.sqrt(len(colors))))
    fields = np.zeros((side * side, 3), np.uint8)
    fields[: len(colors)] = colors
    pixels = np.repeat(np.repeat(fields.reshape(side, side, 3), _FIELD, axis=0), _FIELD, axis=1)
    out = io.BytesIO()
    Image.fromarray(pixels, "RGB").save(out, "PNG")
    row, column = np.divmod(which.ravel(), side)
    places = np.stack([(column + 0.5) / side, 1 - (row + 0.5) / side], axis=1)
    return out.getvalue(), places.astype(np.float32)
