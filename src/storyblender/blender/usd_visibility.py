"""Visibility of objects in each shot, written into a USD file: Blender's exporter omits objects hidden at the start."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import bpy

_NAME = "userProperties:blender:object_name"


def hide_prims(part: Path, frames: Sequence[int], shown: Mapping[str, Sequence[bool]]) -> None:
    """Animate the visibility of prims.

    Args:
        part: A file of Blender's exporter; it is rewritten.
        frames: First frame of each shot, in order.
        shown: Object name -> whether it is visible, shot by shot; all others are always visible.
    """
    Usd, UsdGeom = _library()
    stage = Usd.Stage.Open(str(part))
    for prim in stage.Traverse():
        seen = shown.get(str(prim.GetAttribute(_NAME).Get()))
        if seen is not None:
            visibility = UsdGeom.Imageable(prim).CreateVisibilityAttr()
            visibility.Clear()
            for frame, visible in zip(frames, seen, strict=True):
                visibility.Set(UsdGeom.Tokens.inherited if visible else UsdGeom.Tokens.invisible, frame)
    stage.GetRootLayer().Save()


def _library():
    """Return the modules Usd and UsdGeom of Blender's OpenUSD, whose folder is on no search path."""
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    folder = Path(bpy.utils.resource_path("LOCAL")) / "python" / "lib" / version / "site-packages"
    if str(folder) not in sys.path:
        sys.path.append(str(folder))
    from pxr import Usd, UsdGeom

    return Usd, UsdGeom
