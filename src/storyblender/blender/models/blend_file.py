"""Looks a .blend over before Blender opens it: whether it is whole, and which other .blend files it takes parts from.

A .blend is a header and blocks of a code, a length and data; the last block is ``ENDB``, and one is ``DNA1``.
"""

from __future__ import annotations

import gzip
import re
import struct
import zlib
from pathlib import Path
from typing import IO

import zstandard

from storyblender.blender.models.addresses import inside
from storyblender.blender.models.limits import FILE_BYTES, MIB
from storyblender.errors import InputError

_UNPACKED = 4 * FILE_BYTES
"""Bytes of a compressed file when it is unpacked."""
_LIBRARY = re.compile(rb"[^\0]*\.blend(?=\0)", re.IGNORECASE)
_NEWEST = 405
"""Newest version of Blender whose files are read."""


def check_blend(path: Path, folder: Path) -> None:
    """Refuse a .blend that is damaged, is too new, or takes parts from outside the folder of models.

    Args:
        path: The .blend.
        folder: The folder of models.

    Raises:
        InputError: One clause, without the file's name.
    """
    try:
        with path.open("rb") as raw, _unpacked(raw) as file:
            _check(file, path, folder)
    except (zstandard.ZstdError, gzip.BadGzipFile, zlib.error, EOFError) as error:
        raise InputError("it is cut off or damaged") from error


def _unpacked(raw: IO[bytes]) -> IO[bytes]:
    magic = raw.read(4)
    raw.seek(0)
    if magic[:2] == b"\x1f\x8b":
        return gzip.GzipFile(fileobj=raw)  # pyright: ignore[reportReturnType]
    if magic == b"\x28\xb5\x2f\xfd":
        return zstandard.ZstdDecompressor().stream_reader(raw, read_across_frames=True)  # pyright: ignore[reportReturnType]
    return raw


def _check(file: IO[bytes], path: Path, folder: Path) -> None:
    head = _take(file, 12)
    if head[:7] != b"BLENDER":
        raise InputError("it is no .blend")
    if head[7:8] not in (b"-", b"_") or head[8:9] not in (b"v", b"V") or not head[9:12].isdigit():
        raise InputError("it is of a newer Blender", mend="save it with Blender 4.5, or export it as .glb")
    version = int(head[9:12])
    if version > _NEWEST:
        raise InputError(
            f"it is of Blender {version // 100}.{version % 100}", mend="save it with Blender 4.5, or export it as .glb"
        )
    order, pointer = "<" if head[8:9] == b"v" else ">", 8 if head[7:8] == b"-" else 4
    described, total = False, 0
    while True:
        code, length = struct.unpack(f"{order}4si", _take(file, 8))
        _take(file, pointer + 8)
        if code == b"ENDB":
            break
        total += length
        if length < 0 or total > _UNPACKED:
            raise InputError(f"it is damaged, or has more than {_UNPACKED // MIB} MiB")
        described = described or code == b"DNA1"
        if code == b"LI\0\0":
            _check_library(_take(file, length), path, folder)
        else:
            _skip(file, length)
    if not described:
        raise InputError("it is damaged: it does not say what is in it")


def _check_library(data: bytes, path: Path, folder: Path) -> None:
    for address in {found.decode("utf-8", "replace") for found in _LIBRARY.findall(data) if found}:
        try:
            inside(folder, path.parent, address.removeprefix("//"))
        except InputError as error:
            mend = "in Blender: Object > Relations > Make Local > All, and save it"
            raise InputError(f"it takes parts from another file: {error.problem}", mend=mend) from error


def _take(file: IO[bytes], count: int) -> bytes:
    data = file.read(count)
    while len(data) < count and (more := file.read(count - len(data))):
        data += more
    if len(data) < count:
        raise InputError("it is cut off")
    return data


def _skip(file: IO[bytes], count: int) -> None:
    while count:
        step = min(count, MIB)
        _take(file, step)
        count -= step
