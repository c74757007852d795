"""The controls of a rig: they do nothing until they are used, then hands, feet and head go where they are put."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

import bpy
import numpy as np
import pytest
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))

from motion_stage import chair_at, cue_of, mark_at, perform

from storyblender.blender.motion.bake import bake
from storyblender.blender.people.control_rig import CONTROLS, LIMBS, SWITCHES, remove_controls
from storyblender.blender.people.person import build_person
from storyblender.blender.tidying import tidy
from storyblender.memory.asset_sheet import CharacterLook

pytestmark = pytest.mark.blender
FRAMES = (1, 20, 47, 70)
Poses = dict[tuple[int, str], np.ndarray]


@pytest.fixture(scope="module")
def stage() -> Iterator[tuple[bpy.types.Object, Poses]]:
    """A man who walks, waves and sits down, with controls, and his poses before he had any."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    chair, man = {"chair": chair_at(2, 0, 0)}, build_person("man", CharacterLook(age=40, gender="male"), 1)
    rig = man.armature
    seat = mark_at("man", 2, -0.24, posture="sit", support_id="chair")
    cues = (cue_of("man", "wave", 0), cue_of("man", "sit_down", 30, mark=seat, target_id="chair"))
    shot = perform({"man": man.body}, (mark_at("man", 1.0, -1.2, 30),), cues, 4, ends=(seat,), furniture=chair)
    bake(shot, {"man": rig}, {}, "SC010_SH010", 1)
    bpy.context.scene.frame_end = 96
    before = poses(rig, FRAMES)
    tidy([rig])
    yield rig, before


@pytest.fixture
def rig(stage: tuple[bpy.types.Object, Poses]) -> Iterator[bpy.types.Object]:
    """The rig, which a test may switch and key; after it, it is as before."""
    rig = stage[0]
    yield rig
    rig.animation_data.action = None
    for name in SWITCHES:
        rig[name] = 0.0
    rig.update_tag()


def poses(rig: bpy.types.Object, frames: Sequence[int]) -> Poses:
    found: Poses = {}
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        for bone in rig.evaluated_get(bpy.context.evaluated_depsgraph_get()).pose.bones:
            found[frame, bone.name] = np.array(bone.matrix)
    return found


def switch(rig: bpy.types.Object, *names: str) -> None:
    for name in names:
        rig[name] = 1.0
    rig.update_tag()


def put(rig: bpy.types.Object, control: str, point: Vector, frame: int) -> None:
    """Key a control at a point in armature space, as an animator does."""
    bone = rig.pose.bones[control]
    bone.location = rig.data.bones[control].matrix_local.inverted() @ point
    bone.keyframe_insert("location", frame=frame)


def test_nothing_moves_until_a_control_is_used(stage: tuple[bpy.types.Object, Poses]) -> None:
    rig, before = stage
    after = poses(rig, FRAMES)
    assert set(before) | {(frame, name) for frame in FRAMES for name in CONTROLS} == set(after)
    assert max(np.abs(before[key] - after[key]).max() for key in before) < 1e-5


@pytest.mark.parametrize("name", [name for name in SWITCHES if name != "look_at_eyes"])
def test_what_is_switched_stays_where_it_is(stage: tuple[bpy.types.Object, Poses], name: str) -> None:
    rig, before = stage
    switch(rig, name)
    after = poses(rig, FRAMES)
    away = {key: np.abs(before[key] - after[key])[:3, 3].max() for key in before}
    assert max(away.values()) < 0.004, max(away, key=lambda key: away[key])
    rig[name] = 0.0
    rig.update_tag()


@pytest.mark.parametrize("limb", LIMBS, ids=lambda limb: limb.control)
def test_hands_and_feet_go_where_their_control_is_and_nothing_flips(rig: bpy.types.Object, limb) -> None:
    frame, chance = 20, np.random.default_rng(5)
    start = poses(rig, [frame])
    root, end, pole = (Vector(start[frame, name][:3, 3]) for name in (limb.upper, limb.end, limb.pole))
    length = rig.data.bones[limb.upper].length + rig.data.bones[limb.lower].length
    switch(rig, limb.switch)
    for _ in range(12):
        point = end + Vector(chance.uniform(-0.3, 0.3, 3))
        reach = point - root
        if not 0.35 * length < reach.length < 0.97 * length:
            point = root + reach.normalized() * min(max(reach.length, 0.35 * length), 0.97 * length)
        put(rig, limb.control, point, frame)
        after = poses(rig, [frame])
        assert (Vector(after[frame, limb.end][:3, 3]) - point).length < 0.001
        line, middle = (point - root).normalized(), Vector(after[frame, limb.lower][:3, 3])
        bend, wanted = (each - root - line * (each - root).dot(line) for each in (middle, pole))
        assert math.degrees(bend.angle(wanted)) < 60, "the knee or the elbow points at its pole"


