"""Has Blender read an FBX in a process of its own; of that only the motion of a skeleton comes back, as numbers."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

import numpy as np

from storyblender.errors import InputError
from storyblender.library.mocap.source_motion import SourceMotion

LARGEST: Final = 256 * 2**20
"""Bytes of a file."""
SECONDS: Final = 120
"""Of reading."""
MOTION, PROBLEM = "motion.npz", "problem.txt"
"""What the reading process writes into its folder: the motion, or why there is none."""
_BINARY: Final = b"Kaydara FBX Binary"


def read_fbx(path: Path) -> SourceMotion:
    """Return the motion of the largest skeleton in an FBX file.

    Args:
        path: The file.

    Raises:
        InputError: It cannot be read, or has no skeleton that moves; one clause, without the file's name.
    """
    try:
        if path.stat().st_size > LARGEST:
            raise InputError(f"it has more than {LARGEST // 2**20} MB")
        with path.open("rb") as file:
            if file.read(len(_BINARY)) != _BINARY:
                raise InputError("it is no binary FBX", mend="export it as a binary FBX, or as BVH")
    except OSError as error:
        raise InputError(f"it cannot be read ({error.strerror})") from error
    with TemporaryDirectory(prefix="storyblender-") as name:
        command = [sys.executable, "-m", "storyblender.blender.models.fbx_motion", str(path), name]
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
        problem, motion = Path(name) / PROBLEM, Path(name) / MOTION
        if problem.is_file():
            raise InputError(problem.read_text(encoding="utf-8")[:200])
        if done.returncode != 0 or not motion.is_file():
            raise InputError("Blender could not read it: it is damaged, or far too large")
        return _load(motion)


def _load(path: Path) -> SourceMotion:
    with np.load(path, allow_pickle=False) as data:
        return SourceMotion(
            names=tuple(str(name)[:120] for name in data["names"]),
            parents=tuple(int(parent) for parent in data["parents"]),
            rest=np.asarray(data["rest"], float),
            turns=np.asarray(data["turns"], float),
            places=np.asarray(data["places"], float),
            rate=float(data["rate"]),
        ).checked()
