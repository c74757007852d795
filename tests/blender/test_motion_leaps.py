"""Getting over things, throwing and catching, opening bags: on real bodies, tall and small."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from mathutils import Vector
from tests.blender.motion_stage import FPS, Playback, build_bodies, cue_of, mark_at, perform, world_at

from storyblender.blender.motion.plan import StageFurniture, StageProp
from storyblender.blender.people.body import RiggedBody
from storyblender.memory.asset_sheet import Anchor

pytestmark = pytest.mark.blender
FENCE = StageFurniture(world_at(0, 0), (2.0, 0.08, 1.1))
LADDER = StageFurniture(world_at(0, 0.3), (0.5, 0.12, 3.2))
BAG_GRIP = Anchor(kind="grip", name="grip_r", location=(0, 0, 0.33), direction=(0, -1, 0), normal=(0, 0, 1))


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies()


@pytest.mark.parametrize("clip", ["jump", "climb"])
@pytest.mark.parametrize("who", ["man", "girl"])
def test_feet_clear_the_fence_and_land_behind_it(bodies: dict[str, RiggedBody], who: str, clip: str) -> None:
    end = mark_at(who, 0, 0.5, 180)
    over = cue_of(who, clip, 2, target_id="fence", mark=end)
    shot = perform(bodies, (mark_at(who, 0, -0.42, 180),), (over,), 4, ends=(end,), furniture={"fence": FENCE})
    assert shot.problems == ()
    play = Playback(bodies[who], shot, who)
    for frame in range(len(shot.frames)):
        for bone in ("foot.L", "foot.R", "toe.L", "toe.R"):
            joint = play.joint(bone, frame)
            assert abs(joint.y) > 0.05 or joint.z > 1.05, f"{bone} goes through the fence at frame {frame}"
    assert shot.people[who].root[-1, 1] == pytest.approx(0.5, abs=0.01)
    assert play.joint("hips", len(shot.frames) - 1).z == pytest.approx(play.joint("hips", 0).z, abs=0.03)


@pytest.mark.parametrize("clip", ["jump", "climb"])
@pytest.mark.parametrize("who", ["man", "girl"])
def test_who_leaps_has_no_idle_hands(bodies: dict[str, RiggedBody], who: str, clip: str) -> None:
    low = StageFurniture(world_at(0, 0), (0.6, 0.3, 0.3))
    end = mark_at(who, 0, 0.6, 180)
    over = cue_of(who, clip, 2, target_id="step", mark=end)
    shot = perform(bodies, (mark_at(who, 0, -0.6, 180),), (over,), 4, ends=(end,), furniture={"step": low})
    play = Playback(bodies[who], shot, who)
    flying = max(range(len(shot.frames)), key=lambda frame: play.joint("hips", frame).z)
    for side in "LR":
        assert play.joint(f"hand.{side}", flying).z > play.joint("upper_chest", flying).z - 0.15

    def below(frame: int) -> float:
        return max(play.joint(f"hand.{side}", frame).z - play.joint("hips", frame).z for side in "LR")

    assert below(len(shot.frames) - 1) == pytest.approx(below(0), abs=0.06), "the arms come to rest again"


def test_a_ladder_is_climbed_up_and_one_stays_there(bodies: dict[str, RiggedBody]) -> None:
    up = cue_of("man", "climb", 2, target_id="ladder", duration=80)
    shot = perform(bodies, (mark_at("man", 0, -0.2, 180),), (up,), 4, furniture={"ladder": LADDER})
    play = Playback(bodies["man"], shot, "man")
    last = len(shot.frames) - 1
    assert play.joint("hips", last).z - play.joint("hips", 0).z > 0.8
    assert min(play.joint(f"foot.{side}", last).z for side in "LR") > 0.5


def test_what_is_thrown_to_somebody_is_caught(bodies: dict[str, RiggedBody]) -> None:
    ball = StageProp(world_at(0, 0, -5), (0.1, 0.1, 0.1))
    marks = (mark_at("man", -1.5, 0, 90, held=(("R", "ball"),)), mark_at("girl", 1.5, 0, -90))
    cues = (
        cue_of("man", "throw", 2, target_id="girl", prop_id="ball"),
        cue_of("girl", "catch", 2, target_id="man", prop_id="ball"),
    )
    shot = perform(bodies, marks, cues, 4, props={"ball": ball})
    assert shot.problems == ()
    path = shot.props["ball"][:, :3, 3]
    assert np.linalg.norm(np.diff(path, axis=0), axis=1).max() < 0.45, "it flies, it does not jump"
    assert path[: 2 * FPS, 2].min() > 0.3, "it does not fall to the floor"
    hand = Playback(bodies["girl"], shot, "girl").joint("hand.R", len(path) - 1)
    assert (Vector(path[-1].tolist()) - hand).length < 0.25


def test_an_orange_comes_out_of_the_satchel_one_holds(bodies: dict[str, RiggedBody]) -> None:
    props = {
        "satchel": StageProp(world_at(0, 0, -5), (0.32, 0.14, 0.34), (BAG_GRIP,)),
        "orange": StageProp(world_at(4, 4, 0.7), (0.08, 0.08, 0.09)),
    }
    cues = (
        cue_of("man", "open", 2, prop_id="satchel", hand="R"),
        cue_of("man", "take", 60, target_id="satchel", prop_id="orange", hand="L"),
    )
    shot = perform(bodies, (mark_at("man", 0, 0, held=(("R", "satchel"),)),), cues, 6, props=props)
    assert shot.problems == ()
    apart = np.linalg.norm(shot.props["orange"][:, :3, 3] - shot.props["satchel"][:, :3, 3], axis=1)
    assert apart[:60].max() < 0.1, "it is in the satchel"
    assert apart[-1] > 0.3, "it is out"
    assert np.linalg.norm(np.diff(shot.props["orange"][:, :3, 3], axis=0), axis=1).max() < 0.12


def test_a_child_is_lifted_eye_to_eye_and_put_down(bodies: dict[str, RiggedBody]) -> None:
    end = mark_at("man", 0.2, 0, 90)
    lift = cue_of("man", "lift", 2, target_id="girl")
    shot = perform(bodies, (mark_at("man", -0.6, 0, 90), mark_at("girl", 0.6, 0, -90)), (lift,), 6, ends=(end,))
    assert shot.problems == ()
    man, girl = (Playback(bodies[who], shot, who) for who in ("man", "girl"))
    heights = [girl.joint("eye.L", frame).z - man.joint("eye.L", frame).z for frame in range(0, 144, 6)]
    assert max(heights) > -0.08
    assert girl.joint("foot.L", 143).z == pytest.approx(girl.joint("foot.L", 0).z, abs=0.02)
    top = heights.index(max(heights)) * 6
    assert (man.joint("hand.L", top) - girl.joint("upper_chest", top)).length < 0.35, "held under the arms"


def test_a_staff_stands_on_the_floor(bodies: dict[str, RiggedBody]) -> None:
    stick = {"stick": StageProp(world_at(0, 0, -5), (0.04, 0.04, 0.95))}
    shot = perform(bodies, (mark_at("man", 0, 0, held=(("R", "stick"),)),), (), 1, props=stick)
    assert shot.props["stick"][10, 2, 3] == pytest.approx(0.0, abs=0.03)
    assert shot.props["stick"][10, 2, 2] > 0.98, "upright"


def test_a_match_is_struck_before_the_breast_not_where_it_lay(bodies: dict[str, RiggedBody]) -> None:
    props = {"match": StageProp(world_at(3, 0, 0.75), (0.01, 0.01, 0.06))}
    marks = (mark_at("man", 0, 0, held=(("R", "match"),)),)
    shot = perform(bodies, marks, (cue_of("man", "press", 2, prop_id="match", hand="R"),), 3, props=props)
    assert shot.problems == ()
    hands = [Playback(bodies["man"], shot, "man").joint(f"hand.{side}", 18) for side in "LR"]
    assert (hands[0] - hands[1]).length < 0.35
    assert min(hand.z for hand in hands) > 0.9


def test_two_who_stand_too_near_to_embrace_step_back_without_turning_away(bodies: dict[str, RiggedBody]) -> None:
    marks = (mark_at("man", -0.1, 0, 90), mark_at("girl", 0.1, 0, -90))
    shot = perform(bodies, marks, (cue_of("man", "hug", 2, target_id="girl"),), 5)
    yaws = np.degrees(shot.people["man"].root[:, 3])
    assert np.abs(yaws - 90).max() < 20
    assert shot.people["man"].root[-1, 0] < -0.15


@pytest.mark.parametrize("who", ["man", "girl"])
def test_a_coil_of_rope_is_lifted_from_the_floor_with_both_hands(bodies: dict[str, RiggedBody], who: str) -> None:
    rope = {"rope": StageProp(world_at(0, 0.5), (0.37, 0.37, 0.12))}
    pick = cue_of(who, "pick_up", 2, prop_id="rope")
    shot = perform(bodies, (mark_at(who, 0, 0.05, 180),), (pick,), 4, props=rope)
    assert all(problem.amount < 0.12 for problem in shot.problems), "a child's arms are short for it"
    assert who == "girl" or shot.problems == ()
    assert shot.props["rope"][-1, 2, 3] > 0.4
