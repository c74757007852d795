"""Reads the multilayer EXR files that Blender writes uncompressed: rows of channels as they are, so this is a view.

OpenImageIO turns everything into one array of floats first, which takes twice as long (measured); a film reads a file
or two for each of its drawings.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from storyblender.errors import EngineError
from storyblender.look.raster import stacked

Channels = Mapping[str, NDArray[np.float32]]
"""(h, w) float32 by name without the view layer, e.g. ``Combined.R``, ``Depth.Z``; row 0 at the top."""

_MAGIC = b"v/1\x01"
_PLAIN = 2
"""Version of a file of scan lines with short names in a single part, with no other flag set."""
_ROW_HEAD = 8
"""Bytes of each row's number and size."""
_TYPES = {1: np.dtype("<f2"), 2: np.dtype("<f4")}


def read_channels(path: Path) -> Channels:
    """Return the channels of the first view layer in the file.

    Raises:
        EngineError: The file is missing, cut short, or not one of uncompressed rows.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise EngineError(f"the render wrote no picture: {error}") from error
    try:
        return _channels(data)
    except (IndexError, KeyError, ValueError, struct.error) as error:
        raise EngineError(f"the render wrote no whole picture, so the disk may be full: {path.name}") from error


def _channels(data: bytes) -> dict[str, NDArray[np.float32]]:
    """Return the channels; what is not as expected raises one of the errors of reading past an end."""
    if data[:4] != _MAGIC or struct.unpack_from("<i", data, 4)[0] & ~0x400 != _PLAIN:
        raise ValueError("not a plain EXR file")
    header, end = _attributes(data, 8)
    if header["compression"] != b"\0" or header["lineOrder"] != b"\0":
        raise ValueError("a packed EXR file")
    left, top, right, bottom = struct.unpack("<4i", header["dataWindow"])
    height, width = bottom - top + 1, right - left + 1
    columns = list(_columns(header["channels"]))
    size = _ROW_HEAD + sum(kind.itemsize * width for _, kind in columns)
    (first,) = struct.unpack_from("<q", data, end)
    rows = np.frombuffer(data, np.uint8, height * size, first).reshape(height, size)
    layer = columns[0][0].split(".", 1)[0]
    channels: dict[str, NDArray[np.float32]] = {}
    start = _ROW_HEAD
    for name, kind in columns:
        stop = start + kind.itemsize * width
        if name.startswith(f"{layer}."):
            channels[name.split(".", 1)[1]] = rows[:, start:stop].view(kind).astype(np.float32)
        start = stop
    return channels


def _attributes(data: bytes, start: int) -> tuple[dict[str, bytes], int]:
    """Return the header's values by name, and where it ends."""
    values: dict[str, bytes] = {}
    while data[start]:
        name, start = _text(data, start)
        _, start = _text(data, start)
        (size,) = struct.unpack_from("<i", data, start)
        values[name] = data[start + 4 : start + 4 + size]
        start += 4 + size
    return values, start + 1


def _columns(listed: bytes) -> Iterator[tuple[str, np.dtype]]:
    """Give the name and type of every channel, in the order in which they lie in a row."""
    start = 0
    while listed[start]:
        name, start = _text(listed, start)
        (kind,) = struct.unpack_from("<i", listed, start)
        yield name, _TYPES[kind]
        start += 16


def _text(data: bytes, start: int) -> tuple[str, int]:
    stop = data.index(b"\0", start)
    return data[start:stop].decode(), stop + 1


def color(channels: Channels) -> NDArray[np.float32]:
    """Return the combined colour, (h, w, 3)."""
    return stacked([channels[f"Combined.{name}"] for name in "RGB"])
