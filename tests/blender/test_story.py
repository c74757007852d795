"""The story's file from packs: who is seen when, what burns when."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import bpy
import pytest

sys.path.insert(0, str(Path(__file__).parent))

from story_stage import LENGTH, SKY, lamp, pack, shot, story

from storyblender.blender.materials import material
from storyblender.blender.people.parts import Paint
from storyblender.blender.people.parts import material as people_material
from storyblender.blender.story import compile_story
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.memory.scene_context import Lighting, Sky


def _seen(scene: bpy.types.Scene, node_id: str) -> list[bool]:
    """Whether every object of a node is seen, in the middle of each shot."""
    seen = []
    bpy.context.window.scene = scene
    for marker in scene.timeline_markers:
        scene.frame_set(marker.frame + LENGTH // 2)
        states = {not obj.hide_render for obj in scene.objects if obj.get("node_id") == node_id}
        assert len(states) == 1, f"{node_id} is seen in part in {marker.name}"
        seen.append(states.pop())
    return seen


def test_who_comes_on_later_is_not_seen_before_whatever_a_camera_takes_away(tmp_path: Path):
    packs = [pack(tmp_path, 1, 4, {"ada": 1, "tom": 2, "eve": 3})]
    shots = [shot(1, 1), shot(1, 2, hidden=("wall_back", "eve")), shot(1, 3, hidden=("tom",)), shot(1, 4)]
    compile_story(story(packs, shots), Folder(tmp_path))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "story.blend"), use_scripts=False)
    scene = bpy.data.scenes["SC010"]
    hidden = {str(obj["node_id"]) for obj in scene.objects if obj.hide_viewport and obj.hide_render}
    assert hidden == {"tom", "eve"}, "as the file opens, before the timeline moves"
    assert _seen(scene, "ada") == [True, True, True, True]
    assert _seen(scene, "tom") == [False, True, False, True]
    assert _seen(scene, "eve") == [False, False, True, True]
    assert _seen(scene, "wall_back") == [True, False, True, True]


def test_face_lights_burn_in_their_shot_alone(tmp_path: Path):
    packs = [pack(tmp_path, 1, 2)]
    shots = [shot(1, 1, lights=(lamp("ada_key"),)), shot(1, 2, lights=(lamp("ada_key"), lamp("ada_rim", "rim")))]
    compile_story(story(packs, shots), Folder(tmp_path))
    scene = bpy.data.scenes["SC010"]
    lights = [obj for obj in scene.objects if obj.type == "LIGHT"]
    for marker in scene.timeline_markers:
        bpy.context.window.scene = scene
        scene.frame_set(marker.frame)
        burning = {obj.name for obj in lights if not obj.hide_render}
        assert burning and all(name.startswith(marker.name) for name in burning)


def test_a_plan_that_comes_with_a_shot_takes_the_place_of_the_scenes(tmp_path: Path):
    dark = Lighting(lights=(lamp("candle", "set"),), sky=Sky(zenith=(0,) * 3, horizon=(0,) * 3, ground=(0,) * 3))
    shots = [shot(1, 1), shot(1, 2).model_copy(update={"lighting": dark}), shot(1, 3)]
    job = story([pack(tmp_path, 1, 3)], shots, Lighting(lights=(lamp("pendant", "set"),), sky=SKY))
    compile_story(job, Folder(tmp_path))
    scene = bpy.data.scenes["SC010"]
    bpy.context.window.scene = scene
    ramp = next(node for node in scene.world.node_tree.nodes if node.type == "VALTORGB").color_ramp
    burning, skies = [], []
    for marker in scene.timeline_markers:
        scene.frame_set(marker.frame)
        burning.append([obj.name for obj in scene.objects if obj.type == "LIGHT" and not obj.hide_render])
        skies.append(sum(ramp.elements[-1].color[:3]) > 0)
    assert burning == [["SC010.pendant"], ["SC010_SH020.candle"], ["SC010_SH020.candle"]]
    assert skies == [True, False, False]


def test_names_speak_and_bones_are_in_groups(tmp_path: Path):
    packs = [pack(tmp_path, number, 1) for number in (1, 2)]
    for each in packs:
        bpy.ops.wm.open_mainfile(filepath=str(tmp_path / each.path))
        table = next(obj for obj in bpy.data.objects if obj.name.endswith(".table"))
        for paint in (Paint((0.0086, 0.0086, 0.0103), "cloth"), Paint((0.0087, 0.0086, 0.0103), "cloth")):
            table.data.materials.append(people_material(paint))
        table.data.materials.append(material("wood_dark"))
        table.data.materials.append(material("leather", (0.01, 0.02, 0.06)))
        other = table.copy()
        bpy.data.scenes[0].collection.objects.link(other)
        bpy.ops.wm.save_mainfile()
    compile_story(story(packs, [shot(1, 1), shot(2, 1)]), Folder(tmp_path))
    names = {block.name for block in bpy.data.materials}
    assert names == {"Cloth black", "Cloth black 2", "Wood dark", "Leather navy"}
    assert [slot.name for slot in bpy.data.objects["SC010.table"].material_slots] == [
        slot.name for slot in bpy.data.objects["SC020.table"].material_slots
    ]
    every = [
        block.name
        for kind in ("objects", "armatures", "meshes", "materials", "lights")
        for block in getattr(bpy.data, kind)
    ]
    assert not [name for name in every if re.search(r"\.\d{3}$", name)]
    groups = {
        group.name: {bone.name for bone in group.bones} for group in bpy.data.armatures["SC010.ada_rig"].collections
    }
    assert groups == {
        "Controls": {"root", "torso", "look_at"},
        "Limbs": {"hips", "head"},
        "Fingers": set(),
        "Deform": {"hips", "head", "jaw", "eye.L", "eye.R"},
    }


def test_a_scene_put_in_anew_finds_the_materials_of_the_others(tmp_path: Path):
    packs = [pack(tmp_path, number, 1) for number in (1, 2)]
    for each in packs:
        bpy.ops.wm.open_mainfile(filepath=str(tmp_path / each.path))
        next(obj for obj in bpy.data.objects if obj.name.endswith(".table")).data.materials.append(material("wood"))
        bpy.ops.wm.save_mainfile()
    job = story(packs, [shot(1, 1), shot(2, 1)])
    compile_story(job, Folder(tmp_path))
    whole = sorted(block.name for block in bpy.data.materials)
    files = Folder(tmp_path)
    compile_story(job.model_copy(update={"changed": (1,), "former": files.state("story.blend")}), files)
    assert sorted(block.name for block in bpy.data.materials) == whole


def test_a_file_that_is_saved_while_it_is_compiled_is_not_overwritten(tmp_path: Path):
    job, files = story([pack(tmp_path, 1, 1)], [shot(1, 1)]), Folder(tmp_path)
    files.write("story.blend", b"a person's")
    former = files.state("story.blend")
    files.write("story.blend", b"a person's, and saved again")
    with pytest.raises(InputError, match="saved while it was being written"):
        compile_story(job.model_copy(update={"former": former}), files)
    assert files.path("story.blend").read_bytes() == b"a person's, and saved again"
    compile_story(job.model_copy(update={"former": files.state("story.blend")}), files)
    assert files.path("story.blend").read_bytes() != b"a person's, and saved again"


def test_a_render_needs_no_settings_and_the_file_says_its_version(tmp_path: Path):
    compile_story(story([pack(tmp_path, 1, 1)], [shot(1, 1)]), Folder(tmp_path))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "story.blend"), use_scripts=False)
    scene = bpy.data.scenes["SC010"]
    assert scene.cycles.use_denoising and scene.cycles.samples == 128
    assert (scene.view_settings.view_transform, scene.view_settings.look) == ("AgX", "AgX - High Contrast")
    assert "Blender 4.5" in bpy.data.texts["READ ME"].as_string()
