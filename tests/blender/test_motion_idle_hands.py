"""People at ease: hands where their habit is, the weight on one leg and then on the other, feet where they are."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from tests.blender.motion_stage import Playback, build_bodies, cue_of, mark_at, perform, world_at

from storyblender.blender.motion import idle_hands
from storyblender.blender.motion.plan import StageProp
from storyblender.blender.people.body import RiggedBody

pytestmark = pytest.mark.blender


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies("man", "girl")


@pytest.mark.parametrize("habit", ["folded", "behind", "clasped"])
def test_hands_lie_in_each_other_at_ease_and_swing_on_the_way(
    bodies: dict[str, RiggedBody], monkeypatch: pytest.MonkeyPatch, habit: str
) -> None:
    monkeypatch.setattr(idle_hands, "HABITS", (habit,))
    end = mark_at("man", 2.5, 0, 90)
    shot = perform(bodies, (mark_at("man", 0, 0, 90),), (cue_of("man", "walk", 24, mark=end),), 5, ends=(end,))
    play = Playback(bodies["man"], shot, "man")
    assert shot.problems == ()

    def apart(frame: int) -> float:
        return (play.joint("hand.L", frame) - play.joint("hand.R", frame)).length

    assert apart(10) < 0.28
    assert apart(len(shot.frames) - 1) < 0.28
    assert apart(48) > 0.4
    ahead = play.joint("hand.R", 10).x - play.joint("hips", 10).x
    assert (-ahead if habit == "behind" else ahead) > 0.08


def test_children_let_their_hands_hang(bodies: dict[str, RiggedBody], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(idle_hands, "HABITS", ("folded",))
    shot = perform(bodies, (mark_at("girl", 0, 0),), (), 1)
    play = Playback(bodies["girl"], shot, "girl")
    assert (play.joint("hand.L", 10) - play.joint("hand.R", 10)).length > 0.3


def test_the_weight_goes_from_leg_to_leg_over_feet_that_stay(bodies: dict[str, RiggedBody]) -> None:
    shot = perform(bodies, (mark_at("man", 0, 0),), (), 24)
    play = Playback(bodies["man"], shot, "man")
    frames = range(0, len(shot.frames), 12)
    hips = np.array([play.joint("hips", frame).x for frame in frames])
    assert 0.02 < np.ptp(hips) < 0.09
    assert (np.abs(np.diff(hips)) < 0.002).mean() > 0.4, "between two shifts one stands still"
    feet = np.array([tuple(play.joint("foot.L", frame)) for frame in frames])
    assert np.ptp(feet, axis=0).max() < 0.004


@pytest.mark.parametrize(("thickness", "level"), [(0.006, False), (0.02, True)])
def test_papers_are_carried_on_edge_and_plates_level(
    bodies: dict[str, RiggedBody], thickness: float, level: bool
) -> None:
    props = {"thing": StageProp(world_at(0, 0, -5), (0.2, 0.2, thickness))}
    shot = perform(bodies, (mark_at("man", 0, 0, held=(("R", "thing"),)),), (), 1, props=props)
    up = abs(shot.props["thing"][12, 2, 2])
    assert up > 0.98 if level else up < 0.5
