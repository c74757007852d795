"""The sky of a scene as its Blender world, and what of the set follows it."""

from __future__ import annotations

import bpy

from storyblender.blender.render.lamps import make_world
from storyblender.blender.windows import light_windows
from storyblender.memory.scene_context import Sky


def set_world(scene: bpy.types.Scene, sky: Sky) -> bpy.types.World:
    """Give a scene the gradient dome of a sky and light the windows of its set to match.

    The same stops on the sine of elevation are drawn by the compositor (``look.illumination``).

    Args:
        scene: Its former world is replaced, and removed if nobody else uses it.
        sky: Of the light plan.

    Returns:
        The new world, named after the scene.
    """
    former = scene.world
    scene.world = make_world(sky, f"{scene.name}_sky")
    if former is not None and former.users == 0:
        bpy.data.worlds.remove(former)
    light_windows(scene, sky)
    return scene.world
