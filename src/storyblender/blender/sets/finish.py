"""Finishes of the paint chart as Blender materials; lit windows get one per scene, as they follow its daylight."""

from __future__ import annotations

import bpy

from storyblender.blender.materials import material
from storyblender.blender.windows import set_daylight_material
from storyblender.catalog.materials import hex_color
from storyblender.catalog.sets.finishes import finish_of
from storyblender.memory.base import Color

PANES: dict[str, tuple[Color, float]] = {
    "pane_warm": (hex_color("#ffc173"), 0.75),
    "pane_amber": (hex_color("#ffb05c"), 0.5),
    "pane_pale": (hex_color("#ffdca8"), 0.95),
    "pane_far": (hex_color("#ffca7a"), 0.26),
}
"""Windows of occupied rooms: colour and emission at night."""

DAYLIGHT = 0.75
"""Emission by day, times its colour, of what is seen through the windows of a room that is exposed for its inside."""

_GLASS = hex_color("#2a343d")
_FAR_GLASS = hex_color("#7d8c99")
"""The same windows by day, near and across the street from a room."""


def finish(key: str) -> bpy.types.Material:
    """Return the material of a finish, or of a plain material key."""
    chosen = finish_of(key)
    return material(chosen.material, chosen.color)


def painted(code: str) -> bpy.types.Material:
    """Return paint in a hex colour that a kit chose."""
    return material("paint", hex_color(code))


def pane(key: str, scene: bpy.types.Scene, *, from_room: bool = False) -> bpy.types.Material:
    """Return the material of a lit window in one scene; it follows the scene's daylight.

    Args:
        key: A key of ``PANES``.
        scene: Scenes of one file have different times of day, so each has its own.
        from_room: The window is in the view out of a room; it is then dimmer, as exposure is set for the room.
    """
    name = f"MT_{key}_{scene.name}{'_far' if from_room else ''}"
    found = bpy.data.materials.get(name)
    if found is not None:
        return found
    block = bpy.data.materials.new(name)
    block.use_nodes = True
    block["key"], block["tile"], block["grain"] = key, 1.0, False
    block.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.15
    set_daylight_material(block, scene, (_FAR_GLASS, DAYLIGHT) if from_room else (_GLASS, 0.0), PANES[key])
    return block


def view_outside(key: str, color: Color, scene: bpy.types.Scene) -> bpy.types.Material:
    """Return the material of something outside the windows of a room: sunlit by day, dark at night.

    Args:
        key: Names it within the scene.
        color: Its colour in daylight.
        scene: Whose daylight it follows.
    """
    name = f"MT_outside_{key}_{scene.name}"
    found = bpy.data.materials.get(name)
    if found is not None:
        return found
    block = bpy.data.materials.new(name)
    block.use_nodes = True
    block["key"], block["tile"], block["grain"] = key, 1.0, False
    block.node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 1.0
    set_daylight_material(block, scene, (color, DAYLIGHT), (color, 0.0))
    return block
