"""Shots solved on real bodies: contact, planted feet, furniture, hand-overs, every clip on small and tall people."""

from __future__ import annotations

import math

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from tests.blender.motion_stage import (
    FPS,
    Playback,
    build_bodies,
    chair_at,
    cue_of,
    mark_at,
    perform,
    table_at,
    world_at,
)
from tests.every import every

from storyblender.blender.motion.clips import CLIPS
from storyblender.blender.motion.measures import measure
from storyblender.blender.motion.plan import (
    StageFurniture,
    StagePerson,
    StagePlan,
    StageProp,
    box_of,
)
from storyblender.blender.motion.solve import solve_shot
from storyblender.blender.people.body import RiggedBody
from storyblender.catalog.motions import MOTIONS
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import Blocking
from storyblender.memory.vocabulary import Posture

pytestmark = pytest.mark.blender


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies()


@pytest.mark.parametrize("who", ["man", "girl"])
def test_a_walk_arrives_on_the_mark_and_no_planted_foot_slides(bodies: dict[str, RiggedBody], who: str) -> None:
    end = mark_at(who, 2.0, 1.0, 45)
    shot = perform(bodies, (mark_at(who, -2, 0, 90),), (cue_of(who, "walk", 4, mark=end),), 6, ends=(end,))
    assert shot.problems == ()
    x, y, _, yaw = shot.people[who].root[-1]
    assert (x, y) == pytest.approx((2, 1), abs=0.01)
    assert math.degrees(yaw) % 360 == pytest.approx(45, abs=1)
    play = Playback(bodies[who], shot, who)
    floor = measure(bodies[who]).ankle
    for side in "LR":
        feet = [(play.joint(f"toe.{side}", f), play.joint(f"foot.{side}", f)) for f in range(0, len(shot.frames))]
        flat = [abs(foot.z - floor) < 0.003 for _, foot in feet]
        slides = [
            (b[1].xy - a[1].xy).length
            for a, b, still, then in zip(feet, feet[1:], flat, flat[1:], strict=False)
            if still and then
        ]
        assert len(slides) > 10
        assert np.percentile(slides, 90) < 0.002
        assert max(slides) < 0.02
        assert min(toe.z for toe, _ in feet) > -0.01


def test_nobody_walks_through_a_table(bodies: dict[str, RiggedBody]) -> None:
    end = mark_at("man", 0, 2.2, 0)
    furniture = {"table": table_at(0, 0.5)}
    shot = perform(
        bodies, (mark_at("man", 0, -1.5, 180),), (cue_of("man", "walk", mark=end),), 7, ends=(end,), furniture=furniture
    )
    assert shot.problems == ()
    play = Playback(bodies["man"], shot, "man")
    for frame in range(0, len(shot.frames), 6):
        skin = play.skin(frame)
        depth = np.minimum(0.6 - np.abs(skin[:, 0]), 0.35 - np.abs(skin[:, 1] - 0.5))
        inside = (depth > 0.03) & (skin[:, 2] < 0.75)
        assert not inside.any(), (frame, depth[inside].max())


@pytest.mark.parametrize("who", ["man", "girl"])
def test_sitters_touch_the_seat_from_the_first_frame_and_after_sitting_down(
    bodies: dict[str, RiggedBody], who: str
) -> None:
    chair = {"chair": chair_at(0, 0.24)}
    seated = mark_at(who, 0, 0, 0, "sit", support_id="chair")
    already = perform(bodies, (seated,), (), 1, furniture=chair)
    down = perform(
        bodies, (mark_at(who, -1, -1, 30),), (cue_of(who, "sit", 2, mark=seated),), 8, ends=(seated,), furniture=chair
    )
    assert already.problems == down.problems == ()
    for shot, frame in ((already, 0), (down, -1 % len(down.frames))):
        play = Playback(bodies[who], shot, who)
        skin = play.skin(frame)
        on_seat = (np.abs(skin[:, 0]) < 0.23) & (skin[:, 1] > 0.02) & (skin[:, 1] < 0.40) & (skin[:, 2] < 0.7)
        lowest = np.percentile(skin[on_seat][:, 2], 1)
        assert lowest == pytest.approx(0.45, abs=0.03)
        assert skin[skin[:, 2] > 0.5][:, 1].max() < 0.47, "nobody sits through the backrest"
        assert shot.people[who].seated[frame] == pytest.approx(1, abs=0.01)


