"""Empty hands of people without an action in a shot show the same mood as their faces."""

from __future__ import annotations

import pytest
from test_animator import ASSETS, LAYOUT, PLAN

from storyblender.agents.visual_effects_artist.animator import AnimatorView, RulesAnimator
from storyblender.agents.visual_effects_artist.posture_cues import IDLE_HAND_MOTIONS
from storyblender.catalog.motions import MOTIONS
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, ShotContext


def _hands(state: BodyState, *motions: str) -> set[str]:
    """Return the lasting clips of rick, whose actions these are, while ilsa listens."""
    actions = tuple(CharacterAction(asset_id="rick", action_description=each, motion=each) for each in motions)
    shot = ShotContext(
        scene_id=1,
        shot_id=1,
        on_stage=("rick", "ilsa"),
        states=(state, BodyState(asset_id="ilsa")),
        character_actions=actions,
        camera_instruction=CameraInstruction(),
        duration=96,
    )
    view = AnimatorView(scene_id=1, layout=LAYOUT, plan=PLAN, assets=ASSETS, shots=(shot,))
    cues = RulesAnimator().propose(view).shots[0].cues
    return {cue.clip for cue in cues if cue.asset_id == "rick" and cue.lasting and cue.start == 0}


@pytest.mark.parametrize("expression", IDLE_HAND_MOTIONS)
def test_the_empty_hands_of_who_only_looks_on_are_of_their_mood(expression: str) -> None:
    shown = _hands(BodyState(asset_id="rick", expression=expression))  # type: ignore[arg-type]
    assert shown <= {*IDLE_HAND_MOTIONS[expression]}
    assert shown or "" in IDLE_HAND_MOTIONS[expression]


def test_nobody_has_a_manner_whose_face_is_calm() -> None:
    assert not _hands(BodyState(asset_id="rick"))


def test_who_holds_something_or_speaks_or_acts_has_other_things_to_do_with_their_hands() -> None:
    angry = BodyState(asset_id="rick", expression="angry")
    assert not _hands(angry.model_copy(update={"held": ("letter",)}))
    assert not _hands(angry, "talk")
    assert not _hands(angry, "point")
    assert _hands(angry, "idle")


def test_who_sits_does_not_put_the_hands_on_the_hips() -> None:
    sits = BodyState(asset_id="rick", posture="sit", support_id="chair", expression="rage")
    assert _hands(sits) == {"cross_arms"}


def test_every_manner_is_a_motion_that_lasts() -> None:
    clips = {habit for habits in IDLE_HAND_MOTIONS.values() for habit in habits if habit}
    assert all(MOTIONS[clip].stretches or MOTIONS[clip].lasts for clip in clips), clips
