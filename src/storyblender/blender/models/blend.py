"""Lets Blender read a file in a process of its own, so that neither its content nor a crash reaches the worker."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from storyblender.blender.models.blend_file import check_blend
from storyblender.blender.models.limits import SECONDS
from storyblender.blender.models.parts import checked
from storyblender.blender.models.plain import PlainModel, load
from storyblender.errors import InputError
from storyblender.file_reading_process import run_reading

_FBX_HEAD, _OLDEST_FBX = 27, 7100
"""Bytes that say the version of an .fbx, and the oldest that Blender reads: that of 2011."""


def read_blend(path: Path, folder: Path) -> PlainModel:
    """Read the meshes of a .blend.

    Args:
        path: The file.
        folder: The folder of models; what the file names must be in it.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    check_blend(path, folder)
    return read_aside(path, folder)


def read_foreign(path: Path, folder: Path) -> PlainModel:
    """Read an .fbx, .stl or .ply with Blender's own importer.

    Args:
        path: The file.
        folder: The folder of models; pictures that the file names must be in it.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    with path.open("rb") as file:
        head = file.read(_FBX_HEAD)
    if path.suffix.lower() == ".fbx":
        if not head.startswith(b"Kaydara FBX Binary  \x00"):
            raise InputError("it is no binary .fbx", mend="export it as binary .fbx, or as .glb")
        version = int.from_bytes(head[23:27], "little")
        if version < _OLDEST_FBX:
            raise InputError(f"it is an .fbx of version {version}; {_OLDEST_FBX} and newer are read")
    if path.suffix.lower() == ".ply" and not head.startswith(b"ply"):
        raise InputError("it is no .ply")
    model = read_aside(path, folder)
    return model if path.suffix.lower() == ".fbx" else replace(model, unit=None)


def read_aside(path: Path, folder: Path) -> PlainModel:
    """Let Blender read a file whose head or addresses have been checked.

    Args:
        path: The file.
        folder: The folder of models.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    with TemporaryDirectory(prefix="storyblender-") as name:
        out = Path(name)
        run_reading("storyblender.blender.models.blend_reader", (str(path), str(folder)), out, SECONDS)
        return checked(load(out))
