"""A bare stage for cameras: a floor, four walls, a table, and people of two boxes on a real rig."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence

import bpy

from storyblender.blender.measure.view import WIDTH, ViewfinderPose, viewfinder
from storyblender.blender.tags import Surface, tag
from storyblender.catalog.set_plan import Wall
from storyblender.memory.shot_context import CameraPose

HALF = 3.0
STATURE = 1.75
WALLS = tuple(
    Wall(node_id=f"wall_{name}", start=start, end=end, height=2.7, material="plaster")
    for name, start, end in (
        ("front", (-HALF, -HALF), (HALF, -HALF)),
        ("right", (HALF, -HALF), (HALF, HALF)),
        ("back", (HALF, HALF), (-HALF, HALF)),
        ("left", (-HALF, HALF), (-HALF, -HALF)),
    )
)


def build(people: Mapping[str, tuple[float, float, float]], walls: bool = True, clutter: bool = True):
    """Return a fresh scene; people are x, y and yaw in degrees, by node_id."""
    scene = bpy.data.scenes.new("camera stage")
    box(scene, "floor", (0, 0, -0.1), (30, 30, 0.1), "set")
    for wall in WALLS if walls else ():
        (x0, y0), (x1, y1) = wall.start, wall.end
        out = 0.08
        x, y = (x0 + x1) / 2 + out * ((x0 + x1) > 0) - out * ((x0 + x1) < 0), (y0 + y1) / 2
        y += out * ((y0 + y1) > 0) - out * ((y0 + y1) < 0)
        size = (max(abs(x1 - x0), 0.15), max(abs(y1 - y0), 0.15), 2.7)
        box(scene, wall.node_id, (x, y, 0), size, "set")
    if clutter:
        box(scene, "table", (1.8, 1.6, 0), (1.2, 0.8, 0.75), "prop")
    for name, (x, y, yaw) in people.items():
        person(scene, name, x, y, yaw)
    scene.view_layers[0].update()
    return scene


def box(scene, node_id: str, location, size, kind) -> bpy.types.Object:
    x, y, z = size[0] / 2, size[1] / 2, size[2]
    flat = [(-x, -y), (x, -y), (x, y), (-x, y)]
    mesh = bpy.data.meshes.new(node_id)
    vertices = [(u, v, h) for h in (0, z) for u, v in flat]
    faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    mesh.from_pydata(vertices, [], faces)
    obj = bpy.data.objects.new(node_id, mesh)
    obj.location = location
    scene.collection.objects.link(obj)
    return tag(obj, kind=kind, node_id=node_id, asset_id=node_id, surface=Surface.PROP)


def person(scene, name: str, x: float, y: float, yaw: float) -> None:
    rig_data = bpy.data.armatures.new(name)
    rig = bpy.data.objects.new(f"{name}_rig", rig_data)
    scene.collection.objects.link(rig)
    rig.location, rig.rotation_euler = (x, y, 0), (0, 0, math.radians(yaw))
    tag(rig, kind="character", node_id=name, asset_id=name)
    with bpy.context.temp_override(scene=scene, view_layer=scene.view_layers[0], object=rig, active_object=rig):
        scene.view_layers[0].objects.active = rig
        bpy.ops.object.mode_set(mode="EDIT")
        for bone, head, tail in (
            ("hips", (0, 0, 0.95), (0, 0, 1.1)),
            ("head", (0, 0, 1.52), (0, 0, 1.75)),
            ("jaw", (0, 0, 1.56), (0, -0.09, 1.525)),
            ("eye.L", (0.03, -0.09, 1.63), (0.03, -0.2, 1.63)),
            ("eye.R", (-0.03, -0.09, 1.63), (-0.03, -0.2, 1.63)),
        ):
            new = rig_data.edit_bones.new(bone)
            new.head, new.tail = head, tail
        bpy.ops.object.mode_set(mode="OBJECT")
    for part, low, size in (("body", 0.0, (0.45, 0.28, 1.45)), ("skull", 1.45, (0.17, 0.2, 0.3))):
        obj = box(scene, name, (0, 0, low), size, "character")
        obj.name, obj.parent = f"{name}_{part}", rig


def view(scene: bpy.types.Scene, pose: CameraPose, focus_ids: Sequence[str] = (), hidden: Sequence[str] = ()):
    """Return what one camera pose sees at the scene's current frame."""
    return look(scene, [ViewfinderPose(pose, focus_ids=tuple(focus_ids), hidden=tuple(hidden))])[0]


def look(scene: bpy.types.Scene, poses: Sequence[ViewfinderPose], width: int = WIDTH, height: int = WIDTH * 9 // 16):
    """Return what each camera sees, in order; the scene is back at its frame afterwards."""
    results = []
    before = scene.frame_current
    for frame, batch in itertools.groupby(poses, key=lambda pose: pose.frame):
        with viewfinder(scene, frame, width, height) as see:
            results += [see(pose) for pose in batch]
    scene.frame_set(before)
    return results
