"""Two together: they embrace and part, kiss lip to lip, and dance round each other without stepping on each other."""

from __future__ import annotations

import math

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from tests.blender.motion_stage import Playback, build_bodies, chair_at, cue_of, mark_at, perform, world_at

from storyblender.blender.motion.clips.embraces import LIPS
from storyblender.blender.motion.plan import StageFurniture, StageProp
from storyblender.blender.people.body import RiggedBody

pytestmark = pytest.mark.blender


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies("man", "woman")


def _lips(play: Playback, frame: int) -> Vector:
    body, index = play.body, play.index
    eyes = [Vector(body.heads[index[f"eye.{side}"]].tolist()) for side in "LR"]
    at_rest = (eyes[0] + eyes[1]) / 2 + LIPS * (body.stature / 1.7)
    rest = Matrix(body.rest[index["head"]].tolist())
    return play.matrices(frame)["head"] @ rest.inverted() @ at_rest


MARKS = (mark_at("man", -0.6, 0, 90), mark_at("woman", 0.6, 0, -90))


def test_who_kisses_touches_the_others_lips_with_theirs(bodies: dict[str, RiggedBody]) -> None:
    shot = perform(bodies, MARKS, (cue_of("man", "kiss", 2, target_id="woman", duration=120),), 4)
    lips = [_lips(Playback(bodies[who], shot, who), 90) for who in ("man", "woman")]
    assert (lips[0] - lips[1]).length < 0.02


def test_an_embrace_is_held_as_long_as_wanted_and_left_for_the_mark(bodies: dict[str, RiggedBody]) -> None:
    end = mark_at("man", -0.1, 0, 90)
    shot = perform(bodies, MARKS, (cue_of("man", "hug", 2, target_id="woman", mark=end),), 7, ends=(end,))
    assert shot.problems == ()
    gap = np.linalg.norm(shot.people["man"].root[:, :2] - shot.people["woman"].root[:, :2], axis=1)
    assert gap.min() < 0.4
    assert gap[-1] == pytest.approx(0.7, abs=0.02)
    held = perform(bodies, MARKS, (cue_of("man", "hug", 2, target_id="woman", duration=166),), 7, ends=(end,))
    back = Playback(bodies["woman"], held, "woman").joint("upper_chest", 165)
    assert (Playback(bodies["man"], held, "man").joint("hand.R", 165) - back).length < 0.3, "still in each other's arms"


def test_a_couple_turns_round_in_each_others_arms(bodies: dict[str, RiggedBody]) -> None:
    marks = (mark_at("man", -0.3, 0, 90), mark_at("woman", 0.3, 0, -90))
    shot = perform(bodies, marks, (cue_of("man", "dance", 2, target_id="woman", duration=170),), 9.5)
    roots = {who: shot.people[who].root for who in ("man", "woman")}
    turned = np.degrees(np.ptp(roots["woman"][:, 3]))
    assert turned == pytest.approx(360, abs=5)
    play = {who: Playback(bodies[who], shot, who) for who in roots}
    for frame in range(50, 180, 10):
        assert (play["man"].joint("hand.L", frame) - play["woman"].joint("hand.R", frame)).length < 0.16
        toes = {who: [play[who].joint(f"toe.{side}", frame).xy for side in "LR"] for who in roots}
        assert min((a - b).length for a in toes["man"] for b in toes["woman"]) > 0.05, frame
        facing = roots["man"][frame, 3] - roots["woman"][frame, 3]
        assert math.cos(facing) == pytest.approx(-1, abs=0.02)


def test_where_there_is_no_room_to_go_round_a_couple_turns_to_and_fro(bodies: dict[str, RiggedBody]) -> None:
    walls = {f"wall_{y}": StageFurniture(np.array(Matrix.Translation((0, y, 0))), (3, 0.1, 2)) for y in (-0.4, 0.4)}
    marks = (mark_at("man", -0.25, 0, 90), mark_at("woman", 0.25, 0, -90))
    shot = perform(bodies, marks, (cue_of("man", "dance", 2, target_id="woman"),), 5, furniture=walls)
    assert np.abs(shot.people["man"].root[:, 1]).max() < 0.12
    assert 15 < np.degrees(np.ptp(shot.people["man"].root[:, 3])) < 50


def test_a_hand_that_holds_a_staff_stays_with_it_in_an_embrace(bodies: dict[str, RiggedBody]) -> None:
    marks = (MARKS[0].model_copy(update={"held": (("R", "staff"),)}), MARKS[1])
    props = {"staff": StageProp(world_at(0, 0), (0.04, 0.04, 1.4))}
    shot = perform(bodies, marks, (cue_of("man", "hug", 2, target_id="woman", duration=166),), 7, props=props)
    man, woman = (Playback(bodies[who], shot, who) for who in ("man", "woman"))
    hands = {side: (man.joint(f"hand.{side}", 160) - woman.joint("upper_chest", 160)).length for side in "LR"}
    assert hands["L"] < 0.3 < hands["R"]


def test_who_sits_takes_with_the_hand_that_is_towards_the_giver(bodies: dict[str, RiggedBody]) -> None:
    chair = {"chair": chair_at(0, 0)}
    sitter = mark_at("woman", 0, -0.24, posture="sit", support_id="chair")
    props = {"cup": StageProp(world_at(0, 0), (0.08, 0.08, 0.1))}
    for x, hand in ((0.75, "L"), (-0.75, "R")):
        yaw = math.degrees(math.atan2(-x, 0.55))
        giver = mark_at("man", x, -0.75, yaw, held=(("R", "cup"),))
        cues = (cue_of("man", "give", 2, target_id="woman", prop_id="cup"),)
        shot = perform(bodies, (giver, sitter), cues, 4, furniture=chair, props=props)
        cup = Vector(shot.props["cup"][-1][:3, 3].tolist())
        near = {
            side: (Playback(bodies["woman"], shot, "woman").joint(f"hand.{side}", 95) - cup).length for side in "LR"
        }
        assert min(near, key=lambda side: near[side]) == hand
