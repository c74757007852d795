"""Things are in the hand that the script names."""

from __future__ import annotations

import pytest

from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.prop_states import find_prop_states
from storyblender.catalog.carrying import ON_BODY, body_place_of
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, CharacterLook, Garment
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.memory.vocabulary import BodyPlace, Grip, Hand


@pytest.mark.parametrize(
    ("grip", "held"),
    [("left", {"L": "cup"}), ("both", {"L": "cup", "R": "cup"}), ("worn", {}), (None, {"R": "cup"})],
)
def test_a_thing_is_held_as_the_script_says(grip: Grip | None, held: dict[Hand, str]) -> None:
    person = StagedPerson("ann", 1.0, held={"R": "cup"})
    person.set_grip("cup", grip)
    assert person.held == held


def test_a_hand_that_holds_something_else_keeps_it() -> None:
    person = StagedPerson("ann", 1.0, held={"R": "cup", "L": "lamp"})
    person.set_grip("cup", "left")
    assert person.held == {"R": "cup", "L": "lamp"}


@pytest.mark.parametrize("grip", sorted(ON_BODY))
def test_what_is_on_the_body_leaves_the_hands_free(grip: Grip) -> None:
    person = StagedPerson("ann", 1.0, held={"R": "cup", "L": "lamp"})
    person.set_grip("cup", grip)
    assert person.held == {"L": "lamp"} and person.on_body == {"cup": grip}
    person.let_go("cup")
    assert not person.on_body


@pytest.mark.parametrize(
    ("grip", "key", "place"),
    [
        ("worn", "hat", "head"),
        ("worn", "glasses", "face"),
        ("worn", "folded_clothes", None),
        ("under_arm", "book", "under_arm"),
        ("mouth", "cigarette", "mouth"),
        ("right", "hat", None),
    ],
)
def test_a_grip_says_where_on_the_body_a_thing_is(grip: Grip, key: str, place: BodyPlace | None) -> None:
    assert body_place_of(grip, key) == place


@pytest.mark.parametrize("dressed", [False, True])
def test_what_is_worn_is_shown_once_and_is_in_no_hand(dressed: bool) -> None:
    hat = _asset("hat", None)
    ann = _asset("ann", CharacterLook(garments=(Garment(key="hat"),) if dressed else ()))
    person = StagedPerson("ann", 1.0, on_body={"hat": "worn"}, present=True)
    shot = ShotContext(scene_id=1, shot_id=1, on_stage=("ann",), camera_instruction=CameraInstruction())
    (state,) = find_prop_states(shot, ["hat"], {}, lambda _: person, {"hat": hat, "ann": ann})
    assert (state.held_by, state.hand) == ("ann", None)
    assert (state.visible, state.place) == ((False, None) if dressed else (True, "head"))


def _asset(key: str, look: CharacterLook | None) -> Asset:
    canonical = CanonicalAsset(source="catalog", key=key, dimensions=(0.3, 0.3, 0.15), digest="d")
    kind = "object" if look is None else "character"
    return Asset(asset_id=key, asset_type=kind, description=key, canonical=canonical, look=look)
