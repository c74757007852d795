"""Motion by hand in Blender: it is read as it is seen, whatever made it, and played again as it was read."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from pathlib import Path

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Quaternion, Vector

sys.path.insert(0, str(Path(__file__).parent))

from motion_stage import cue_of, mark_at, perform, world_at

from storyblender.blender.motion.bake import bake
from storyblender.blender.motion.by_hand import with_motion_by_hand
from storyblender.blender.motion.by_hand_reading import PACK, read_by_hand
from storyblender.blender.motion.plan import StageProp
from storyblender.blender.people.person import build_person
from storyblender.blender.story_values import read_values, write_values
from storyblender.blender.tags import tag
from storyblender.blender.tidying import tidy
from storyblender.folder import Folder
from storyblender.memory.asset_sheet import CharacterLook
from storyblender.memory.blend_values import BlendReading
from storyblender.memory.motion_by_hand import HandMotionRead, MotionByHand

pytestmark = pytest.mark.blender
SHOTS = {"SC010_SH010": 1, "SC010_SH020": 49}
FRAMES = (3, 20, 40, 60, 90)
Seen = dict[tuple[int, str], np.ndarray]


class Stage:
    """Two shots of a man who waves and walks, with a cup beside him, packed and compiled."""

    def __init__(self, folder: Path) -> None:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.files, scene = Folder(folder), bpy.context.scene
        scene.name, scene.frame_end = "SC010", 96
        man = build_person("man", CharacterLook(age=40, gender="male"), 1)
        rig, cup = man.armature, bpy.data.objects.new("SC010.cup", bpy.data.meshes.new("cup"))
        scene.collection.objects.link(cup)
        rig.name = "SC010.man"
        tag(rig, kind="character", node_id="man", asset_id="man")
        tag(cup, kind="prop", node_id="cup", asset_id="cup")
        start, end = mark_at("man", 0, 0, 40), mark_at("man", 1.2, -1.0, 40)
        cues = (cue_of("man", "wave", 0), cue_of("man", "walk", 4, mark=end))
        props = {"cup": StageProp(world_at(2, 1, 0.7), (0.08, 0.08, 0.1))}
        self.shots = {
            "SC010_SH010": perform({"man": man.body}, (start,), cues[:1], 2, props=props),
            "SC010_SH020": perform({"man": man.body}, (start,), cues[1:], 2, ends=(end,), props=props),
        }
        self.bake({})
        bpy.ops.wm.save_as_mainfile(filepath=str(folder / "pack.blend"), copy=True)
        scene["scene_id"], scene[PACK] = 1, "pack.blend"
        tidy([rig])
        write_values("1.a")
        self.compiled = read_values("1.a")

    @property
    def rig(self) -> bpy.types.Object:
        return bpy.data.objects["SC010.man"]

    @property
    def cup(self) -> bpy.types.Object:
        return bpy.data.objects["SC010.cup"]

    def bake(self, motions: dict[str, dict[str, MotionByHand]]) -> None:
        for name, start in SHOTS.items():
            shot = with_motion_by_hand(self.shots[name], motions.get(name, {}))
            bake(shot, {"man": self.rig}, {"cup": self.cup}, name, start)

    def read(self) -> tuple[HandMotionRead, ...]:
        return read_by_hand(BlendReading(compiled=self.compiled, saved=read_values("1.a")), self.files)

    def seen(self) -> Seen:
        """World matrices of the bones that deform, and of the cup."""
        found: Seen = {}
        for frame in FRAMES:
            bpy.context.scene.frame_set(frame)
            graph = bpy.context.evaluated_depsgraph_get()
            found[frame, "cup"] = np.array(self.cup.evaluated_get(graph).matrix_world)
            rig = self.rig.evaluated_get(graph)
            for bone in (bone for bone in rig.pose.bones if bone.bone.use_deform):
                found[frame, bone.name] = np.array(rig.matrix_world @ bone.matrix)
        return found


def key_above(stage: Stage) -> None:
    bone = stage.rig.pose.bones["upper_arm.L"]
    bone.rotation_quaternion = Quaternion((1, 0, 0), math.radians(50))
    bone.keyframe_insert("rotation_quaternion", frame=30)


def reach_with_ik(stage: Stage) -> None:
    bone = stage.rig.pose.bones["hand_ik.R"]
    for frame, on in ((10, 0.0), (20, 1.0)):
        stage.rig["ik_hand_R"] = on
        stage.rig.keyframe_insert('["ik_hand_R"]', frame=frame)
    for frame, shift in ((20, 0.0), (30, 0.15)):
        bone.location = Vector(bone.location) + Vector((shift, 0, 0))
        bone.keyframe_insert("location", frame=frame)


def lean_back(stage: Stage) -> None:
    stage.rig.pose.bones["torso"].rotation_quaternion = Quaternion((1, 0, 0), math.radians(15))


def tilt_and_move(stage: Stage) -> None:
    stage.rig.rotation_euler, stage.rig.location = (0.3, 0.1, 1.0), (0.5, 0.5, 0.2)
    for path in ("rotation_euler", "location"):
        stage.rig.keyframe_insert(path, frame=1)


def look_at_a_thing(stage: Stage) -> None:
    constraint = stage.rig.pose.bones["head"].constraints.new("DAMPED_TRACK")
    constraint.target, constraint.track_axis = stage.cup, "TRACK_Z"


def change_keys(stage: Stage) -> None:
    strip = next(t for t in stage.rig.animation_data.nla_tracks if t.name == "SC010_SH010").strips[0]
    bag = strip.action.layers[0].strips[0].channelbag(strip.action_slot)
    curve = bag.fcurves.find('pose.bones["head"].rotation_quaternion', index=1)
    for point in curve.keyframe_points:
        point.co.y += 0.2


def retime_strip(stage: Stage) -> None:
    strip = next(t for t in stage.rig.animation_data.nla_tracks if t.name == "SC010_SH010").strips[0]
    strip.action_frame_start = 6  # it begins with what came later


def lift_the_cup(stage: Stage) -> None:
    stage.cup.location.z += 0.3
    stage.cup.keyframe_insert("location", index=2, frame=5)


@pytest.mark.parametrize(
    ("animate", "who", "shots"),
    [
        (key_above, {"upper_arm.L"}, 2),
        (reach_with_ik, {"upper_arm.R", "forearm.R"}, 2),
        (lean_back, {"hips"}, 2),
        (tilt_and_move, {"root", "hips"}, 2),
        (look_at_a_thing, {"head"}, 2),
        (change_keys, {"head"}, 1),
        (retime_strip, {"hand.R"}, 1),
        (lift_the_cup, {"place"}, 2),
    ],
)
def test_what_is_seen_is_read_and_played_again(
    tmp_path: Path, animate: Callable[[Stage], None], who: set[str], shots: int
) -> None:
    stage = Stage(tmp_path)
    before = stage.seen()
    assert not stage.read(), "nobody animated anything"
    animate(stage)
    wanted = stage.seen()
    assert max(np.abs(before[key] - wanted[key]).max() for key in before) > 0.02
    read = stage.read()
    assert {each.shot for each in read} == set(list(SHOTS)[:shots])
    assert who <= {name for each in read for name in each.motion.channels}
    clean = Stage(tmp_path)
    clean.bake({each.shot: {each.asset_id: each.motion} for each in read})
    again = clean.seen()
    assert max(np.abs(wanted[key] - again[key])[:3, 3].max() for key in wanted) < 0.006
    assert max(np.abs(wanted[key] - again[key]).max() for key in wanted) < 0.03


def test_only_what_was_animated_is_read(tmp_path: Path) -> None:
    stage = Stage(tmp_path)
    key_above(stage)
    assert [set(each.motion.channels) for each in stage.read()] == [{"upper_arm.L"}] * 2


def test_without_its_pack_all_of_a_changed_person_counts(tmp_path: Path) -> None:
    stage = Stage(tmp_path)
    change_keys(stage)
    bpy.context.scene[PACK] = "../elsewhere.blend"
    read = stage.read()
    assert {"root", "hips", "hips_place", "foot.L", "head"} <= set(read[0].motion.channels)


def test_who_is_hidden_is_read_too(tmp_path: Path) -> None:
    stage = Stage(tmp_path)
    key_above(stage)
    wanted = [each.motion for each in stage.read()]
    stage = Stage(tmp_path)
    stage.rig.hide_viewport = stage.rig.hide_render = True
    key_above(stage)
    assert [each.motion for each in stage.read()] == wanted


def test_a_motion_of_a_longer_shot_is_held_after_its_last_key(tmp_path: Path) -> None:
    stage = Stage(tmp_path)
    key_above(stage)
    motion = stage.read()[0].motion
    short = MotionByHand(
        channels={
            name: channel.model_copy(update={"frames": channel.frames[:1], "values": channel.values[:1]})
            for name, channel in motion.channels.items()
        }
    )
    track = with_motion_by_hand(stage.shots["SC010_SH010"], {"man": short}).people["man"]
    turns = track.rotations[:, track.bone_names.index("upper_arm.L")]
    assert np.ptp(turns, axis=0).max() == 0
    assert Matrix(Quaternion(turns[0]).to_matrix()).to_quaternion().angle == pytest.approx(math.radians(50), abs=0.01)