def test_a_pole_turns_the_knee(rig: bpy.types.Object) -> None:
    before = poses(rig, [20])
    hip, foot = (Vector(before[20, name][:3, 3]) for name in ("thigh.L", "foot.L"))
    switch(rig, "ik_foot_L")
    put(rig, "foot_ik.L", hip + 0.7 * (foot - hip), 20)
    knees = []
    for side in (-0.5, 0.5):
        put(rig, "knee_pole.L", hip + Vector((side, -0.5, -0.3)), 20)
        knees.append(poses(rig, [20])[20, "shin.L"][0, 3])
    assert knees[1] - knees[0] > 0.1


def test_the_head_and_the_eyes_look_at_the_target(rig: bpy.types.Object) -> None:
    head = Vector(poses(rig, [20])[20, "head"][:3, 3])
    point = head + Vector((0.6, -1.0, 0.2))
    put(rig, "look_at", point, 20)
    still = poses(rig, [20])
    switch(rig, "look_at_head", "look_at_eyes")
    turned = poses(rig, [20])
    wanted = (point - head).normalized()
    assert math.degrees(Vector(turned[20, "head"][:3, 2]).angle(wanted)) < 0.5
    assert math.degrees(Vector(still[20, "head"][:3, 2]).angle(wanted)) > 10
    for eye in ("eye.L", "eye.R"):
        at = turned[20, eye]
        assert math.degrees(Vector(at[:3, 1]).angle(point - Vector(at[:3, 3]))) < 0.5


def test_the_torso_moves_the_body_and_feet_with_ik_stay(rig: bpy.types.Object) -> None:
    before = poses(rig, [20])
    switch(rig, "ik_foot_L", "ik_foot_R")
    put(rig, "torso", rig.data.bones["torso"].head_local - Vector((0.0, 0.0, 0.08)), 20)
    after = poses(rig, [20])
    assert after[20, "head"][2, 3] - before[20, "head"][2, 3] == pytest.approx(-0.08, abs=1e-4)
    for foot in ("foot.L", "foot.R"):
        assert after[20, foot][:3, 3] == pytest.approx(before[20, foot][:3, 3], abs=0.002)
    rig.animation_data.action = None
    rig.pose.bones["torso"].location = (0.0, 0.0, 0.0)


def test_only_the_controls_are_shown_and_their_shapes_are_in_no_scene(rig: bpy.types.Object) -> None:
    groups = {group.name: {bone.name for bone in group.bones} for group in rig.data.collections}
    assert [group.name for group in rig.data.collections if group.is_visible] == ["Controls"]
    assert groups["Controls"] == set(CONTROLS)
    assert groups["Deform"] == {bone.name for bone in rig.data.bones if bone.use_deform}
    assert {"thumb.L", "index1.R"} <= groups["Fingers"] and {"thigh.L", "head", "hips"} <= groups["Limbs"]
    shapes = {rig.pose.bones[name].custom_shape for name in CONTROLS}
    assert shapes and not any(shape.users_scene for shape in shapes)
    collection = bpy.data.collections["WIDGETS"]
    assert collection.hide_render and set(collection.objects) == {o for o in bpy.data.objects if o.name[:4] == "WGT_"}


def test_switches_work_where_scripts_are_disabled(rig: bpy.types.Object, tmp_path: Path) -> None:
    assert not [d for d in rig.animation_data.drivers if d.driver.type == "SCRIPTED"]
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "rig.blend"), copy=True)
    code = """
import bpy, json, sys
bpy.context.preferences.filepaths.use_scripts_auto_execute = False
bpy.ops.wm.open_mainfile(filepath=sys.argv[1], use_scripts=False)
rig = next(o for o in bpy.data.objects if o.type == "ARMATURE")
heads = []
for on in (0.0, 1.0):
    rig["ik_hand_R"] = on
    bone = rig.pose.bones["hand_ik.R"]
    bone.location.x += 0.1
    bone.keyframe_insert("location", frame=20)
    rig.update_tag()
    bpy.context.scene.frame_set(20)
    heads.append(list(rig.evaluated_get(bpy.context.evaluated_depsgraph_get()).pose.bones["hand.R"].head))
print("HEADS" + json.dumps([bpy.app.autoexec_fail, *heads]))
"""
    ran = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "rig.blend")], capture_output=True, text=True, check=True
    )
    line = next(line for line in ran.stdout.splitlines() if line.startswith("HEADS"))
    failed, off, on = json.loads(line[5:])
    assert not failed
    assert math.dist(off, on) > 0.05


def test_other_programs_get_the_rig_without_controls(stage: tuple[bpy.types.Object, Poses]) -> None:
    rig, before = stage
    remove_controls([rig])
    assert {bone.name for bone in rig.data.bones} == {name for _, name in before}
    assert not [bone for bone in rig.pose.bones if bone.constraints]
    assert not set(SWITCHES) & set(rig.keys()) and not rig.animation_data.drivers
    after = poses(rig, FRAMES)
    assert max(np.abs(before[key] - after[key]).max() for key in before) < 1e-5