def test_rising_from_a_seat_at_a_table_goes_to_the_side(bodies: dict[str, RiggedBody]) -> None:
    furniture = {"chair": chair_at(0, 0.24), "table": table_at(0, -0.55)}
    seated = mark_at("man", 0, 0, 0, "sit", support_id="chair")
    shot = perform(bodies, (seated,), (cue_of("man", "rise", 4),), 4, furniture=furniture)
    x, y = shot.people["man"].root[-1, :2]
    assert abs(x) > 0.4
    assert y > -0.3


def test_a_letter_changes_hands(bodies: dict[str, RiggedBody]) -> None:
    letter = StageProp(world_at(0, 0, -5), (0.11, 0.22, 0.01))
    marks = (mark_at("man", -1.0, 0, 90, held=(("R", "letter"),)), mark_at("girl", 0.5, 0, -90))
    shot = perform(
        bodies, marks, (cue_of("man", "give", 2, target_id="girl", prop_id="letter"),), 6,
        ends=(mark_at("man", -0.3, 0, 90),), props={"letter": letter},
    )  # fmt: skip
    assert [p.kind for p in shot.problems] == []
    man, girl = (Playback(bodies[who], shot, who) for who in ("man", "girl"))
    path = shot.props["letter"]
    first, last = Vector(path[0, :3, 3].tolist()), Vector(path[-1, :3, 3].tolist())
    assert (first - man.joint("hand.R", 0)).length < 0.3
    assert (last - girl.joint("hand.R", len(path) - 1)).length < 0.3
    steps = np.linalg.norm(np.diff(path[:, :3, 3], axis=0), axis=1)
    assert steps.max() < 0.12, "the letter does not jump"


def test_a_cup_is_picked_up_where_it_stands(bodies: dict[str, RiggedBody]) -> None:
    cup = StageProp(world_at(0.1, 0.35, 0.75), (0.08, 0.08, 0.1))
    furniture = {"table": table_at(0, 0.6)}
    shot = perform(
        bodies, (mark_at("man", 0, -0.05, 180),), (cue_of("man", "pick_up", 2, prop_id="cup"),), 3.5,
        furniture=furniture, props={"cup": cup},
    )  # fmt: skip
    assert [p.kind for p in shot.problems] == []
    height = shot.props["cup"][:, 2, 3]
    assert height[0] == pytest.approx(0.75)
    assert height.min() > 0.73
    assert height[-1] > 0.85


@pytest.mark.parametrize("yaw", [0, 90, 180, 270])
def test_a_letter_is_reached_across_a_table_however_it_lies(bodies: dict[str, RiggedBody], yaw: float) -> None:
    grip = Anchor(kind="grip", name="grip_r", location=(-0.01, 0.04, -0.012), direction=(0, -1, 0), normal=(0, 0, 1))
    letter = StageProp(world_at(0.05, 0.475, 0.75, yaw), (0.22, 0.11, 0.006), (grip,))
    shot = perform(
        bodies, (mark_at("man", 0, -0.1, 180),), (cue_of("man", "pick_up", 2, prop_id="letter"),), 3.5,
        furniture={"table": table_at(0, 0.6)}, props={"letter": letter},
    )  # fmt: skip
    assert shot.problems == ()
    steps = np.linalg.norm(np.diff(shot.props["letter"][:, :3, 3], axis=0), axis=1)
    assert steps.max() < 0.12, "the letter does not jump into the hand"


@pytest.mark.parametrize("who", ["man", "girl"])
def test_a_guitar_is_played_across_the_body(bodies: dict[str, RiggedBody], who: str) -> None:
    guitar = StageProp(world_at(0, 0, -5), (0.34, 0.12, 1.0))
    cue = cue_of(who, "play_piano", 2, prop_id="guitar", duration=70)
    shot = perform(bodies, (mark_at(who, 0, 0, 90, held=(("R", "guitar"),)),), (cue,), 3, props={"guitar": guitar})
    assert shot.problems == ()
    matrix = Matrix(shot.props["guitar"][50].tolist())
    neck, strings = matrix.to_3x3().col[2], -matrix.to_3x3().col[1]
    assert abs(neck.z) < 0.6
    assert neck.y > 0.7, "to the left of somebody who faces +X"
    assert strings.x > 0.7
    play = Playback(bodies[who], shot, who)
    reach = 0.16 + 0.08 * (who == "girl")
    assert (play.joint("hand.L", 50) - matrix @ Vector((0, 0, 0.64))).length < reach
    assert (play.joint("hand.R", 50) - matrix @ Vector((0, -0.08, 0.3))).length < reach + 0.06


