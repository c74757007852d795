"""Small pictures of one thing or person: its portrait, and what it looks like from its six sides."""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

import bpy
import mathutils

from storyblender.memory.asset_sheet import ModelSide
from storyblender.memory.base import Vec3

YAW, PITCH, LENS = math.radians(-28), math.radians(18), 70.0
"""Seen a little from its left and from above, like a product photograph."""
HEAD = 0.12
"""Half of what a head with its neck takes of a person's height."""
SIDE_SIZE = (256, 256)
"""Pixels of a picture of one side."""
_UP: Vec3 = (0, 0, 1)
SIDES: Mapping[ModelSide, tuple[Vec3, Vec3]] = {
    "right": ((1, 0, 0), _UP),
    "left": ((-1, 0, 0), _UP),
    "back": ((0, 1, 0), _UP),
    "front": ((0, -1, 0), _UP),
    "top": ((0, 0, 1), (0, 1, 0)),
    "bottom": ((0, 0, -1), (0, -1, 0)),
}
"""Where the camera is from the thing, and what is up in its picture."""


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
    corners = _corners(parts)
    middle = sum(corners, mathutils.Vector()) / len(corners)
    radius = max((corner - middle).length for corner in corners)
    if head:
        top = max(corner.z for corner in corners)
        radius = HEAD * top
        middle = mathutils.Vector((0, 0, top - radius))
    away = mathutils.Vector((math.sin(YAW) * math.cos(PITCH), -math.cos(YAW) * math.cos(PITCH), math.sin(PITCH)))
    with _studio(parts, size) as (scene, camera):
        camera.data.lens = LENS
        view = 2 * math.atan(camera.data.sensor_width / 2 / LENS)
        distance = radius / math.sin(view / 2) * 1.04
        camera.location = middle + away * distance
        camera.rotation_euler = (-away).to_track_quat("-Z", "Y").to_euler()
        camera.data.clip_start, camera.data.clip_end = distance / 100, distance * 10
        _render(scene, part)


def render_sides(thing: bpy.types.Object, folder: Path) -> None:
    """Render a thing from its six sides without perspective, all at one scale, into ``front.png``, ``top.png`` ...

    From above its front is at the lower edge of the picture, from below at the upper edge.

    Args:
        thing: A mesh object at its origin, front -Y.
        folder: Of the PNGs.
    """
    corners = _corners([thing])
    middle = sum(corners, mathutils.Vector()) / len(corners)
    radius = max((corner - middle).length for corner in corners) or 1.0
    extent = max(max(corner[axis] for corner in corners) - min(corner[axis] for corner in corners) for axis in range(3))
    with _studio([thing], SIDE_SIZE) as (scene, camera):
        camera.data.type, camera.data.ortho_scale = "ORTHO", extent * 1.08 or 1.0
        camera.data.clip_start, camera.data.clip_end = radius / 100, radius * 10
        for side, (away, up) in SIDES.items():
            z, y = mathutils.Vector(away), mathutils.Vector(up)
            camera.matrix_world = mathutils.Matrix((y.cross(z), y, z)).transposed().to_4x4()
            camera.location = middle + z * 3 * radius
            _render(scene, folder / f"{side}.png")


@contextmanager
def _studio(
    parts: Sequence[bpy.types.Object], size: tuple[int, int]
) -> Iterator[tuple[bpy.types.Scene, bpy.types.Object]]:
    """Yield a scene of its own with copies of objects and a camera, in a plain studio look; remove it at the end."""
    scene = bpy.data.scenes.new("PORTRAIT")
    copies = [part.copy() for part in parts]
    camera = bpy.data.objects.new("portrait_camera", bpy.data.cameras.new("portrait_camera"))
    for member in (*copies, camera):
        scene.collection.objects.link(member)
    scene.camera = camera
    _shade(scene, size)
    window = bpy.context.window
    before = window.scene
    try:
        window.scene = scene
        yield scene, camera
    finally:
        window.scene = before
        bpy.data.cameras.remove(camera.data)
        for copy in copies:
            bpy.data.objects.remove(copy)
        bpy.data.worlds.remove(scene.world)
        bpy.data.scenes.remove(scene)


def _corners(parts: Sequence[bpy.types.Object]) -> list[mathutils.Vector]:
    return [mathutils.Vector(corner) for part in parts for corner in part.bound_box]


def _render(scene: bpy.types.Scene, part: Path) -> None:
    scene.render.filepath = str(part)
    bpy.ops.render.render(write_still=True)


def _shade(scene: bpy.types.Scene, size: tuple[int, int]) -> None:
    """Set up Workbench to draw the scene as a PNG in a plain studio look."""
    scene.world = bpy.data.worlds.new("portrait_world")
    scene.world.color = (0.62, 0.61, 0.58)
    render, shading = scene.render, scene.display.shading
    render.engine = "BLENDER_WORKBENCH"
    render.resolution_x, render.resolution_y, render.resolution_percentage = *size, 100
    render.image_settings.file_format = "PNG"
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
