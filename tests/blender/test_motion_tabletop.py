"""Who sits at a table rests their hands on it; who sits before none, or a low one, on the lap."""

from __future__ import annotations

import math

import bpy
import pytest
from mathutils import Matrix, Vector
from tests.blender.motion_stage import Playback, build_bodies, chair_at, cue_of, mark_at, perform, table_at, world_at

from storyblender.blender.motion.plan import StageFurniture, StageProp
from storyblender.blender.people.body import RiggedBody
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import PropState

pytestmark = pytest.mark.blender
SEATED = mark_at("man", 0, 0.24, 0, "sit", support_id="chair")


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies("man")


def _hands(
    bodies: dict[str, RiggedBody], furniture: dict[str, StageFurniture], props: dict[str, StageProp] | None = None
) -> dict[str, Vector]:
    shot = perform(bodies, (SEATED,), (), 1, furniture={"chair": chair_at(0, 0.24), **furniture}, props=props)
    assert shot.problems == ()
    play = Playback(bodies["man"], shot, "man")
    return {side: play.joint(f"hand.{side}", 12) for side in "LR"}


@pytest.mark.parametrize("gap", [-0.40, -0.50])
def test_hands_lie_on_the_table_one_sits_at(bodies: dict[str, RiggedBody], gap: float) -> None:
    for hand in _hands(bodies, {"table": table_at(0, gap)}).values():
        assert 0.75 < hand.z < 0.86
        assert hand.y < gap + 0.35 + 0.12, "at its edge"


def test_hands_stay_on_the_lap_before_a_low_table_and_where_something_stands(bodies: dict[str, RiggedBody]) -> None:
    low = StageFurniture(
        world_at(0, -0.5), (1.2, 0.7, 0.42), (Anchor(kind="top", name="top", location=(0, 0, 0.42), size=(1.2, 0.7)),)
    )
    assert max(hand.z for hand in _hands(bodies, {"table": low}).values()) < 0.72
    vase = {"vase": StageProp(world_at(0.12, -0.2, 0.75), (0.1, 0.1, 0.3))}
    hands = _hands(bodies, {"table": table_at(0, -0.45)}, vase)
    assert hands["L"].z < 0.72 < hands["R"].z


def test_who_gets_up_from_the_table_takes_their_hands_along(bodies: dict[str, RiggedBody]) -> None:
    furniture = {"chair": chair_at(0, 0.24), "table": table_at(0, -0.5)}
    shot = perform(bodies, (SEATED,), (cue_of("man", "rise", 4),), 4, furniture=furniture)
    play, last = Playback(bodies["man"], shot, "man"), len(shot.frames) - 1
    assert (play.joint("hand.R", last).xy - play.joint("hips", last).xy).length < 0.45


def test_what_is_held_at_a_table_stands_on_it_and_is_lifted_over_it(bodies: dict[str, RiggedBody]) -> None:
    furniture = {"chair": chair_at(0, 0.24), "table": table_at(0, -0.5)}
    props = {
        "glass": StageProp(world_at(3, 3), (0.07, 0.07, 0.12), node_id="glass"),
        "letter": StageProp(world_at(0.05, -0.30, 0.75), (0.22, 0.11, 0.006), node_id="letter"),
    }
    sits = SEATED.model_copy(update={"held": (("R", "glass"),)})
    takes = cue_of("man", "pick_up", 4, prop_id="letter", hand="L")
    shot = perform(bodies, (sits,), (takes,), 4, furniture=furniture, props=props)
    assert shot.problems == ()
    glass, letter = shot.props["glass"], shot.props["letter"]
    assert glass[-1][2][3] == pytest.approx(0.75, abs=0.01)
    assert 0.80 < letter[-1][2][3] < 1.0


@pytest.mark.parametrize(("away", "most"), [(0.5, 33), (0.62, 43)])
def test_who_stands_at_a_table_bows_no_deeper_than_the_hand_needs(
    bodies: dict[str, RiggedBody], away: float, most: float
) -> None:
    props = {"cup": StageProp(world_at(0.05, -away, 0.75), (0.08, 0.08, 0.1), node_id="cup")}
    takes = cue_of("man", "pick_up", 4, prop_id="cup", hand="R")
    shot = perform(bodies, (mark_at("man", 0, 0),), (takes,), 4, props=props)
    assert shot.problems == (), "and the hand is there"
    play = Playback(bodies["man"], shot, "man")
    trunks = [play.joint("neck", frame) - play.joint("hips", frame) for frame in range(10, 60, 4)]
    assert max(math.degrees(math.atan2(trunk.xy.length, trunk.z)) for trunk in trunks) < most


LETTER = {"letter": StageProp(world_at(0.05, -0.45, 0.75), (0.22, 0.11, 0.006), node_id="letter")}


def test_no_finger_comes_through_a_paper_that_is_carried(bodies: dict[str, RiggedBody]) -> None:
    grip = Anchor(kind="grip", name="grip_r", location=(-0.01, 0.04, -0.012), normal=(0, 0, 1), curl=(0.2, 0.2, 0.0))
    letter = {"letter": StageProp(world_at(3, 3), (0.22, 0.11, 0.006), (grip,), node_id="letter")}
    shot = perform(bodies, (mark_at("man", 0, 0, held=(("R", "letter"),)),), (), 1, props=letter)
    play, matrix = Playback(bodies["man"], shot, "man"), Matrix(shot.props["letter"][12].tolist())
    local = [matrix.inverted() @ Vector(point.tolist()) for point in play.skin(12)]
    over = [p for p in local if abs(p.x) < 0.1 and abs(p.y) < 0.05 and 0.012 < p.z < 0.05]
    thumb = [p for p in over if p.x > 0.02 or p.x < -0.05]
    assert len(over) - len(thumb) < 4


