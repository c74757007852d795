"""Windows follow the daylight: lit at night; by day dark glass, or bright with the view through them.

A material that follows it carries both of its lights as custom properties, so that renderers need no catalog:
``follows`` (name of the scene), ``day_color``, ``night_color``, ``day_emit`` and ``night_emit``.
"""

from __future__ import annotations

import bpy

from storyblender.look.raster import LUMA
from storyblender.memory.base import Color
from storyblender.memory.scene_context import Sky

_DARK, _BRIGHT = 0.08, 0.5
"""Luminance of the sky at full night and at full day."""


def set_daylight_material(
    block: bpy.types.Material, scene: bpy.types.Scene, day: tuple[Color, float], night: tuple[Color, float]
) -> None:
    """Make a material follow the daylight of a scene; it shows night until ``light_windows`` is called.

    Args:
        block: A material with nodes.
        scene: The scene; scenes of one file have different times of day, so each has materials of its own.
        day: Colour and emission by day.
        night: Colour and emission at night.
    """
    block["follows"] = scene.name
    (block["day_color"], block["day_emit"]), (block["night_color"], block["night_emit"]) = day, night
    _light(block, 1.0)


def light_windows(scene: bpy.types.Scene, sky: Sky) -> None:
    """Set the windows of a scene's set, and the view through them, to the brightness of its ``sky``."""
    night = night_of(sky)
    for block in bpy.data.materials:
        if block.get("follows") == scene.name:
            _light(block, night)


def night_of(sky: Sky) -> float:
    """Return 1 under a night sky, 0 under a day sky, between them at dusk."""
    mean = tuple((high + low) / 2 for high, low in zip(sky.zenith, sky.horizon, strict=True))
    brightness = sum(weight * channel for weight, channel in zip(LUMA, mean, strict=True))
    return min(1.0, max(0.0, (_BRIGHT - brightness) / (_BRIGHT - _DARK)))


def _light(block: bpy.types.Material, night: float) -> None:
    """Set a material to a share of ``night``, 0..1."""
    lamp, by_day = tuple(block["night_color"]), float(block["day_emit"])
    shown = tuple(a + (b - a) * night for a, b in zip(block["day_color"], lamp, strict=True))
    strength = by_day * (1 - night) + float(block["night_emit"]) * night
    shader = block.node_tree.nodes["Principled BSDF"].inputs
    shader["Base Color"].default_value = (*shown, 1)
    shader["Emission Color"].default_value = (*(shown if by_day else lamp), 1)  # a lamp that is dimmed keeps its colour
    shader["Emission Strength"].default_value = strength
    block.diffuse_color = (*shown, 1)
    block["emit"] = strength
