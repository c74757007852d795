"""What tells one version of the builders from another: geometry that another version built is never taken."""

from __future__ import annotations

import hashlib
import os
import platform
from functools import cache
from importlib import metadata
from pathlib import Path

import storyblender
from storyblender.catalog.bodies import body_pack_path

BUILDERS = ("blender", "catalog", "geometry", "look", "memory", "library/data")
"""Packages and folders that decide what geometry a recipe becomes."""
BUILDING_MODULES = (
    "errors.py",
    "file_reading_process.py",
    "folder.py",
    "library/body_data.py",
    "library/file_names.py",
    "model_content.py",
    "outputs.py",
)


@cache
def builder_version(root: Path | None = None) -> str:
    """Return a digest of all code and data that builds, and of what it builds with.

    Args:
        root: The package's folder; the running program's own if not given.
    """
    root = Path(storyblender.__file__).parent if root is None else root
    digest = hashlib.sha256(f"{platform.machine()} {metadata.version('bpy')} {metadata.version('numpy')}".encode())
    below = (path for name in BUILDERS for path in (root / name).rglob("*"))
    for path in sorted([*below, *(root / name for name in BUILDING_MODULES)]):
        if path.is_file() and path.suffix != ".pyc":
            digest.update(f"\0{path.relative_to(root).as_posix()}\0".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()


def body_pack() -> str:
    """Return what tells the body data in use from other data; empty where there is none, and mannequins stand in."""
    path = body_pack_path(os.environ, Path.home())
    return f"{path} {path.stat().st_size}" if path.is_file() else ""
