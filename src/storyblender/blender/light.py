"""The lamps of a light plan as Blender lights that stay in the file, for artists and other tools."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from storyblender.blender.render.lamps import make_lamp
from storyblender.blender.tags import tag
from storyblender.memory.scene_context import Light


def make_lights(lights: Sequence[Light], collection: bpy.types.Collection, prefix: str) -> list[bpy.types.Object]:
    """Make one light object per lamp, tagged with its name and the person it lights.

    Args:
        lights: Of the scene or of a shot.
        collection: Receives the objects.
        prefix: Leads the objects' names: that of the scene, or of the shot that they are for.

    Returns:
        The objects, in order; area lights are not seen by cameras.
    """
    objects = []
    for light in lights:
        lamp = make_lamp(light, f"{prefix}.{light.name}")
        tag(lamp, kind="light", node_id=light.name, asset_id=light.for_asset or "")
        lamp["role"], lamp["glow"] = light.role, light.glow
        collection.objects.link(lamp)
        objects.append(lamp)
    return objects
