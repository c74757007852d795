"""Appending and merging: the same thing of several files is one data-block, and nothing stays linked."""

from __future__ import annotations

from pathlib import Path

import bpy

from storyblender.blender.appending import append
from storyblender.blender.merge import merge_duplicates
from storyblender.blender.people.parts import Paint, material


def _scene_file(path: Path, name: str) -> Path:
    """Write a scene with a table of canonical mesh, a painted material and a picture in it."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.name = name
    mesh = bpy.data.meshes.new("table")
    mesh["digest"] = "abc"
    cloth = material(Paint((0.0086, 0.0086, 0.0103), "cloth"))
    node = cloth.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.new("TX_oak", 4, 4)
    mesh.materials.append(cloth)
    scene.collection.objects.link(bpy.data.objects.new(f"{name}.table", mesh))
    bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)
    return path


def test_scenes_of_several_files_share_what_is_the_same(tmp_path: Path):
    names = ["SC010", "SC020", "SC030"]
    files = [_scene_file(tmp_path / f"{name}.blend", name) for name in names]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for path, name in zip(files, names, strict=True):
        (scene,) = append(path, "scenes", [name])
        assert scene.name == name
    merge_duplicates()
    assert len(bpy.data.meshes) == len(bpy.data.materials) == 1
    assert [image.name for image in bpy.data.images if image.name.startswith("TX_")] == ["TX_oak"]
    assert {obj.data for obj in bpy.data.objects} == {bpy.data.meshes["table"]}


def test_nothing_stays_linked(tmp_path: Path):
    path = _scene_file(tmp_path / "SC010.blend", "SC010")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    append(path, "scenes")
    assert not bpy.data.libraries
    assert all(block.library is None for block in (*bpy.data.objects, *bpy.data.meshes, *bpy.data.materials))


def test_a_mesh_of_another_recipe_keeps_its_own(tmp_path: Path):
    path = _scene_file(tmp_path / "SC010.blend", "SC010")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    append(path, "scenes")
    bpy.data.meshes["table"]["digest"] = "another"
    append(path, "scenes")
    merge_duplicates()
    assert sorted(mesh.name for mesh in bpy.data.meshes) == ["table", "table.001"]
    assert len(bpy.data.materials) == 1


def test_paints_that_differ_in_alpha_are_two_materials():
    glass, pane = (material(Paint((0.5, 0.5, 0.5), "glass", alpha=alpha)) for alpha in (1.0, 0.3))
    assert glass != pane