def _palm(play: Playback, frame: int) -> Vector:
    """Where the right palm looks."""
    along = play.joint("fingers1.R", frame) - play.joint("hand.R", frame)
    return along.cross(play.joint("fingers1.R", frame) - play.joint("index1.R", frame)).normalized()


@pytest.mark.parametrize("clip", ["pick_up", "put_down"])
def test_a_letter_is_taken_and_laid_down_from_above(bodies: dict[str, RiggedBody], clip: str) -> None:
    held = (("R", "letter"),) if clip == "put_down" else ()
    spot = mark_at("letter", 0.05, -0.45).model_copy(update={"location": (0.05, -0.45, 0.75)})
    cue = cue_of("man", clip, 4, prop_id="letter", hand="R", mark=spot if clip == "put_down" else None)
    shot = perform(bodies, (mark_at("man", 0, 0, held=held),), (cue,), 4, props=LETTER)
    assert shot.problems == ()
    play = Playback(bodies["man"], shot, "man")
    low = min(range(len(shot.frames)), key=lambda frame: play.joint("hand.R", frame).z)
    assert _palm(play, low).z < -0.6, "the palm looks down"
    letter = shot.props["letter"][:, 2, 3]
    assert letter.min() > 0.73, "never in the table"


@pytest.mark.parametrize("jacket", [True, False])
def test_what_is_in_ones_clothes_comes_out_by_hand(bodies: dict[str, RiggedBody], jacket: bool) -> None:
    pistol = StageProp(world_at(3, 3), (0.03, 0.2, 0.14), state=PropState(asset_id="pistol", held_by="man"))
    cue = cue_of("man", "take", 4, target_id="man", prop_id="pistol", hand="R")
    shot = perform(bodies, (mark_at("man", 0, 0),), (cue,), 3, props={"pistol": pistol}, jackets=jacket)
    assert shot.problems == ()
    play = Playback(bodies["man"], shot, "man")
    place, bone = shot.props["pistol"][:, :3, 3], "upper_chest" if jacket else "hips"
    assert all((Vector(place[frame].tolist()) - play.joint(bone, frame)).length < 0.12 for frame in (0, 20))
    reached = (play.joint("hand.R", 26) - play.joint(bone, 26)).length
    assert reached < 0.36, "the hand goes where it is"
    assert (play.joint("hand.R", 26).y < play.joint(bone, 26).y) == jacket, "in front at the breast, behind at the hip"
    assert (Vector(place[-1].tolist()) - play.joint("hand.R", len(place) - 1)).length < 0.2


def test_a_ring_goes_on_a_finger_of_the_other_hand_and_stays_there(bodies: dict[str, RiggedBody]) -> None:
    ring = {"ring": StageProp(world_at(3, 3), (0.02, 0.01, 0.03))}
    mark = mark_at("man", 0, 0, held=(("L", "ring"),))
    shot = perform(bodies, (mark,), (cue_of("man", "dress", 2, prop_id="ring", hand="L"),), 3, props=ring)
    play, path = Playback(bodies["man"], shot, "man"), shot.props["ring"][:, :3, 3]
    assert (Vector(path[0].tolist()) - play.joint("hand.L", 0)).length < 0.15
    meeting = play.joint("hand.R", 36)
    assert (meeting - play.joint("hand.L", 36)).length < 0.38 and meeting.z > 1.05, "before the chest"
    last = len(path) - 1
    assert (Vector(path[last].tolist()) - play.joint("hand.R", last)).length < 0.15


def test_a_hand_that_does_not_reach_is_told_by_how_much_and_from_what(bodies: dict[str, RiggedBody]) -> None:
    furniture = {"chair": chair_at(0, 0.24), "table": table_at(0, -1.2)}
    cup = {"cup": StageProp(world_at(0.1, -1.4, 0.75), (0.08, 0.08, 0.1))}
    shot = perform(bodies, (SEATED,), (cue_of("man", "pick_up", 4, prop_id="cup"),), 4, furniture=furniture, props=cup)
    (miss,) = (problem for problem in shot.problems if problem.kind == "unreachable")
    assert miss.message == f"man's hand misses cup by {miss.amount:.2f} m"
    assert 0.3 < miss.amount < 1.5


def test_a_hand_that_does_not_reach_into_a_box_is_told(bodies: dict[str, RiggedBody]) -> None:
    furniture = {"chair": chair_at(0, 0.24)}
    props = {
        "box": StageProp(world_at(0.2, -2.0, 0.0), (0.5, 0.4, 0.4)),
        "cup": StageProp(world_at(0.2, -2.0, 0.1), (0.08, 0.08, 0.1)),
    }
    cues = (cue_of("man", "take", 4, prop_id="cup", target_id="box"),)
    shot = perform(bodies, (SEATED,), cues, 4, furniture=furniture, props=props)
    (miss,) = (problem for problem in shot.problems if problem.kind == "unreachable")
    assert miss.amount > 0.5 and "misses cup" in miss.message
