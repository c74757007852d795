"""A small picture of one object, for the catalogue and the asset sheet."""

from __future__ import annotations

import math
import os
import sys
from pathlib import Path

import bpy
import mathutils

YAW, PITCH, LENS = math.radians(-28), math.radians(18), 70.0
"""Seen a little from its left and from above, like a product photograph."""


def render_portrait(obj: bpy.types.Object, path: Path, size: tuple[int, int] = (256, 256)) -> None:
    """Render ``obj`` alone with Workbench on a plain ground and write a PNG. The scene it is in is not changed.

    Args:
        obj: A mesh object.
        path: Of the PNG.
        size: Pixels across and down.
    """
    scene = bpy.data.scenes.new("PORTRAIT")
    copy = bpy.data.objects.new("portrait", obj.data)
    camera = bpy.data.objects.new("portrait_camera", bpy.data.cameras.new("portrait_camera"))
    for member in (copy, camera):
        scene.collection.objects.link(member)
    corners = [mathutils.Vector(corner) for corner in obj.bound_box]
    middle = sum(corners, mathutils.Vector()) / 8
    radius = max((corner - middle).length for corner in corners)
    camera.data.lens = LENS
    view = 2 * math.atan(camera.data.sensor_width / 2 / LENS)
    away = mathutils.Vector((math.sin(YAW) * math.cos(PITCH), -math.cos(YAW) * math.cos(PITCH), math.sin(PITCH)))
    distance = radius / math.sin(view / 2) * 1.04
    camera.location = middle + away * distance
    camera.rotation_euler = (-away).to_track_quat("-Z", "Y").to_euler()
    camera.data.clip_start, camera.data.clip_end = distance / 100, distance * 10
    scene.camera = camera
    _shade(scene, size, path)
    window = bpy.context.window
    before = window.scene
    try:
        window.scene = scene
        bpy.ops.render.render(write_still=True)
    finally:
        window.scene = before
        bpy.data.cameras.remove(camera.data)
        bpy.data.objects.remove(copy)
        bpy.data.worlds.remove(scene.world)
        bpy.data.scenes.remove(scene)


def _shade(scene: bpy.types.Scene, size: tuple[int, int], path: Path) -> None:
    scene.world = bpy.data.worlds.new("portrait_world")
    scene.world.color = (0.62, 0.61, 0.58)
    render, shading = scene.render, scene.display.shading
    render.engine = "BLENDER_WORKBENCH"
    render.resolution_x, render.resolution_y, render.resolution_percentage = *size, 100
    render.image_settings.file_format = "PNG"
    render.filepath = str(path)
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
    render_portrait(bpy.data.objects.new(key, build_prop(key).mesh), Path(path).resolve())


if __name__ == "__main__":
    main(sys.argv[1:])
    sys.stdout.flush()
    os._exit(0)  # bpy may hang at interpreter exit
