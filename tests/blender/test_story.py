"""The story's file from packs: who is seen when, what burns when."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))

from story_stage import LENGTH, lamp, pack, shot, story

from storyblender.blender.story import compile_story


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
    compile_story(story(packs, shots), tmp_path, tmp_path / "story.blend")
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
    compile_story(story(packs, shots), tmp_path, tmp_path / "story.blend")
    scene = bpy.data.scenes["SC010"]
    lights = [obj for obj in scene.objects if obj.type == "LIGHT"]
    for marker in scene.timeline_markers:
        bpy.context.window.scene = scene
        scene.frame_set(marker.frame)
        burning = {obj.name for obj in lights if not obj.hide_render}
        assert burning and all(name.startswith(marker.name) for name in burning)
