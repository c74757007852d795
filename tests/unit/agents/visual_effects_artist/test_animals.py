"""Animals on their own feet: they come in, go to whom they are said to go to, and stay where they have gone."""

from __future__ import annotations

import math
from types import SimpleNamespace

from storyblender.agents.visual_effects_artist.animals import Animals
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import CharacterAction

DOG = Asset(
    asset_id="dog",
    asset_type="object",
    description="dog",
    tags=("animal",),
    canonical=CanonicalAsset(source="catalog", key="dog", dimensions=(0.3, 0.9, 0.7), digest="x"),
)


def _animals() -> Animals:
    floor = SimpleNamespace(
        free_spot=lambda wish, *_, **__: wish, thing=lambda name: None, enter_marks=lambda: [(-4.0, 0.0)]
    )
    nora = SimpleNamespace(place=(3.0, 0.0), present=True)
    stage = SimpleNamespace(floor=floor, people={"nora": nora})
    home = LayoutObject(node_id="dog", asset_id="dog", location=(0.0, 0.0, 0.0))
    return Animals(stage, [DOG], [home])  # type: ignore[arg-type]


def _shot(motion: str, target: str | None = None, *, flies: bool = False):
    action = CharacterAction(asset_id="dog", action_description="", motion=motion, target_id=target, flies=flies)
    return SimpleNamespace(character_actions=(action,))


def test_a_dog_comes_in_to_its_place_from_where_people_come_in() -> None:
    (cue,), (state,) = _animals().play(_shot("walk"), 24, 120)  # type: ignore[arg-type]
    assert state.location is not None and state.location[0] < -1
    assert cue.mark is not None and math.dist(cue.mark.location[:2], (0, 0)) < 0.1


def test_it_stops_beside_whom_it_goes_to_facing_them_and_is_there_in_the_next_shot() -> None:
    animals = _animals()
    (cue,), _ = animals.play(_shot("run", "nora"), 24, 120)  # type: ignore[arg-type]
    assert cue.mark is not None and 0.5 < math.dist(cue.mark.location[:2], (3, 0)) < 1.5
    assert abs(cue.mark.yaw - 90) < 1
    cues, (state,) = animals.play(SimpleNamespace(character_actions=()), 24, 120)  # type: ignore[arg-type]
    assert not cues and state.location == cue.mark.location


def test_a_look_is_a_turn_and_a_bird_that_flies_is_off_the_floor() -> None:
    (turn,), _ = _animals().play(_shot("look", "nora"), 24, 120)  # type: ignore[arg-type]
    assert turn.clip == "turn" and turn.mark is not None and turn.mark.location == (0.0, 0.0, 0.0)
    (flight,), _ = _animals().play(_shot("walk", "nora", flies=True), 24, 120)  # type: ignore[arg-type]
    assert flight.mark is not None and flight.mark.location[2] > 1
