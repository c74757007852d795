"""Baked shots play in Blender as they were solved, and shots of one timeline do not leak into each other."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from storyblender.blender.motion.bake import bake, reduce_keys, remove
from storyblender.blender.motion.plan import Performance, StagePerson, StagePlan, StageProp
from storyblender.blender.motion.solve import solve_shot
from storyblender.blender.people.person import PersonBuild, build_person
from storyblender.memory.asset_sheet import CharacterLook
from storyblender.memory.shot_context import Blocking, Cue, Mark

pytestmark = pytest.mark.blender
FPS = 24


@pytest.fixture
def rick() -> PersonBuild:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_person("rick", CharacterLook(age=40, gender="male"), 1)


def _performance(rick: PersonBuild, x: float, frames: int = 48) -> Performance:
    start = Mark(asset_id="rick", location=(x, 0, 0), yaw=90, held=(("R", "cup"),))
    end = start.model_copy(update={"location": (x + 1.5, 0, 0)})
    plan = StagePlan(
        people={"rick": StagePerson(rick.body, Blocking(start=start, end=end))},
        frames=frames,
        cues=(
            Cue(asset_id="rick", clip="walk", start=2, mark=end),
            Cue(asset_id="rick", clip="talk", start=0, duration=frames),
        ),
        props={"cup": StageProp(np.array(Matrix.Translation((0, 0, -5))), (0.08, 0.08, 0.1))},
    )
    return solve_shot(plan, FPS)


def _cup() -> bpy.types.Object:
    cup = bpy.data.objects.new("cup", bpy.data.meshes.new("cup"))
    bpy.context.scene.collection.objects.link(cup)
    return cup


def test_blender_plays_what_was_solved(rick: PersonBuild) -> None:
    shot, cup = _performance(rick, 0), _cup()
    bake(shot, {"rick": rick.armature}, {"cup": cup}, "SC010_SH010", 1)
    track, scene = shot.people["rick"], bpy.context.scene
    for frame in (0, 11, 30, 47):
        scene.frame_set(1 + frame)
        assert rick.armature.location.x == pytest.approx(track.root[frame, 0], abs=0.002)
        for index, bone in enumerate(track.bone_names):
            played = np.array(rick.armature.pose.bones[bone].rotation_quaternion)
            assert abs(played @ track.rotations[frame, index]) > 1 - 2e-4, (frame, bone)
        assert np.array(cup.matrix_world) == pytest.approx(shot.props["cup"][frame], abs=0.01)


def test_shots_on_one_timeline_do_not_leak(rick: PersonBuild) -> None:
    cup = _cup()
    shots = [_performance(rick, 0), _performance(rick, 5)]
    for shot, name, start in zip(shots, ("SC010_SH010", "SC010_SH020"), (1, 49), strict=True):
        bake(shot, {"rick": rick.armature}, {"cup": cup}, name, start)
    for shot, start in zip(shots, (1, 49), strict=True):
        for frame in (0, 24, 47):
            bpy.context.scene.frame_set(start + frame)
            assert rick.armature.location.x == pytest.approx(shot.people["rick"].root[frame, 0], abs=0.002)


def test_baking_a_shot_again_replaces_it(rick: PersonBuild) -> None:
    for x in (0, 2):
        bake(_performance(rick, x), {"rick": rick.armature}, {}, "SC010_SH010", 1)
    assert [action.name for action in bpy.data.actions] == ["SC010_SH010"]
    assert [track.name for track in rick.armature.animation_data.nla_tracks] == ["SC010_SH010"]
    bpy.context.scene.frame_set(1)
    assert rick.armature.location.x == pytest.approx(2, abs=0.002)
    remove("SC010_SH010")
    assert not bpy.data.actions
    assert not rick.armature.animation_data.nla_tracks


def test_one_action_has_a_slot_per_part(rick: PersonBuild) -> None:
    action = bake(_performance(rick, 0), {"rick": rick.armature}, {"cup": _cup()}, "SC010_SH010", 1)
    names = {slot.identifier for slot in action.slots}
    assert {"OBrick", "OBcup"} <= names
    faces = [obj for obj in rick.meshes if obj.data.shape_keys and "mouth_open" in obj.data.shape_keys.key_blocks]
    if faces:
        values = []
        for frame in range(1, 49, 3):
            bpy.context.scene.frame_set(frame)
            values.append(faces[0].data.shape_keys.key_blocks["mouth_open"].value)
        assert max(values) > 0.2, "the mouth moves while talking"


def test_reduction_keeps_within_tolerance_and_drops_straight_lines() -> None:
    frames = np.arange(100.0)
    values = np.c_[np.sin(frames / 15), frames * 0.01]
    kept = reduce_keys(frames, values, 0.02)
    assert len(kept) < 40
    again = np.c_[tuple(np.interp(frames, frames[kept], values[kept, i]) for i in range(2))]
    assert np.abs(again - values).max() <= 0.02
    assert list(reduce_keys(frames, frames[:, None] * 2.0, 0.001)) == [0, 99]
