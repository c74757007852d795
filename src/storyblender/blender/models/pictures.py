"""Pictures of a user's model: looked at before they are decoded, made smaller, and written anew."""

from __future__ import annotations

import io
import struct
import warnings
import zlib

import numpy as np
from PIL import Image, UnidentifiedImageError

from storyblender.blender.models.limits import MIB, PICTURE_BYTES, PICTURE_PIXELS, PICTURE_SIDE
from storyblender.errors import InputError
from storyblender.memory.base import Color

_FORMATS = ("PNG", "JPEG", "WEBP", "TGA", "BMP", "TIFF", "GIF")

_DAMAGE = (UnidentifiedImageError, Image.DecompressionBombError, OSError, ValueError, SyntaxError, EOFError, TypeError,
           LookupError, ArithmeticError, MemoryError, struct.error, zlib.error)  # fmt: skip
"""What decoders of damaged pictures end with."""


def clean_picture(data: bytes, name: str) -> bytes:
    """Return a picture as a plain PNG or JPEG, no larger than needed and without anything but its pixels.

    Args:
        data: The file as it came.
        name: For the message.

    Raises:
        InputError: It is no picture, or too large.
    """
    if len(data) > PICTURE_BYTES:
        raise InputError(f"its picture {name!r} has {len(data) // MIB} MiB; at most {PICTURE_BYTES // MIB} are read")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            picture = Image.open(io.BytesIO(data), formats=_FORMATS)
            width, height = picture.size
            if width * height > PICTURE_PIXELS or min(width, height) < 1:
                raise InputError(f"its picture {name!r} is {width} x {height} pixels, which is too large")
            plain = picture.convert("RGBA" if _has_alpha(picture) else "RGB")
    except _DAMAGE as error:
        raise InputError(f"its picture {name!r} cannot be read") from error
    plain.thumbnail((PICTURE_SIDE, PICTURE_SIDE))
    out = io.BytesIO()
    if plain.mode == "RGBA" or width * height <= 256 * 256:
        plain.save(out, "PNG")
    else:
        plain.save(out, "JPEG", quality=92)
    return out.getvalue()


def _has_alpha(picture: Image.Image) -> bool:
    return "A" in picture.getbands() or "transparency" in picture.info


def tinted(data: bytes, color: Color) -> bytes:
    """Return a clean picture multiplied by a scene-linear colour: Workbench knows no factor beside a picture."""
    picture = Image.open(io.BytesIO(data))
    pixels = np.asarray(picture.convert("RGBA")).copy()
    pixels[..., :3] = np.rint(pixels[..., :3] * np.clip(color, 0, 1) ** (1 / 2.2)).astype(np.uint8)
    out = io.BytesIO()
    Image.fromarray(pixels, "RGBA").convert(picture.mode).save(out, picture.format)
    return out.getvalue()
