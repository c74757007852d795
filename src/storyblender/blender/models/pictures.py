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

_SMALL = 256 * 256
"""Pixels up to which a picture is kept without loss."""
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
    plain = _decoded(data, name)
    out = io.BytesIO()
    if plain.mode == "RGBA" or plain.width * plain.height <= _SMALL:
        plain.save(out, "PNG")
    else:
        plain.save(out, "JPEG", quality=92)
    return out.getvalue()


def clean_normals(data: bytes, name: str) -> bytes:
    """Return a normal map as a plain PNG or a JPEG that keeps all its colour; else as ``clean_picture``.

    Args:
        data: The file as it came.
        name: For the message.

    Raises:
        InputError: It is no picture, or too large.
    """
    plain, out = _decoded(data, name).convert("RGB"), io.BytesIO()
    if plain.width * plain.height <= _SMALL:
        plain.save(out, "PNG")
    else:
        plain.save(out, "JPEG", quality=95, subsampling=0)
    return out.getvalue()


def clean_channel(data: bytes, name: str, channel: int, factor: float = 1.0) -> bytes:
    """Return one channel of a picture as a grey PNG.

    Args:
        data: The file as it came.
        name: For the message.
        channel: 0 red, 1 green, 2 blue.
        factor: Multiplies it, 0..1.

    Raises:
        InputError: It is no picture, or too large.
    """
    grey, out = _decoded(data, name).convert("RGB").getchannel(channel), io.BytesIO()
    grey.point([round(level * factor) for level in range(256)]).save(out, "PNG")
    return out.getvalue()


def mean_level(data: bytes) -> float:
    """Return the mean of a clean grey picture, 0..1."""
    return float(np.asarray(Image.open(io.BytesIO(data)).convert("L")).mean() / 255)


def is_normal_map(data: bytes) -> bool:
    """Return whether a clean picture holds normals rather than heights: blue, and level on the whole."""
    red, green, blue = np.asarray(Image.open(io.BytesIO(data)).convert("RGB")).reshape(-1, 3).mean(axis=0) / 255
    return bool(blue > 0.7 and abs(red - 0.5) < 0.15 and abs(green - 0.5) < 0.15)


def flat_picture(color: Color) -> bytes:
    """Return a small PNG of one scene-linear colour."""
    red, green, blue = (round(255 * float(np.clip(channel, 0, 1)) ** (1 / 2.2)) for channel in color)
    out = io.BytesIO()
    Image.new("RGB", (4, 4), (red, green, blue)).save(out, "PNG")
    return out.getvalue()


def _decoded(data: bytes, name: str) -> Image.Image:
    """Return a picture, no larger than needed, as RGB or RGBA; it is decoded only after its header was looked at."""
    if len(data) > PICTURE_BYTES:
        raise InputError(f"its picture {name!r} has {len(data) // MIB} MiB; at most {PICTURE_BYTES // MIB} are read")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            picture = Image.open(io.BytesIO(data), formats=_FORMATS)
            width, height = picture.size
            if width * height > PICTURE_PIXELS or min(width, height) < 1:
                raise InputError(f"its picture {name!r} is {width} x {height} pixels, which is too large")
            picture.draft(None, (PICTURE_SIDE, PICTURE_SIDE))  # a large JPEG is decoded smaller
            plain = picture.convert("RGBA" if _has_alpha(picture) else "RGB")
    except _DAMAGE as error:
        raise InputError(f"its picture {name!r} cannot be read") from error
    plain.thumbnail((PICTURE_SIDE, PICTURE_SIDE))
    return plain


def _has_alpha(picture: Image.Image) -> bool:
    return "A" in picture.getbands() or "transparency" in picture.info


def tinted(data: bytes, color: Color) -> bytes:
    """Return a picture multiplied by a colour: Workbench knows no factor beside a picture.

    Args:
        data: A PNG or JPEG, as ``clean_picture`` gives it; the format stays.
        color: Factors of red, green and blue, scene-linear, 0 to 1.
    """
    picture = Image.open(io.BytesIO(data))
    pixels = np.asarray(picture.convert("RGBA")).copy()
    pixels[..., :3] = np.rint(pixels[..., :3] * np.clip(color, 0, 1) ** (1 / 2.2)).astype(np.uint8)
    out = io.BytesIO()
    Image.fromarray(pixels, "RGBA").convert(picture.mode).save(out, picture.format)
    return out.getvalue()
