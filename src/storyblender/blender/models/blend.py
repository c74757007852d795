"""Lets Blender read a file in a process of its own, so that neither its content nor a crash reaches the worker."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from storyblender.blender.models.blend_file import check_blend
from storyblender.blender.models.limits import SECONDS
from storyblender.blender.models.parts import checked
from storyblender.blender.models.plain import PlainModel, load
from storyblender.errors import InputError

PROBLEM = "problem.txt"
"""What the reading process could not do, in its folder: problem and mend, one a line."""


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


def read_aside(path: Path, folder: Path) -> PlainModel:
    """Let Blender read a .blend, or a glTF that only Blender can unpack, whose addresses have been checked.

    Args:
        path: The file.
        folder: The folder of models.

    Raises:
        InputError: It cannot be read; one clause, without the file's name.
    """
    with TemporaryDirectory(prefix="storyblender-") as name:
        out = Path(name)
        command = [sys.executable, "-m", "storyblender.blender.models.blend_reader", str(path), str(folder), name]
        try:
            done = subprocess.run(
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                timeout=SECONDS,
                check=False,
                cwd=name,
            )
        except subprocess.TimeoutExpired as error:
            raise InputError(f"it could not be read within {SECONDS} seconds") from error
        if (out / PROBLEM).is_file():
            problem, _, mend = (out / PROBLEM).read_text().partition("\n")
            raise InputError(problem, mend=mend)
        if done.returncode != 0:
            raise InputError("Blender could not read it: it is damaged, or far too large")
        return checked(load(out))
