"""Reads USD files; a .usdz package is unpacked first, so that its layers are checked as any others."""

from __future__ import annotations

import stat
import zipfile
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory

from storyblender.blender.models.blend import read_aside
from storyblender.blender.models.limits import FILE_BYTES, MIB, PARTS
from storyblender.blender.models.plain import PlainModel
from storyblender.blender.models.usd_layers import LAYERS
from storyblender.errors import InputError

_HEADS = (b"#usda ", b"PXR-USDC")


def read_usd(path: Path, folder: Path) -> PlainModel:
    """Read the meshes of a .usd, .usda, .usdc or .usdz.

    Args:
        path: The file.
        folder: The folder of models; what the file names must be in it, or in the package.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    if path.suffix.lower() != ".usdz":
        return _read_layer(path, folder)
    with TemporaryDirectory(prefix="storyblender-") as name:
        package = Path(name).resolve()
        return _read_layer(unpack(path, package), package)


def _read_layer(path: Path, folder: Path) -> PlainModel:
    with path.open("rb") as file:
        head = file.read(8)
    if not head.startswith(_HEADS):
        raise InputError(f"it is no {path.suffix}")
    return read_aside(path, folder)


def unpack(path: Path, folder: Path) -> Path:
    """Unpack a .usdz and return its first file, which is its scene.

    Args:
        path: The package.
        folder: An empty folder.

    Raises:
        InputError: It is damaged, too large, compressed, or has a file that would land elsewhere; one clause.
    """
    try:
        with zipfile.ZipFile(path) as package:
            entries = [entry for entry in package.infolist() if not entry.is_dir()]
            _check(entries)
            for entry in entries:
                place = folder / entry.filename
                place.parent.mkdir(parents=True, exist_ok=True)
                with place.open("xb") as file:
                    file.write(package.read(entry))
    except (zipfile.BadZipFile, EOFError, NotImplementedError, RuntimeError, ValueError, OSError) as error:
        raise InputError("it is no .usdz, or a damaged one") from error
    return folder / entries[0].filename


def _check(entries: list[zipfile.ZipInfo]) -> None:
    """Raise InputError where the files of a package may not be written."""
    if not entries or PurePosixPath(entries[0].filename).suffix.lower() not in LAYERS:
        raise InputError("it does not begin with a scene, as a .usdz does")
    if len(entries) > PARTS or sum(entry.file_size for entry in entries) > FILE_BYTES:
        raise InputError(f"it has more than {PARTS} files or {FILE_BYTES // MIB} MiB in it")
    for entry in entries:
        name = PurePosixPath(entry.filename)
        if name.is_absolute() or ".." in name.parts or any(mark in entry.filename for mark in "\\:"):
            raise InputError(f"it has a file {entry.filename[:80]!r}, which leads out of the package")
        if stat.S_IFMT(entry.external_attr >> 16) not in (0, stat.S_IFREG) or entry.flag_bits & 1:
            raise InputError(f"it has a link or a locked file in it, {entry.filename[:80]!r}")
        if entry.compress_type != zipfile.ZIP_STORED or entry.compress_size != entry.file_size:
            raise InputError(f"{entry.filename[:80]!r} in it is compressed, which a .usdz may not be")
