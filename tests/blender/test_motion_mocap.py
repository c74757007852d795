"""Recorded motion on real bodies: our own comes back as it was, feet do not slide, and props stay in the hand."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import bpy
import numpy as np
import pytest
from tests.blender.motion_stage import FPS, Playback, build_bodies, chair_at, cue_of, mark_at, perform
from tests.motion_files import DEPTH_FIRST, Style, Walker, a_person, write_bvh

from storyblender.blender.motion.measures import measure
from storyblender.blender.motion.plan import Performance, StageFurniture, StagePerson, StagePlan, box_of
from storyblender.blender.motion.solve import solve_shot
from storyblender.blender.people.body import RiggedBody
from storyblender.geometry.mocap import MocapPoses
from storyblender.geometry.rotations import about_axis
from storyblender.library.mocap.bvh import parse_bvh
from storyblender.library.mocap.retarget import retarget
from storyblender.memory.shot_context import Blocking, Mark

pytestmark = pytest.mark.blender


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies()


def recorded(body: RiggedBody, shot: Performance, who: str) -> Walker:
    """A solved shot as a file of another program would have it."""
    play = Playback(body, shot, who)
    posed = [play.matrices(frame) for frame in range(len(shot.frames))]
    turns = {
        bone: np.array([np.array(each[bone].to_3x3()) @ body.rest[play.index[bone]][:3, :3].T for each in posed])
        for bone in DEPTH_FIRST
    }
    return Walker(
        {bone: body.heads[play.index[bone]] for bone in DEPTH_FIRST},
        {bone: body.tails[play.index[bone]] for bone in DEPTH_FIRST},
        turns,
        np.array([list(each["hips"].translation) for each in posed]),
        float(FPS),
    )


def replayed(
    body: RiggedBody, poses: MocapPoses, who: str, mark: Mark, end: Mark | None = None, clip: str = "idle",
    furniture: dict[str, StageFurniture] | None = None, extra: float = 0.5,
) -> Performance:  # fmt: skip
    """A shot in which somebody does what is recorded."""
    travels = {"mark": end} if end is not None else {}
    cue = cue_of(who, clip, 0, mocap=poses.digest, duration=round(poses.seconds * FPS), **travels)
    furniture = furniture or {}
    plan = StagePlan(
        people={who: StagePerson(body, Blocking(start=mark, end=end or mark))},
        frames=round((poses.seconds + extra) * FPS),
        cues=(cue,),
        furniture=furniture,
        obstacles=tuple(box_of(node, each) for node, each in furniture.items()),
        seed=3,
        mocap={poses.digest: poses},
    )
    return solve_shot(plan, FPS)


def slides(body: RiggedBody, shot: Performance, who: str) -> np.ndarray:
    """Metres a frame by which heels and balls of feet that are on the floor move along it."""
    play = Playback(body, shot, who)
    found: list[float] = []
    for side in "LR":
        for bone in ("foot", "toe"):
            points = [play.joint(f"{bone}.{side}", frame) for frame in range(len(shot.frames))]
            low = min(point.z for point in points) + 0.004
            found += [(b.xy - a.xy).length for a, b in itertools.pairwise(points) if a.z < low and b.z < low]
    return np.array(found)


@pytest.mark.parametrize(("clip", "length"), [("wave", 3.0), ("dance", 4.0), ("bow", 3.0), ("clap", 3.0)])
def test_our_own_motion_comes_back_within_centimetres(bodies: dict[str, RiggedBody], clip: str, length: float) -> None:
    body, mark = bodies["man"], mark_at("man", 0, 0)
    shot = perform(bodies, (mark,), (cue_of("man", clip, 4),), length + 1)
    poses = retarget(parse_bvh(write_bvh(recorded(body, shot, "man"), Style())))
    again = replayed(body, poses, "man", mark)
    assert again.problems == ()
    one, two = Playback(body, shot, "man"), Playback(body, again, "man")
    frames = range(20, min(len(shot.frames), len(again.frames)) - 24, 3)
    found = {
        late: [
            (one.joint(bone, frame + late).copy() - two.joint(bone, frame)).length
            for frame in frames
            if frame + late < len(shot.frames)
            for bone in ("head", "hand.L", "hand.R", "foot.L", "foot.R", "forearm.L", "forearm.R")
        ]
        for late in range(0, 20)
    }
    best = min(found.values(), key=np.mean)
    assert np.mean(best) < 0.02, "metres"
    assert np.percentile(best, 95) < 0.06


@pytest.mark.parametrize("who", ["man", "girl"])
def test_a_recorded_walk_arrives_on_any_mark_and_no_foot_slides(bodies: dict[str, RiggedBody], who: str) -> None:
    way = perform(bodies, (mark_at("man", 0, 0),), (cue_of("man", "walk", 4, mark=mark_at("man", 0, -3)),), 4.5,
                  ends=(mark_at("man", 0, -3),))  # fmt: skip
    poses = retarget(parse_bvh(write_bvh(recorded(bodies["man"], way, "man"), Style(unit=1.0, up="z"))))
    start, end = mark_at(who, 1, 2, 90), mark_at(who, 3.2, 2.4, 90)
    shot = replayed(bodies[who], poses, who, start, end)
    x, y, _, _ = shot.people[who].root[-1]
    assert (x, y) == pytest.approx((3.2, 2.4), abs=0.02)
    moved = slides(bodies[who], shot, who)
    assert len(moved) > 30
    assert np.percentile(moved, 90) < 0.003
    assert moved.max() < 0.03
    play = Playback(bodies[who], shot, who)
    lows = [play.joint(f"toe.{side}", frame).z for side in "LR" for frame in range(0, len(shot.frames), 2)]
    assert min(lows) > -0.02


def test_it_begins_and_ends_in_what_is_acted(bodies: dict[str, RiggedBody]) -> None:
    body, mark = bodies["man"], mark_at("man", 0, 0)
    shot = perform(bodies, (mark,), (cue_of("man", "dance", 0),), 4)
    poses = retarget(parse_bvh(write_bvh(recorded(body, shot, "man"))))
    again = replayed(body, poses, "man", mark, extra=2.0)
    play = Playback(body, again, "man")
    for bone in ("head", "hand.L", "hand.R", "foot.L", "hips"):
        points = [play.joint(bone, frame).copy() for frame in range(len(again.frames))]
        steps = [(b - a).length for a, b in itertools.pairwise(points)]
        assert max(steps) < 0.16, f"{bone} jumps"
    last, first = play.joint("hand.R", len(again.frames) - 1), play.joint("hand.R", 0)
    assert (last - first).length < 0.08, "at ease again"


def test_who_sits_keeps_the_seat(bodies: dict[str, RiggedBody]) -> None:
    body = bodies["man"]
    shot = perform(bodies, (mark_at("man", 0, 0),), (cue_of("man", "wave", 0),), 3)
    poses = retarget(parse_bvh(write_bvh(recorded(body, shot, "man"))))
    chair, seat = {"chair": chair_at(0, 0.24)}, mark_at("man", 0, 0, 0, "sit", support_id="chair")
    again = replayed(body, poses, "man", seat, clip="talk", furniture=chair)
    play = Playback(body, again, "man")
    hips = [play.joint("hips", frame).z for frame in range(0, len(again.frames), 4)]
    assert max(hips) - min(hips) < 0.02
    hands = [play.joint("hand.R", frame).z for frame in range(0, len(again.frames), 2)]
    assert max(hands) - min(hands) > 0.3, "the arm waves"


def test_a_recording_that_is_gone_is_told_and_acted_otherwise(bodies: dict[str, RiggedBody]) -> None:
    cue = cue_of("man", "wave", 0, mocap="0" * 32)
    shot = perform(bodies, (mark_at("man", 0, 0),), (cue,), 3)
    assert [problem.kind for problem in shot.problems] == ["missing"]
    play = Playback(bodies["man"], shot, "man")
    assert play.joint("hand.R", 30).z > 1.2
    assert math.isclose(float(shot.people["man"].root[-1, 0]), 0.0, abs_tol=1e-6)


def test_who_speaks_faces_in_the_end_whom_they_speak_to(bodies: dict[str, RiggedBody]) -> None:
    turned = a_person(30.0, 3.0, lambda t: {"hips": about_axis(2, np.array(0.5 * t))})
    poses = retarget(parse_bvh(write_bvh(turned)))
    mark = mark_at("man", 0, 0)
    for clip, yaw in (("talk", 0.0), ("idle", 86.0)):
        shot = replayed(bodies["man"], poses, "man", mark, clip=clip)
        assert math.degrees(shot.people["man"].root[-1, 3]) == pytest.approx(yaw, abs=8), clip
        assert slides(bodies["man"], shot, "man").max() < 0.03


def test_a_loop_goes_on_as_long_as_the_speech(bodies: dict[str, RiggedBody]) -> None:
    nods = a_person(30.0, 1.5, lambda t: {"head": about_axis(0, np.array(0.5 * math.sin(2 * math.pi * t / 1.5)))})
    poses = replace(retarget(parse_bvh(write_bvh(nods))), loops=True)
    cue = cue_of("man", "talk", 0, mocap=poses.digest, duration=6 * FPS)
    mark = mark_at("man", 0, 0)
    people = {"man": StagePerson(bodies["man"], Blocking(start=mark, end=mark))}
    shot = solve_shot(StagePlan(people, 6 * FPS, (cue,), mocap={poses.digest: poses}), FPS)
    play = Playback(bodies["man"], shot, "man")
    tilts = [play.matrices(frame)["head"].to_euler().x for frame in range(4 * FPS, 5 * FPS + 12)]
    assert max(tilts) - min(tilts) > 0.5, "it still nods in the fifth second"


@pytest.mark.parametrize("who", ["man", "girl"])
def test_hands_that_meet_meet_on_any_shoulders(bodies: dict[str, RiggedBody], who: str) -> None:
    body, mark = bodies["man"], mark_at("man", 0, 0)
    claps = perform(bodies, (mark,), (cue_of("man", "clap", 0),), 3.5)
    poses = retarget(parse_bvh(write_bvh(recorded(body, claps, "man"), Style(unit=1.0, up="z"))))
    wanted = float(np.percentile(np.linalg.norm(poses.apart, axis=1), 10))
    assert wanted < 0.2, "the hands of the clip meet"
    shot = replayed(bodies[who], poses, who, mark_at(who, 0, 0))
    play, leg = Playback(bodies[who], shot, who), measure(bodies[who]).leg
    frames = range(14, round(poses.seconds * FPS) - 12)
    found = [(play.joint("hand.L", f).copy() - play.joint("hand.R", f)).length / leg for f in frames]
    assert np.percentile(found, 10) == pytest.approx(wanted, abs=0.03)
