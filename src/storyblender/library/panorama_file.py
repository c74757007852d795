"""Reads a user's panorama (.hdr or .exr) and prepares it for the engine: 2k wide, without the sun's own disc.

The file is decoded by FFmpeg and written anew as plain Radiance RGBE, so Blender never opens what came from outside.
"""

from __future__ import annotations

import hashlib
import io
import struct
from pathlib import Path

import av
import numpy as np
from av.error import FFmpegError
from PIL import Image as Picture

from storyblender.errors import InputError
from storyblender.look.irradiance import irradiance_of, panorama_directions, solid_angles
from storyblender.look.raster import Image, luminance
from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.panorama import Panorama
from storyblender.model_content import credit_beside

WIDEST = 2048
"""Pixels across the prepared picture; a wider one is scaled down."""
_MOST_BYTES, _MOST_PIXELS = 512 << 20, 16384 * 8192
_LEAST, _BRIGHTEST = 16, 1e5
"""Pixels across that a panorama has at least; the largest value that is kept, as bright as any sun in practice."""
_SMALL = 256
"""Pixels across that are enough for its irradiance."""
_DISC = 16.0
"""Times the median of the upper half: what is brighter is the sun, which the light plan has as a lamp."""
_SUN_SHARE, _ONE_SUN = 0.1, 0.9
"""Least light of a sun as a share of the rest of the sky's, and how much all of it comes from one side, 0 to 1."""
_EXR_LINES = {0: 1, 1: 1, 2: 1, 3: 16, 4: 32, 5: 16, 6: 32, 7: 32, 8: 32, 9: 256}
"""Rows of a block by the number of the compression."""
_MEND = "give an equirectangular .hdr or .exr, twice as wide as high"


class _Unreadable(Exception):
    """A file that is no panorama for a reason that can be named."""


def read_panorama(path: Path) -> tuple[Panorama, bytes]:
    """Read a panorama.

    Args:
        path: The user's file; ``NAME.credits.toml`` beside it says whose work it is.

    Returns:
        What the graph keeps of it, and the prepared picture as a Radiance file.

    Raises:
        InputError: The file is missing, broken or of another shape.
    """
    data = _content(path)
    radiance = _radiance(path, data)
    radiance = _resized(radiance, min(radiance.shape[1], WIDEST) // 2 * 2)
    if not radiance.any():
        raise InputError("is black all over", mend=_MEND, path=path)
    radiance, sun = _without_sun(radiance)
    coefficients = irradiance_of(_resized(radiance, min(radiance.shape[1], _SMALL)))
    rounded = [[float(f"{value:.6g}") for value in row] for row in coefficients]
    provenance = Provenance(
        source="panorama", file=path.name, digest=hashlib.sha256(data).hexdigest(), **credit_beside(path)
    )
    known = Panorama.model_validate({"provenance": provenance, "irradiance": rounded, "sun": sun})
    return known, radiance_file(radiance)


def _radiance(path: Path, data: bytes) -> Image:
    """Return (h, w, 3) linear values of a panorama, none of them negative or not finite. Raises InputError."""
    try:
        radiance = _decoded(data, path.suffix.lower())
    except _Unreadable as error:
        raise InputError(f"cannot be read as a panorama ({error})", mend=_MEND, path=path) from error
    except (FFmpegError, ValueError, IndexError, KeyError, struct.error) as error:
        raise InputError("cannot be read as a panorama (it is damaged)", mend=_MEND, path=path) from error
    height, width = radiance.shape[:2]
    if abs(width - 2 * height) > 0.01 * width or width < _LEAST:
        raise InputError(f"is no panorama: it has {width} x {height} pixels", mend=_MEND, path=path)
    return np.clip(np.nan_to_num(radiance, nan=0.0), 0, _BRIGHTEST)


def small_panorama(path: Path) -> bytes:
    """Return a panorama as a small PNG, for people to choose by.

    Args:
        path: An .hdr or .exr.

    Raises:
        InputError: It is missing, broken or of another shape.
    """
    radiance = _resized(_radiance(path, _content(path)), _SMALL)
    bright = radiance / max(2 * float(np.median(luminance(radiance))), 1e-6)
    shown = (bright / (1 + bright)) ** (1 / 2.2)
    out = io.BytesIO()
    Picture.fromarray((255 * shown).astype(np.uint8)).save(out, "PNG")
    return out.getvalue()


def radiance_file(radiance: Image) -> bytes:
    """Return (h, w, 3) linear values as a Radiance picture (RGBE, uncompressed)."""
    height, width = radiance.shape[:2]
    fraction, exponent = np.frexp(radiance.max(axis=-1))
    shown = exponent > -100
    scale = np.where(shown, np.ldexp(np.float32(256), -np.where(shown, exponent, 0)), 0)
    rgbe = np.zeros((height, width, 4), np.uint8)
    rgbe[..., :3] = np.minimum(radiance * scale[..., None], 255)
    rgbe[..., 3] = np.where(shown & (fraction > 0), exponent + 128, 0)
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode() + rgbe.tobytes()


def _content(path: Path) -> bytes:
    """Return the bytes of the user's file."""
    if path.suffix.lower() not in (".hdr", ".exr"):
        raise InputError("is no panorama", mend=_MEND, path=path)
    try:
        if path.stat().st_size > _MOST_BYTES:
            raise InputError(f"has more than {_MOST_BYTES >> 20} MiB", mend="make it smaller", path=path)
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror})", mend=_MEND, path=path) from error


