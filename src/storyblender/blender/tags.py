"""The custom properties on every object: the contract with the ID mask, the compositor and other tools."""

from __future__ import annotations

from typing import Literal

import bpy

from storyblender.look.surface import Surface

__all__ = ["NodeKind", "Surface", "tag"]

NodeKind = Literal["character", "prop", "set", "light", "camera"]


def tag(
    obj: bpy.types.Object,
    *,
    kind: NodeKind,
    node_id: str,
    asset_id: str = "",
    surface: Surface = Surface.PROP,
    ink_group: str = "",
) -> bpy.types.Object:
    """Write the custom properties on ``obj`` and return it.

    Args:
        obj: Any object of the scene.
        kind: What it is.
        node_id: The graph node it came from; parts of one person share it.
        asset_id: The asset it shows; empty for set pieces, lights and cameras.
        surface: How ink and light treat it.
        ink_group: Objects of one group get no line between them; defaults to the object itself.
    """
    obj["kind"] = kind
    obj["node_id"] = node_id
    obj["asset_id"] = asset_id
    obj["surface"] = int(surface)
    if ink_group:
        obj["ink_group"] = ink_group
    return obj


def surface_of(obj: bpy.types.Object) -> Surface:
    """Return the surface of a prop by its materials: plants get the ink of foliage, smoke is drawn as air."""
    names = {material.name.split(".")[0] for material in obj.data.materials if material}
    if any(name.startswith("MT_smoke") for name in names):
        return Surface.SMOKE
    return Surface.FOLIAGE if any("leaves" in name or "foliage" in name for name in names) else Surface.PROP
