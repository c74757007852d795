"""Zip archives from outside, unpacked so that nothing in them lands anywhere else or fills the disk."""

from __future__ import annotations

import stat
import zipfile
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Final

from storyblender.errors import ServiceFailure

MODEL_FILES: Final = frozenset(
    (".gltf", ".glb", ".bin", ".obj", ".mtl", ".png", ".jpg", ".jpeg", ".webp", ".ktx2", ".tga", ".tif", ".tiff")
)
"""Suffixes of what a model consists of; anything else in an archive stays there."""
_CHUNK = 1 << 18


@dataclass(frozen=True)
class ArchiveLimits:
    """The most that an archive may unpack to.

    Attributes:
        files: Count of entries.
        bytes: Of all files.
        ratio: Bytes for each byte of the archive; the first 64 MiB are free of it.
        depth: Folders below each other.
    """

    files: int = 2000
    bytes: int = 1 << 30
    ratio: int = 100
    depth: int = 8


def extract(
    archive: Path, folder: Path, suffixes: frozenset[str] = MODEL_FILES, limits: ArchiveLimits | None = None
) -> tuple[str, ...]:
    """Unpack the files of a zip archive that have a known suffix.

    Args:
        archive: The archive.
        folder: Where to; it exists, is empty and private. If this fails, what is in it is of no use.
        suffixes: Lower-case, with the dot.
        limits: The most that it may unpack to.

    Returns:
        Names of the files, relative to the folder, sorted.

    Raises:
        ServiceFailure: It is no such archive, or one that is meant to do harm.
    """
    limits = limits or ArchiveLimits()
    most = min(limits.bytes, max(1 << 26, archive.stat().st_size * limits.ratio))
    try:
        with zipfile.ZipFile(archive) as opened:
            entries = dict(_wanted(opened.infolist(), suffixes, limits))
            if sum(entry.file_size for entry in entries.values()) > most:
                raise ServiceFailure("the archive unpacks to far more than it should")
            left = most
            for name, entry in entries.items():
                part = folder / name
                part.parent.mkdir(parents=True, exist_ok=True)
                left -= _unpack(opened, entry, part, left)
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError, ValueError, OSError) as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise ServiceFailure(f"the archive cannot be unpacked ({error.strerror})") from error
        raise ServiceFailure("the archive is damaged") from error
    return tuple(sorted(entries))


def _wanted(
    entries: list[zipfile.ZipInfo], suffixes: frozenset[str], limits: ArchiveLimits
) -> Iterator[tuple[str, zipfile.ZipInfo]]:
    """Yield the entries to unpack by name. Raises ServiceFailure."""
    if len(entries) > limits.files:
        raise ServiceFailure(f"the archive has more than {limits.files} files")
    seen: set[str] = set()
    for entry in entries:
        name = inside_name(entry.filename, limits.depth)
        kind = stat.S_IFMT(entry.external_attr >> 16)
        if kind not in (0, stat.S_IFREG, stat.S_IFDIR) or entry.flag_bits & 1:
            raise ServiceFailure("the archive has a link or a locked file in it")
        if entry.is_dir() or PurePosixPath(name).suffix.lower() not in suffixes:
            continue
        if name.casefold() in seen:
            raise ServiceFailure("the archive has two files of one name")
        if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise ServiceFailure("the archive is packed in a way that is not supported")
        seen.add(name.casefold())
        yield name, entry


def inside_name(name: str, depth: int = 8) -> str:
    """Return the name of a file from outside, relative to a folder that it cannot leave.

    Args:
        name: With ``/`` between its parts.
        depth: Folders below each other, at most.

    Raises:
        ServiceFailure: It leads out of the folder, or is not one that every disk can take.
    """
    path = PurePosixPath(name)
    odd = any(mark in name for mark in ("\\", ":", "\0", "*", "?", '"', "<", ">", "|")) or not name.isprintable()
    if odd or path.is_absolute() or not path.parts or {"..", "~"} & {*path.parts}:
        raise ServiceFailure("a file of the download has a name that leads out of its folder")
    if len(path.parts) > depth + 1 or any(len(part.encode()) > 150 for part in path.parts):
        raise ServiceFailure("a file of the download has too long a name")
    return path.as_posix()


def _unpack(opened: zipfile.ZipFile, entry: zipfile.ZipInfo, part: Path, most: int) -> int:
    """Write one file and return its bytes. Raises ServiceFailure."""
    written = 0
    with opened.open(entry) as source, part.open("xb") as out:
        while chunk := source.read(_CHUNK):
            written += len(chunk)
            if written > most:
                raise ServiceFailure("the archive unpacks to far more than it should")
            out.write(chunk)
    return written
