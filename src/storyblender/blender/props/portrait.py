"""A small picture of one thing or person, for the catalogue and the asset sheet."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Sequence
from pathlib import Path

import bpy
import mathutils

YAW, PITCH, LENS = math.radians(-28), math.radians(18), 70.0
"""Seen a little from its left and from above, like a product photograph."""
HEAD = 0.12
"""Half of what a head with its neck takes of a person's height."""


def render_portrait(
    parts: Sequence[bpy.types.Object], part: Path, size: tuple[int, int] = (512, 512), *, head: bool = False
) -> None:
    """Render objects alone with Workbench on a plain ground and write a PNG. The scene they are in is not changed.

    Args:
        parts: The mesh objects of one thing or person, about one origin.
        part: The PNG.
        size: Pixels across and down.
        head: Only the head of a person, by which a picture of a hair style is known.
    """
    scene = bpy.data.scenes.new("PORTRAIT")
    copies = [part.copy() for part in parts]
    camera = bpy.data.objects.new("portrait_camera", bpy.data.cameras.new("portrait_camera"))
    for member in (*copies, camera):
        scene.collection.objects.link(member)
    corners = [mathutils.Vector(corner) for part in parts for corner in part.bound_box]
    middle = sum(corners, mathutils.Vector()) / len(corners)
    radius = max((corner - middle).length for corner in corners)
    if head:
        top = max(corner.z for corner in corners)
        radius = HEAD * top
        middle = mathutils.Vector((0, 0, top - radius))
    camera.data.lens = LENS
    view = 2 * math.atan(camera.data.sensor_width / 2 / LENS)
    away = mathutils.Vector((math.sin(YAW) * math.cos(PITCH), -math.cos(YAW) * math.cos(PITCH), math.sin(PITCH)))
    distance = radius / math.sin(view / 2) * 1.04
    camera.location = middle + away * distance
    camera.rotation_euler = (-away).to_track_quat("-Z", "Y").to_euler()
    camera.data.clip_start, camera.data.clip_end = distance / 100, distance * 10
    scene.camera = camera
    _shade(scene, size, part)
    window = bpy.context.window
    before = window.scene
    try:
        window.scene = scene
        bpy.ops.render.render(write_still=True)
    finally:
        window.scene = before
        bpy.data.cameras.remove(camera.data)
        for copy in copies:
            bpy.data.objects.remove(copy)
        bpy.data.worlds.remove(scene.world)
        bpy.data.scenes.remove(scene)


def _shade(scene: bpy.types.Scene, size: tuple[int, int], part: Path) -> None:
    """Set up Workbench to draw the scene to the PNG ``part`` in a plain studio look."""
    scene.world = bpy.data.worlds.new("portrait_world")
    scene.world.color = (0.62, 0.61, 0.58)
    render, shading = scene.render, scene.display.shading
    render.engine = "BLENDER_WORKBENCH"
    render.resolution_x, render.resolution_y, render.resolution_percentage = *size, 100
    render.image_settings.file_format = "PNG"
    render.filepath = str(part)
    render.dither_intensity = 0
    scene.display.render_aa = "8"
    scene.view_settings.view_transform = "Standard"
    shading.light, shading.color_type, shading.studio_light = "STUDIO", "TEXTURE", "paint.sl"
    shading.show_cavity, shading.cavity_type = True, "BOTH"
    shading.show_object_outline = True
    shading.object_outline_color = (0.05, 0.05, 0.06)


def main(arguments: list[str]) -> None:
    """Write the portrait of a catalog prop: ``portrait KEY PICTURE.png``."""
    from storyblender.blender.props.build import build_prop

    key, path = arguments
    bpy.ops.wm.read_factory_settings(use_empty=True)
    render_portrait([bpy.data.objects.new(key, build_prop(key).mesh)], Path(path).resolve())


if __name__ == "__main__":
    main(sys.argv[1:])
    sys.stdout.flush()
    os._exit(0)  # bpy may hang at interpreter exit
