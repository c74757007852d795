"""One moment of a packed scene as glTF: everything that is drawn is in it, named by its node, and people are posed."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import bpy
import pytest

from storyblender.blender.moment_glb import write_moment

pytestmark = pytest.mark.blender


def content(path: Path) -> dict[str, Any]:
    data = path.read_bytes()
    (length,) = struct.unpack("<I", data[12:16])
    return json.loads(data[20 : 20 + length])


@pytest.fixture
def scene() -> bpy.types.Scene:
    """A box that goes two metres along X in ten frames, a lamp, and a hidden box."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    for name in ("box", "hidden"):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
        made = bpy.data.objects.new(name, mesh)
        made["node_id"], made["kind"] = name, "prop"
        scene.collection.objects.link(made)
        made.hide_render = name == "hidden"
        for frame, x in ((1, 0.0), (11, 2.0)):
            made.location.x = x
            made.keyframe_insert("location", frame=frame)
        for curve in made.animation_data.action.fcurves:
            for key in curve.keyframe_points:
                key.interpolation = "LINEAR"
    scene.collection.objects.link(bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "POINT")))
    return scene


@pytest.mark.parametrize(("frame", "x"), [(1, 0.0), (6, 1.0), (11, 2.0)])
def test_a_moment_has_what_is_drawn_where_it_is_then(
    scene: bpy.types.Scene, tmp_path: Path, frame: int, x: float
) -> None:
    write_moment(scene, frame, tmp_path / "moment.glb")
    made = content(tmp_path / "moment.glb")
    [node] = made["nodes"]
    assert node["extras"]["node_id"] == "box" and node["extras"]["kind"] == "prop"
    assert node.get("translation", [0, 0, 0])[0] == pytest.approx(x, abs=1e-5)
    assert not {"animations", "skins", "cameras"} & made.keys()
    assert {obj.name for obj in bpy.context.scene.objects} == {"box", "hidden", "lamp"}, "the scene is as before"


def test_what_does_not_move_is_where_it_was_put_in_a_scene_that_was_just_built(tmp_path: Path) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene.copy()
    bpy.context.window.scene = scene
    mesh = bpy.data.meshes.new("table")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    table = bpy.data.objects.new("table", mesh)
    scene.collection.objects.link(table)
    table.location = (1.5, 0.0, 0.25)
    write_moment(scene, 1, tmp_path / "moment.glb")
    [node] = content(tmp_path / "moment.glb")["nodes"]
    assert node["translation"] == pytest.approx([1.5, 0.25, 0.0])