def _decoded(data: bytes, suffix: str) -> Image:
    """Return (h, w, 3) linear values. Raises _Unreadable, or what a decoder raises for a damaged file."""
    if suffix == ".exr":
        _refuse_torn_exr(data)
    with av.open(io.BytesIO(data), "r", format=f"{suffix[1:]}_pipe") as container:
        stream = container.streams.video[0]
        if not 0 < stream.width * stream.height <= _MOST_PIXELS:
            raise _Unreadable("far too many pixels")
        frame = next(container.decode(stream), None)
    if frame is None or not frame.format.name.startswith("gbr"):
        raise _Unreadable("no red, green and blue of high dynamic range")
    kind = {"gbrpf16le": np.float16, "gbrapf16le": np.float16, "gbrpf32le": np.float32, "gbrapf32le": np.float32}
    planes = [
        np.frombuffer(bytes(plane), kind[frame.format.name]).reshape(frame.height, -1)[:, : frame.width]
        for plane in frame.planes[:3]
    ]
    green, blue, red = (plane.astype(np.float32) for plane in planes)
    return np.stack([red, green, blue], axis=-1)


def _refuse_torn_exr(data: bytes) -> None:
    """Raise _Unreadable for an EXR that ends too early: FFmpeg fills up what is missing with black.

    Only files of rows are looked over (OpenEXR file layout: magic, version, attributes, table of offsets, blocks).
    """
    magic, version = struct.unpack_from("<II", data)
    if magic != 20000630:
        raise _Unreadable("no EXR file")
    if version >> 8 & 0b11010:  # tiled, deep or of several parts
        raise _Unreadable("an EXR file of tiles or of several parts")
    attributes: dict[bytes, bytes] = {}
    at = 8
    while data[at]:
        name = data[at : data.index(b"\0", at)]
        at = data.index(b"\0", at + len(name) + 1) + 1
        (size,) = struct.unpack_from("<i", data, at)
        if size < 0:
            raise _Unreadable("a damaged header")
        attributes[name] = data[at + 4 : at + 4 + size]
        at += 4 + size
    _, top, _, bottom = struct.unpack("<4i", attributes[b"dataWindow"])
    blocks = -(-(bottom - top + 1) // _EXR_LINES[attributes[b"compression"][0]])
    if not 0 < blocks <= len(data) // 8:
        raise _Unreadable("it ends too early")
    for begin in struct.unpack_from(f"<{blocks}Q", data, at + 1):
        size = struct.unpack_from("<i", data, begin + 4)[0] if begin + 8 <= len(data) else len(data)
        if not 0 <= size <= len(data) - begin - 8:
            raise _Unreadable("it ends too early")


def _resized(radiance: Image, width: int) -> Image:
    """Return the picture at a width and half that height, averaged."""
    if radiance.shape[:2] == (width // 2, width):
        return radiance
    size = (width, width // 2)
    bands = [Picture.fromarray(np.ascontiguousarray(radiance[..., band])) for band in range(3)]
    return np.stack([np.asarray(band.resize(size, Picture.Resampling.BOX)) for band in bands], axis=-1)


def _without_sun(radiance: Image) -> tuple[Image, tuple[float, float, float] | None]:
    """Return the picture with its brightest spots dimmed, and the direction to its sun if they are one."""
    height, width = radiance.shape[:2]
    bright = luminance(radiance)
    usual = max(float(np.median(bright[: height // 2])), 0.1 * float(np.quantile(bright, 0.95)))
    kept = np.minimum(bright, _DISC * usual) if usual > 0 else bright
    dimmed = radiance * (kept / np.maximum(bright, 1e-12))[..., None]
    angle = solid_angles(height, width)
    excess = ((bright - kept) * angle)[: height // 2]
    toward = (excess[..., None] * panorama_directions(height, width)[: height // 2]).sum(axis=(0, 1))
    given, length = float(excess.sum()), float(np.linalg.norm(toward))
    if given <= _SUN_SHARE * float((kept * angle)[: height // 2].sum()) or length < _ONE_SUN * given:
        return dimmed.astype(np.float32), None
    x, y, z = (round(float(part), 4) for part in toward / length)
    return dimmed.astype(np.float32), (x, y, z)