def test_who_walks_into_an_embrace_walks_through_nobody(bodies: dict[str, RiggedBody]) -> None:
    end = mark_at("man", 0.0, 0.0, 90)
    cues = (cue_of("man", "walk", 2, mark=end), cue_of("man", "hug", 60, target_id="girl"))
    marks = (mark_at("man", -1.5, 0, 90), mark_at("girl", 0.34, 0, -90))
    shot = perform(bodies, marks, cues, 6, ends=(end,))
    assert [p.kind for p in shot.problems] == []


def test_a_door_is_opened_by_its_handle(bodies: dict[str, RiggedBody]) -> None:
    handle = Anchor(kind="handle", location=(-0.35, -0.05, 1.0))
    door = StageFurniture(world_at(0, 0.6), (0.9, 0.15, 2.0), (handle,), "door")
    plan = StagePlan(
        people={"man": StagePerson(bodies["man"], Blocking(start=(m := mark_at("man", -0.3, 0.1, 180)), end=m))},
        frames=3 * FPS,
        cues=(cue_of("man", "open", 2, target_id="door_1"),),
        furniture={"door_1": door},
    )
    shot = solve_shot(plan, FPS)
    assert shot.problems == ()
    hand = Playback(bodies["man"], shot, "man").joint("hand.R", 22)
    assert (hand - Vector((-0.35, 0.55, 1.0))).length < 0.16
    assert shot.grasps["man", 2] == pytest.approx(2 / FPS + 0.9, abs=0.05)


def test_what_cannot_be_staged_is_told(bodies: dict[str, RiggedBody]) -> None:
    walls = {
        f"wall_{i}": StageFurniture(world_at(x, y), size)
        for i, (x, y, size) in enumerate(
            [(0, 1, (2, 0.1, 2)), (0, -1, (2, 0.1, 2)), (1, 0, (0.1, 2, 2)), (-1, 0, (0.1, 2, 2))]
        )
    }
    goal = mark_at("man", 3, 0)
    cues = (cue_of("man", "walk", mark=goal), cue_of("man", "sit", 30, target_id="throne"))
    shot = perform(bodies, (mark_at("man", 0, 0),), cues, 2, ends=(goal,), furniture=walls)
    assert {"no_path", "missing", "no_support", "late"} <= {problem.kind for problem in shot.problems}


def test_same_plan_same_performance(bodies: dict[str, RiggedBody]) -> None:
    cues = (cue_of("man", "talk", 0, duration=40, mood="angry"), cue_of("man", "look_around", 50))
    one, two = (perform(bodies, (mark_at("man", 0, 0),), cues, 3) for _ in range(2))
    assert np.array_equal(one.people["man"].rotations, two.people["man"].rotations)
    assert np.array_equal(one.people["man"].face, two.people["man"].face)


def test_the_catalog_and_the_clips_agree() -> None:
    assert set(CLIPS) == set(MOTIONS)


