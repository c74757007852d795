"""Small pictures for people to choose by, made anew from files that came from outside."""

from __future__ import annotations

import io
import struct
import warnings
import zlib
from typing import Final

from PIL import Image, UnidentifiedImageError

from storyblender.errors import InputError

SIDE: Final = 256
"""Pixels of the longer side, at most."""
_MOST_PIXELS: Final = 64_000_000
_FORMATS: Final = ("PNG", "JPEG", "WEBP", "TGA", "BMP", "TIFF")
_DAMAGE = (UnidentifiedImageError, Image.DecompressionBombError, OSError, ValueError, SyntaxError, EOFError, TypeError,
           LookupError, ArithmeticError, MemoryError, struct.error, zlib.error)  # fmt: skip
"""What decoders of damaged pictures end with."""


def small_picture(data: bytes) -> bytes:
    """Return a picture as a small PNG.

    Args:
        data: A file of a usual kind.

    Raises:
        InputError: It is damaged, too large, or no picture.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            picture = Image.open(io.BytesIO(data), formats=_FORMATS)
            if picture.width * picture.height > _MOST_PIXELS:
                raise InputError(f"the picture has {picture.width} x {picture.height} pixels, which is too many")
            picture.draft("RGB", (2 * SIDE, 2 * SIDE))
            small = picture.convert("RGBA" if "A" in picture.getbands() else "RGB")
            small.thumbnail((SIDE, SIDE))
    except _DAMAGE as error:
        raise InputError("it cannot be read as a picture") from error
    out = io.BytesIO()
    small.save(out, "PNG")
    return out.getvalue()
