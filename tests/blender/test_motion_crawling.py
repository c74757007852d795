"""Who crawls is on hands and knees, and what is down stays where it is."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from tests.blender.motion_stage import Playback, build_bodies, cue_of, mark_at, perform

from storyblender.blender.people.body import RiggedBody

pytestmark = pytest.mark.blender


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies()


@pytest.mark.parametrize("who", ["man", "girl"])
def test_who_crawls_goes_on_hands_and_knees_and_stands_up_on_the_mark(bodies: dict[str, RiggedBody], who: str) -> None:
    end = mark_at(who, 0.8, -0.4, 60)
    shot = perform(bodies, (mark_at(who, -1, 0, 90),), (cue_of(who, "crawl", 2, mark=end),), 7.5, ends=(end,))
    assert shot.problems == ()
    play, k = Playback(bodies[who], shot, who), bodies[who].stature / 1.7
    way = range(40, 90)
    joints = {
        bone: np.array([play.joint(bone, frame) for frame in way])
        for bone in ("hand.L", "hand.R", "shin.L", "shin.R", "head")
    }
    assert joints["head"][:, 2].max() < 0.95 * k
    for bone in ("hand.L", "hand.R", "shin.L", "shin.R"):
        spots = joints[bone]
        assert spots[:, 2].max() < 0.2 * k, bone
        steps = np.linalg.norm(np.diff(spots[:, :2], axis=0), axis=1)
        assert (steps < 0.004).sum() > len(steps) / 4, f"{bone} rests between two moves"
        assert steps.max() > 0.015, f"{bone} moves along"
    assert play.joint("head", len(shot.frames) - 1).z > 1.4 * k


def test_who_holds_something_keeps_it_while_crawling(bodies: dict[str, RiggedBody]) -> None:
    end = mark_at("man", 0.5, 0, 90)
    start = mark_at("man", -1, 0, 90, held=(("L", "cup"),))
    shot = perform(bodies, (start,), (cue_of("man", "crawl", 2, mark=end),), 6, ends=(end,))
    play = Playback(bodies["man"], shot, "man")
    assert min(play.joint("hand.R", frame).z for frame in range(40, 80)) < 0.12
    assert shot.problems == ()
