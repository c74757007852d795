"""Has Blender read an FBX in a process of its own; of that only the motion of a skeleton comes back, as numbers."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

import numpy as np

from storyblender.errors import InputError
from storyblender.file_reading_process import run_reading
from storyblender.library.mocap.source_motion import SourceMotion

LARGEST: Final = 256 * 2**20
"""Bytes of a file."""
SECONDS: Final = 120
"""Of reading."""
MOTION: Final = "motion.npz"
"""File in the reading process's folder with the motion."""
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
        run_reading("storyblender.blender.models.fbx_motion", (str(path),), Path(name), SECONDS)
        motion = Path(name) / MOTION
        if not motion.is_file():
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
