"""Checks what a USD file names before Blender composes it: every layer and picture lies in the folder of models."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy

from storyblender.blender.models.addresses import inside, readable
from storyblender.blender.models.limits import FILE_BYTES, MIB, PARTS
from storyblender.errors import InputError

LAYERS = (".usd", ".usda", ".usdc")
"""Files that hold a layer of USD."""
_MEND = "export it as one .usdz or .glb"
_MARKS = ("\\", "`", ":SDF_FORMAT_ARGS:")
"""What makes USD open another file than the one that an address seems to name."""
_ARCS = ("references", "payload")
_CLIPS = ("clips", "clipAssetPaths", "clipManifestAssetPath", "clipTemplateAssetPath")


@dataclass(frozen=True)
class UsdLayers:
    """The layers of a USD file.

    Attributes:
        layers: Hold them while Blender imports the file: what was left out of them is left out in memory only.
        notes: Sentences about what was left out.
        says_unit: Whether the file says its unit.
    """

    layers: tuple[Any, ...]
    notes: tuple[str, ...]
    says_unit: bool


def open_layers(path: Path, folder: Path) -> UsdLayers:
    """Open a USD file and all layers that it names, without composing them, and leave out pictures that cannot be read.

    Args:
        path: A file with one of ``LAYERS``.
        folder: The folder of models; what the layers name must be in it.

    Raises:
        InputError: A layer is damaged, too large, or takes parts from elsewhere; one clause.
    """
    bpy.utils.expose_bundled_modules()
    from pxr import Sdf

    opened: dict[Path, Any] = {}
    notes: list[str] = []
    waiting, size = [path], 0
    while waiting:
        place = waiting.pop()
        if place in opened:
            continue
        size += place.stat().st_size
        if size > FILE_BYTES or len(opened) == PARTS:
            raise InputError(f"it and the layers that it names have more than {FILE_BYTES // MIB} MiB or {PARTS} files")
        try:
            layer = opened[place] = Sdf.Layer.FindOrOpen(str(place))
            specs: list[Any] = []
            layer.Traverse(Sdf.Path.absoluteRootPath, lambda at, layer=layer, specs=specs: _add(layer, at, specs))
        except (RuntimeError, AttributeError) as error:
            raise InputError(f"{place.name!r} is damaged: USD cannot read it") from error
        waiting += [_layer(folder, place.parent, name) for name in (*layer.subLayerPaths, *_composed(specs))]
        notes += _leave_out_foreign(specs, folder, place.parent)
    says_unit = opened[path].pseudoRoot.HasInfo("metersPerUnit")
    return UsdLayers(tuple(opened.values()), tuple(dict.fromkeys(notes)), says_unit)


def _add(layer: Any, at: Any, specs: list[Any]) -> None:
    spec = layer.GetObjectAtPath(at)
    if spec is not None:
        specs.append(spec)


def _composed(specs: list[Any]) -> Iterator[str]:
    """Yield the addresses of other layers that specs refer to, also in variants. Raises InputError for value clips."""
    for spec in specs:
        if any(spec.HasInfo(clip) for clip in _CLIPS):
            raise InputError("it has value clips, which take its animation from other files", mend=_MEND)
        for arc in filter(spec.HasInfo, _ARCS):
            listed = spec.GetInfo(arc)
            lists = (listed.explicitItems, listed.prependedItems, listed.appendedItems, listed.addedItems)
            yield from (item.assetPath for items in lists for item in items if item.assetPath)


def _layer(folder: Path, base: Path, address: str) -> Path:
    """Return the layer that an address means, found as USD finds it. Raises InputError."""
    if Path(address).suffix.lower() not in LAYERS or any(mark in address for mark in _MARKS):
        shown = address if len(address) <= 80 else address[:77] + "..."
        problem = f"it takes parts from {shown!r}, which is not named as a {', '.join(LAYERS)} in the folder of models"
        raise InputError(problem, mend=_MEND)
    inside(folder, base, address)
    place = Path(os.path.normpath(base / address))  # USD drops ``..`` before links are followed
    readable(folder, place, repr(address))
    return place


def _leave_out_foreign(specs: list[Any], folder: Path, base: Path) -> Iterator[str]:
    """Empty the attributes that name a file which cannot be read, and yield a sentence for each."""
    for spec in specs:
        if str(getattr(spec, "typeName", "")) not in ("asset", "asset[]"):
            continue
        samples = spec.GetInfo("timeSamples").values() if spec.HasInfo("timeSamples") else ()
        for value in (spec.default, *samples):
            assets = value if hasattr(value, "__len__") else [value] if value else []
            try:
                for asset in assets:
                    if asset.path:
                        inside(folder, base, asset.path)
            except InputError as error:
                spec.ClearDefaultValue()
                spec.ClearInfo("timeSamples")
                yield f"{error.problem}; it is left out"
                break
