"""What an action of the script comes to on its stage: it is done to what is named, and by a motion that shows it."""

from __future__ import annotations

import pytest
from test_animator import ASSETS, PLAN, SIZE

from storyblender.agents.visual_effects_artist.animator import AnimatorView, RulesAnimator, ShotStaging
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Layout, LayoutObject
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, ShotContext

SIZES: dict[str, Vec3] = {
    "post": (0.3, 0.3, 4.0), "key": (0.03, 0.08, 0.01), "fan": (0.5, 0.3, 0.02), "stick": (0.02, 0.42, 0.02),
    "case": (0.45, 0.15, 0.35), "drum": (0.4, 0.4, 0.8), "wall": (2.0, 0.2, 0.9), "flute": (0.02, 0.4, 0.02),
}  # fmt: skip
THINGS = tuple(
    Asset(
        asset_id=name,
        asset_type="object",
        description=name,
        canonical=CanonicalAsset(source="catalog", key=name, dimensions=size, anchors=(), digest="d"),
    )
    for name, size in SIZES.items()
)
PLACES = {
    "rick": (-1.0, -1.0),
    "ilsa": (-0.2, -1.0),
    "post": (2.4, -1.2),
    "drum": (-1.6, -1.4),
    "wall": (2.0, 2.5),
    "flute": (3.7, 3.2),
}
LAYOUT = Layout(
    scene_size=SIZE,
    objects=tuple(
        LayoutObject(node_id=name, asset_id=name, location=(*place, 0), rotation=(0, 0, 0))
        for name, place in PLACES.items()
    ),
)


def _staged(motion: str, state: BodyState | None = None, end: BodyState | None = None, **fields: str) -> ShotStaging:
    action = CharacterAction(asset_id="rick", action_description=motion, motion=motion, **fields)  # type: ignore[arg-type]
    shot = ShotContext(
        scene_id=1,
        shot_id=1,
        on_stage=("rick", "ilsa"),
        states=(state,) if state else (),
        end_states=(end,) if end else (),
        character_actions=(action,),
        camera_instruction=CameraInstruction(),
        duration=120,
    )
    view = AnimatorView(scene_id=1, layout=LAYOUT, plan=PLAN, assets=(*ASSETS, *THINGS), shots=(shot,))
    return RulesAnimator().propose(view).shots[0]


def _done(shot: ShotStaging) -> list[tuple[str, str | None]]:
    return [(cue.clip, cue.target_id) for cue in shot.cues if cue.asset_id == "rick"]


@pytest.mark.parametrize("motion", ["touch", "hug", "kiss", "comfort"])
def test_what_is_done_to_a_thing_is_not_done_to_whoever_stands_near(motion: str) -> None:
    assert all(target != "ilsa" for _, target in _done(_staged(motion, target_id="wall")))


def test_what_is_touched_is_gone_to_and_touched() -> None:
    assert ("touch", "wall") in _done(_staged("touch", target_id="wall"))
    assert any(clip == "walk" for clip, _ in _done(_staged("touch", target_id="wall")))


@pytest.mark.parametrize("motion", ["hold", "take", "pick_up"])
def test_nobody_takes_a_lamp_post_along(motion: str) -> None:
    shot = _staged(motion, target_id="post")
    assert ("touch", "post") in _done(shot)
    assert all(not mark.end.held for mark in shot.blocking)


@pytest.mark.parametrize(("prop", "clip"), [("key", "pocket"), ("fan", "hide_behind")])
def test_who_hides_a_thing_puts_it_away_or_hides_behind_it_and_does_not_crouch(prop: str, clip: str) -> None:
    shot = _staged("hide", BodyState(asset_id="rick", held=(prop,)), prop_id=prop)
    assert clip in [name for name, _ in _done(shot)]
    assert next(mark.end.posture for mark in shot.blocking if mark.end.asset_id == "rick") == "stand"
    assert _staged("hide").blocking[0].end.posture == "crouch"


def test_who_sits_and_hits_nobody_drums_on_their_knees() -> None:
    sits = BodyState(asset_id="rick", posture="sit", support_id="chair")
    assert ("hit", "ilsa") not in _done(_staged("hit", sits))
    assert any(clip == "drum" for clip, _ in _done(_staged("hit", sits)))
    assert ("hit", "ilsa") in _done(_staged("hit"))


@pytest.mark.parametrize(("other", "laid"), [("stick", False), ("case", True)])
def test_a_bag_is_put_aside_for_the_work_of_two_hands_and_a_stick_is_not(other: str, laid: bool) -> None:
    shot = _staged("hit", BodyState(asset_id="rick", held=("key", other)), target_id="drum", prop_id="key")
    assert ("put_down" in [clip for clip, _ in _done(shot)]) is laid


def test_who_floats_swims_where_they_are_and_does_not_stand_up() -> None:
    clips = [clip for clip, _ in _done(_staged("crawl", BodyState(asset_id="rick", posture="float")))]
    assert "float" in clips
    assert "rise" not in clips


@pytest.mark.parametrize("motion", ["phone", "talk"])
def test_a_call_is_on_the_phone_in_the_hand_and_words_do_not_take_it_down(motion: str) -> None:
    state = BodyState(asset_id="rick", held=("key",), activity="phone")
    calls = [cue for cue in _staged(motion, state).cues if cue.clip == "phone"]
    assert [cue.prop_id for cue in calls] == ["key"]
    assert all(cue.lasting for cue in calls)


def test_words_into_a_phone_are_for_nobody_who_stands_near() -> None:
    state = BodyState(asset_id="rick", held=("key",), activity="phone")
    assert ("talk", "ilsa") in _done(_staged("talk"))
    assert ("talk", "ilsa") not in _done(_staged("talk", state))
    assert ("talk", "ilsa") in _done(_staged("talk", state, target_id="ilsa"))


@pytest.mark.parametrize(("motion", "shown"), [("take", True), ("pick_up", True), ("hold", False)])
def test_what_is_taken_from_where_nobody_sees_it_is_held_up(motion: str, shown: bool) -> None:
    shot = _staged(motion, prop_id="flute")
    assert any(cue.clip == "show" and cue.prop_id == "flute" for cue in shot.cues) is shown
