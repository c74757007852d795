"""The custom properties on every object, read by the ID mask, the compositor and other tools."""

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
    """Write the custom properties on an object and return it.

    Args:
        obj: Any object of the scene.
        kind: Its kind.
        node_id: The graph node it came from; parts of one person share it.
        asset_id: The asset it shows; empty for set pieces, lights and cameras.
        surface: Treatment by ink and light.
        ink_group: Objects of one group get no line between them; empty for the object alone.
    """
    obj["kind"] = kind
    obj["node_id"] = node_id
    obj["asset_id"] = asset_id
    obj["surface"] = int(surface)
    if ink_group:
        obj["ink_group"] = ink_group
    return obj


def surface_of(obj: bpy.types.Object) -> Surface:
    """Return the surface of a prop by its materials: foliage for plants, smoke for smoke, else prop."""
    names = {material.name.split(".")[0] for material in obj.data.materials if material}
    if any(name.startswith("MT_smoke") for name in names):
        return Surface.SMOKE
    return Surface.FOLIAGE if any("leaves" in name or "foliage" in name for name in names) else Surface.PROP