@every("clip", sorted(CLIPS))
def test_every_clip_plays_on_everybody_without_leaving_the_floor(bodies: dict[str, RiggedBody], clip: str) -> None:
    furniture = {"table": table_at(0, 1.2), "chair": chair_at(-1.6, 0.5)}
    props = {"cup": StageProp(world_at(0.2, 0.98, 0.75), (0.08, 0.08, 0.1))}
    marks = (mark_at("man", -0.2, -0.3, 150, held=(("L", "cup"),)), mark_at("girl", 1.0, -0.6, -60))
    reach = MOTIONS[clip].reach
    target = {"person": "girl", "thing": "table"}.get(reach)
    if clip in ("sit",):
        target = "chair"
    if clip == "lie_down":
        target = None
    fields: dict[str, object] = {"target_id": target}
    if clip in ("walk", "run", "hurry", "sneak", "stagger", "crawl"):
        fields["mark"] = mark_at("man", -1.0, -2.0, 20)
    if MOTIONS[clip].hands == 1:
        fields["prop_id"] = "cup"
    shot = perform(bodies, marks, (cue_of("man", clip, 2, **fields),), 4, furniture=furniture, props=props)
    assert not [p for p in shot.problems if p.kind in ("missing", "no_path")]
    for who in ("man", "girl"):
        track = shot.people[who]
        assert np.isfinite(track.rotations).all()
        assert np.allclose(np.linalg.norm(track.rotations, axis=2), 1, atol=1e-5)
        turns = np.abs(np.einsum("nbq,nbq->nb", track.rotations[1:], track.rotations[:-1]))
        if clip != "upside_down":  # which nobody comes to by moving: it is how a shot begins
            assert np.degrees(2 * np.arccos(np.clip(turns, 0, 1))).max() < 75, "no bone snaps within a frame"
        assert np.abs(np.diff(track.root[:, :2], axis=0)).max() < 0.25
        play = Playback(bodies[who], shot, who)
        for frame in (len(shot.frames) // 2, len(shot.frames) - 1):
            assert min(m.translation.z for m in play.matrices(frame).values()) > -0.05


def test_who_has_no_room_between_a_person_and_a_wall_passes_sideways(bodies: dict[str, RiggedBody]) -> None:
    start, end, girl = mark_at("man", 0.15, -1.4, 180), mark_at("man", 0.15, 1.2, 180), mark_at("girl", -0.18, 0, 90)
    walls = {f"wall_{x}": StageFurniture(world_at(x, 0), (0.1, 4.0, 2.0)) for x in (-0.42, 0.42)}
    plan = StagePlan(
        people={
            "man": StagePerson(bodies["man"], Blocking(start=start, end=end)),
            "girl": StagePerson(bodies["girl"], Blocking(start=girl, end=girl)),
        },
        frames=8 * FPS,
        cues=(cue_of("man", "walk", 2, mark=end),),
        obstacles=tuple(box_of(node, wall) for node, wall in walls.items()),
        bounds=(-0.5, -2.0, 0.5, 2.0),
    )
    shot = solve_shot(plan, FPS)
    assert [problem.kind for problem in shot.problems if problem.kind in ("no_path", "late")] == []
    assert shot.people["man"].root[-1, 1] == pytest.approx(1.2, abs=0.05)


def test_who_sits_on_a_parcel_sits_on_top_of_it(bodies: dict[str, RiggedBody]) -> None:
    parcel = {"parcel": StageFurniture(world_at(0, 0.2), (0.5, 0.4, 0.4), (), "parcel")}
    shot = perform(bodies, (mark_at("man", 0, 0, 0, "sit", support_id="parcel"),), (), 1, furniture=parcel)
    assert shot.problems == ()
    skin = Playback(bodies["man"], shot, "man").skin(0)
    over = (np.abs(skin[:, 0]) < 0.22) & (skin[:, 1] > 0.02) & (skin[:, 1] < 0.38) & (skin[:, 2] < 0.8)
    assert np.percentile(skin[over][:, 2], 1) == pytest.approx(0.4, abs=0.03)


def test_who_pushes_a_boat_stays_at_its_side(bodies: dict[str, RiggedBody]) -> None:
    bench = Anchor(kind="top", location=(0, 0, 0.5), size=(0.3, 0.3))
    boat = {"boat": StageFurniture(world_at(0, 1.2), (3.0, 1.6, 0.7), (bench,), "boat")}
    beside = mark_at("man", 1.2, 0.05, 180)
    shot = perform(bodies, (beside,), (cue_of("man", "push", 2, target_id="boat"),), 5, furniture=boat)
    assert shot.problems == ()
    assert np.linalg.norm(shot.people["man"].root[:, :2] - (1.2, 0.05), axis=1).max() < 0.1


def test_who_pushes_what_they_hold_does_not_walk_to_where_it_was(bodies: dict[str, RiggedBody]) -> None:
    letter = StageProp(world_at(3, 0, 0.8), (0.11, 0.22, 0.01))
    holding = mark_at("man", 0, 0, 0, held=(("R", "letter"),))
    shot = perform(bodies, (holding,), (cue_of("man", "push", 2, prop_id="letter"),), 5, props={"letter": letter})
    assert np.linalg.norm(shot.people["man"].root[:, :2], axis=1).max() < 0.1


def test_a_letter_is_given_to_who_sits(bodies: dict[str, RiggedBody]) -> None:
    letter = StageProp(world_at(0, 0, -5), (0.11, 0.22, 0.01))
    seated = mark_at("girl", 0, 0, 0, "sit", support_id="chair")
    marks = (mark_at("man", 0, -0.6, 180, held=(("R", "letter"),)), seated)
    shot = perform(
        bodies, marks, (cue_of("man", "give", 2, target_id="girl", prop_id="letter"),), 6,
        props={"letter": letter}, furniture={"chair": chair_at(0, 0.24)},
    )  # fmt: skip
    assert [p.kind for p in shot.problems] == []


@pytest.mark.parametrize("posture", ["hang", "upside_down", "float", "ride", "crawl"])
def test_a_posture_off_the_floor_is_taken_from_the_first_frame(bodies: dict[str, RiggedBody], posture: Posture) -> None:
    horse = {"horse": StageFurniture(world_at(0, 0), (0.6, 2.4, 2.1), (), "horse")}
    support = {"support_id": "horse"} if posture == "ride" else {}
    mark = mark_at("man", 0, 0, 0, posture, **support)
    shot = perform(bodies, (mark,), (), 1, furniture=horse if support else None)
    assert shot.problems == ()
    play = Playback(bodies["man"], shot, "man")
    feet = min(play.joint(f"foot.{side}", 12).z for side in "LR")
    head = play.joint("head", 12).z
    assert (head < feet) == (posture == "upside_down")
    assert feet > (0.3 if posture != "crawl" else 0.05)


@every("posture", ["kneel", "crawl"])
def test_who_kneels_or_crawls_is_on_the_floor_and_not_in_it(posture: Posture, bodies: dict[str, RiggedBody]) -> None:
    for who, body in bodies.items():
        play = Playback(body, perform(bodies, (mark_at(who, 0, 0, 0, posture),), (), 1), who)
        assert -0.012 < play.skin(12)[:, 2].min() < 0.01, who


def test_who_stands_at_a_height_has_feet_and_head_there(bodies: dict[str, RiggedBody]) -> None:
    low, high = (
        Playback(bodies["man"], perform(bodies, (mark,), (), 1), "man")
        for mark in (mark_at("man", 0, 0), mark_at("man", 0, 0, location=(0.0, 0.0, 1.2)))
    )
    for bone in ("foot.L", "head", "hand.R"):
        assert high.joint(bone, 5).z - low.joint(bone, 5).z == pytest.approx(1.2, abs=0.01)


def test_who_looks_at_a_point_in_the_air_stays_on_the_floor(bodies: dict[str, RiggedBody]) -> None:
    look = cue_of("man", "look", 0, mark=mark_at("man", 0, -6, location=(0.0, -6.0, 1.6)))
    play = Playback(bodies["man"], perform(bodies, (mark_at("man", 0, 0),), (look,), 2), "man")
    assert play.joint("foot.L", 40).z == pytest.approx(play.joint("foot.L", 0).z, abs=0.02)


def test_what_is_lasting_goes_on_under_words_and_looks(bodies: dict[str, RiggedBody]) -> None:
    handset = {"handset": StageProp(world_at(0, 0, -5), (0.05, 0.2, 0.05))}
    marks = (mark_at("man", 0, 0, held=(("R", "handset"),)), mark_at("girl", 0, -1.5, 180))
    cues = (
        cue_of("man", "phone", 0, prop_id="handset", hand="R", lasting=True),
        cue_of("man", "talk", 6, target_id="girl", duration=60),
    )
    shot = perform(bodies, marks, cues, 3, props=handset)
    play = Playback(bodies["man"], shot, "man")
    for frame in (0, 30, 70):
        assert (play.joint("hand.R", frame) - play.joint("head", frame)).length < 0.25


def test_a_face_is_kept_for_the_whole_shot(bodies: dict[str, RiggedBody]) -> None:
    cues = (cue_of("man", "face", 0, expression="rage"), cue_of("man", "shrug", 10))
    track = perform(bodies, (mark_at("man", 0, 0),), cues, 3).people["man"]
    brow = track.face[:, track.face_keys.index("brow_down")]
    assert brow[0] > 0.9
    assert brow[-1] > 0.9
