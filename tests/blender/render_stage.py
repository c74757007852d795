"""A little test stage: a floor, two walls, a table, a lamp, and two people of boxes and balls with painted faces."""

from __future__ import annotations

import math

import bmesh
import bpy
import numpy as np

from storyblender.blender.render.frame import PersonHead
from storyblender.blender.tags import Surface, tag
from storyblender.memory.scene_context import Fog, Light, Lighting, Sky

HEADS = {"ana": (-0.6, 0.0, 1.6), "ben": (0.6, 0.3, 1.7)}


def build_stage(walls: bool = True) -> bpy.types.Scene:
    """Return a fresh scene with a camera that frames both people."""
    scene = bpy.data.scenes.new("Stage")
    _add(scene, "floor", _box((0, 0, -0.05), (12, 12, 0.1)), (0.30, 0.26, 0.22), "set", Surface.SET)
    if walls:
        _add(scene, "wall_back", _box((0, 3, 1.5), (8, 0.1, 3)), (0.45, 0.42, 0.36), "set", Surface.SET)
        _add(scene, "wall_left", _box((-4, 0, 1.5), (0.1, 6, 3)), (0.30, 0.36, 0.40), "set", Surface.SET)
    _add(scene, "table", _box((0, -0.1, 0.4), (0.8, 0.6, 0.8)), (0.35, 0.2, 0.1), "prop", Surface.PROP)
    _add(scene, "lamp", _ball((0, 2.2, 1.6), 0.15), (1.0, 0.8, 0.5), "prop", Surface.EMISSIVE, glow=4.0)
    for name, head in HEADS.items():
        _add_person(scene, name, head)
    data = bpy.data.cameras.new("camera")
    data.lens = 40
    camera = bpy.data.objects.new("camera", data)
    camera.location, camera.rotation_euler = (0.3, -4.2, 1.5), (math.radians(89), 0, math.radians(3))
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.view_layers[0].update()
    return scene


def heads() -> tuple[PersonHead, ...]:
    return (
        PersonHead("ana", HEADS["ana"], 50.0, 1.0, True),
        PersonHead("ben", HEADS["ben"], -50.0, 1.0, True),
    )


def interior() -> Lighting:
    return Lighting(
        lights=(
            Light(name="ceiling", kind="POINT", location=(0.5, 0.5, 2.8), power=60, color=(1, 0.8, 0.55), size=0.2),
            Light(
                name="practical", kind="POINT", role="practical", location=(0, 2.2, 1.6), power=10, glow=0.3, size=0.2
            ),
        ),
        sky=Sky(zenith=(0.01, 0.014, 0.02), horizon=(0.02, 0.025, 0.03), ground=(0.01, 0.01, 0.01)),
        ambient=(0.02, 0.02, 0.025),
        fog=Fog(color=(0.03, 0.025, 0.02), density=0.01, start=2.0),
    )


def exterior() -> Lighting:
    return Lighting(
        lights=(
            Light(
                name="sun", kind="SUN", role="sun", location=(-5, -4, 8), target=(0, 0, 0), power=3.2,
                color=(1, 0.95, 0.85), size=0.5,
            ),
        ),
        sky=Sky(zenith=(0.12, 0.24, 0.55), horizon=(0.5, 0.6, 0.75), ground=(0.15, 0.13, 0.11)),
        ambient=(0.3, 0.35, 0.42),
        face_luminance=0.3,
        set_luminance=0.2,
    )  # fmt: skip


def add_hand(scene: bpy.types.Scene, name: str, place: tuple[float, float, float]) -> None:
    """Hang a ball of somebody's skin in the air."""
    hand = _add(scene, f"{name}_hand", _ball(place, 0.06), (0.8, 0.5, 0.4), "character", Surface.SKIN)
    tag(hand, kind="character", node_id=name, asset_id=name, surface=Surface.SKIN, ink_group=hand.name)


def _add_person(scene: bpy.types.Scene, name: str, head: tuple[float, float, float]) -> None:
    x, y, z = head
    body = _add(scene, f"{name}_coat", _box((x, y, z / 2 - 0.1), (0.4, 0.25, z - 0.2)), (0.6, 0.05, 0.05), "character")
    skull = _add(scene, f"{name}_skin", _ball(head, 0.13), (0.8, 0.5, 0.4), "character")
    hair = _add(scene, f"{name}_hair", _ball((x, y + 0.03, z + 0.05), 0.13), (0.03, 0.02, 0.015), "character")
    for obj, surface in ((body, Surface.CLOTH), (skull, Surface.SKIN), (hair, Surface.HAIR)):
        tag(obj, kind="character", node_id=name, asset_id=name, surface=surface, ink_group=obj.name)
    colors = skull.data.color_attributes.new("color", "FLOAT_COLOR", "POINT")
    values = np.tile(np.array([0.75, 0.5, 0.4, 1.0], np.float32), (len(skull.data.vertices), 1))
    colors.data.foreach_set("color", values.ravel())


def _add(scene, name, mesh, color, kind, surface=Surface.PROP, glow=0.0) -> bpy.types.Object:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.diffuse_color = (*color, 1)
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1)
    shader.inputs["Emission Color"].default_value = (*color, 1)
    shader.inputs["Emission Strength"].default_value = glow
    mesh.materials.append(material)
    obj = bpy.data.objects.new(name, mesh)
    scene.collection.objects.link(obj)
    return tag(obj, kind=kind, node_id=name, surface=surface)


def _box(center, size) -> bpy.types.Mesh:
    return _mesh(lambda bm: bmesh.ops.create_cube(bm, size=1), center, size)


def _ball(center, radius) -> bpy.types.Mesh:
    mesh = _mesh(
        lambda bm: bmesh.ops.create_uvsphere(bm, u_segments=32, v_segments=16, radius=1), center, (radius,) * 3
    )
    mesh.shade_smooth()
    return mesh


def _mesh(make, center, size) -> bpy.types.Mesh:
    bm = bmesh.new()
    make(bm)
    bmesh.ops.scale(bm, vec=size, verts=bm.verts)
    bmesh.ops.translate(bm, vec=center, verts=bm.verts)
    mesh = bpy.data.meshes.new("part")
    bm.to_mesh(mesh)
    bm.free()
    return mesh
