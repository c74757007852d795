"""People inside things: found where they are, shot by shot, and nowhere else."""

from __future__ import annotations

import bpy
import numpy as np
import pytest

from storyblender.blender.measure.collisions import find_collisions
from storyblender.blender.people.body import RiggedBody

pytestmark = pytest.mark.blender
BOX = 0.4
"""Half of the edge of the box, metres; it stands at x = 2."""


@pytest.fixture
def scene() -> bpy.types.Scene:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    signs = [(x, y, z) for x in (-BOX, BOX) for y in (-BOX, BOX) for z in (-BOX, BOX)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    mesh = bpy.data.meshes.new("box")
    mesh.from_pydata(signs, [], faces)
    box = bpy.data.objects.new("box", mesh)
    box.location = (2, 0, 0)
    box["kind"], box["node_id"] = "prop", "box"
    bones = bpy.data.armatures.new("anna")
    rig = bpy.data.objects.new("anna", bones)
    rig["asset_id"] = "anna"
    for obj in (box, rig):
        scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    bone = bones.edit_bones.new("hips")
    bone.head, bone.tail = (0, 0, 0), (0, 0, 0.2)
    bpy.ops.object.mode_set(mode="OBJECT")
    return scene


def body() -> RiggedBody:
    rest = np.array(bpy.data.armatures["anna"].bones["hips"].matrix_local)[None]
    skin = np.random.default_rng(0).uniform(-0.05, 0.05, (200, 3))
    return RiggedBody(
        ("hips",), np.array([-1]), rest, np.zeros((1, 3)), np.zeros((1, 3)), 1.7, skin, np.ones((200, 1)), ()
    )


def walk(keys: dict[int, float]) -> None:
    rig = bpy.data.objects["anna"]
    for frame, x in keys.items():
        rig.location.x = x
        rig.keyframe_insert("location", index=0, frame=frame)


def found(scene: bpy.types.Scene, frames: dict[str, range]) -> list[tuple[str, str, float]]:
    return [(item.shot, item.node_id, item.depth) for item in find_collisions(scene, {"anna": body()}, frames)]


def test_nobody_who_stands_beside_is_inside(scene: bpy.types.Scene) -> None:
    walk({1: 1.5})
    assert found(scene, {"SC010_SH010": range(1, 40)}) == []


def test_who_walks_through_is_found_at_the_deepest(scene: bpy.types.Scene) -> None:
    walk({1: 0.0, 81: 4.0})
    shot, thing, depth = found(scene, {"SC010_SH010": range(1, 81)})[0]
    assert (shot, thing) == ("SC010_SH010", "box") and depth == pytest.approx(BOX, abs=0.06)


def test_who_keeps_still_inside_is_found_in_every_shot(scene: bpy.types.Scene) -> None:
    walk({1: 2.0})
    shots = {"SC010_SH010": range(1, 40), "SC010_SH020": range(40, 80)}
    assert [shot for shot, _, _ in found(scene, shots)] == list(shots)


def test_a_hidden_thing_is_not_there(scene: bpy.types.Scene) -> None:
    walk({1: 2.0})
    bpy.data.objects["box"].hide_render = True
    assert found(scene, {"SC010_SH010": range(1, 40)}) == []
