"""The sky of a scene as its Blender world, and what of the set follows it."""

from __future__ import annotations

import bpy

from storyblender.blender.render.lamps import make_world
from storyblender.blender.sets.finish import light_windows
from storyblender.look.raster import LUMA
from storyblender.memory.scene_context import Sky

_DARK, _BRIGHT = 0.08, 0.5
"""Luminance of the sky between which windows light up: full night, full day."""


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
    light_windows(scene, night_of(sky))
    return scene.world


def night_of(sky: Sky) -> float:
    """Return 1 under a night sky, 0 under a day sky, between them at dusk."""
    mean = tuple((high + low) / 2 for high, low in zip(sky.zenith, sky.horizon, strict=True))
    brightness = sum(weight * channel for weight, channel in zip(LUMA, mean, strict=True))
    return min(1.0, max(0.0, (_BRIGHT - brightness) / (_BRIGHT - _DARK)))
