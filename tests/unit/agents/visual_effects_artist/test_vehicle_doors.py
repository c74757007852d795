"""The door of whoever gets in or out stands open in that shot, and no other; it is closed in the next one."""

from __future__ import annotations

import math

import pytest

from storyblender.agents.visual_effects_artist.vehicle_doors import add_open_doors
from storyblender.catalog.states import state_looks
from storyblender.memory.asset_sheet import Anchor, Asset, CanonicalAsset
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import (
    AssetModification,
    Blocking,
    BodyState,
    CameraInstruction,
    Mark,
    ShotContext,
)
from storyblender.memory.thing_states import Condition

_SIDES = {"driver": 1.4, "passenger": -1.4}
_ANCHORS = tuple(
    Anchor(kind="door", name=name, location=(x, -0.3, 0.0), direction=(-math.copysign(1, x), 0, 0))
    for name, x in _SIDES.items()
)
_CAR = Asset(
    asset_id="car", asset_type="object", description="car",
    canonical=CanonicalAsset(source="catalog", key="car", dimensions=(1.8, 4.6, 1.5), anchors=_ANCHORS, digest="c"),
)  # fmt: skip
_PLACE = LayoutObject(node_id="car", asset_id="car", location=(3.0, 2.0, 0.0))


def _shot(number: int, door: str | None, *, boards: bool = False, aboard: bool = False) -> ShotContext:
    place = (3.0 + _SIDES[door] + 0.1, 2.0, 0.0) if door else (-4.0, 0.0, 0.0)
    mark = Mark(asset_id="ann", location=place, yaw=0.0, support_id="car" if aboard else None)
    seated = (BodyState(asset_id="ann", posture="sit", support_id="car"),)
    return ShotContext(
        scene_id=1, shot_id=number, camera_instruction=CameraInstruction(),
        blocking=(Blocking(start=mark, end=mark),), end_states=seated if boards else (),
    )  # fmt: skip


def _states(*shots: ShotContext) -> list[list[tuple[str, tuple[str, ...] | None]]]:
    done = add_open_doors(shots, (_PLACE,), (_CAR,))
    assert add_open_doors(done, (_PLACE,), (_CAR,)) == done, "staged again, it is the same"
    return [[(change.state, change.doors) for change in shot.asset_modifications] for shot in done]


@pytest.mark.parametrize("door", sorted(_SIDES))
def test_the_door_of_who_gets_in_is_open_and_shut_behind_them(door: str) -> None:
    inside = _shot(3, door, aboard=True)
    states = _states(_shot(1, None), _shot(2, door, boards=True), inside)
    assert states == [[], [("open", (door,))], [("closed", ())]]


@pytest.mark.parametrize("door", sorted(_SIDES))
def test_the_door_of_who_gets_out_is_open(door: str) -> None:
    assert _states(_shot(1, door, aboard=True), _shot(2, door), _shot(3, None)) == [
        [], [("open", (door,))], [("closed", ())],
    ]  # fmt: skip


def test_a_door_that_the_script_opens_stays_open_until_it_is_shut() -> None:
    def told(shot: ShotContext, state: str) -> ShotContext:
        change = AssetModification(asset_id="car", modification_type="transform", state=state)
        return shot.model_copy(update={"asset_modifications": (change,)})

    first, second, third = told(_shot(1, None), "open"), _shot(2, None), told(_shot(3, None), "closed")
    states = _states(first, second, third)
    assert [shot[-1:] for shot in states] == [[("open", ("driver",))], [], [("closed", ())]]


def test_who_only_stands_by_a_car_opens_no_door() -> None:
    assert _states(_shot(1, "driver"), _shot(2, "driver")) == [[], []]


def test_an_open_door_is_built_open_and_the_others_are_not() -> None:
    opened = Condition().after("open", doors=("driver",))
    (look,) = state_looks("car", {}, opened)
    assert look.params["open"] == "driver"
    assert state_looks("car", {}, opened.after("closed", doors=())) == ()
