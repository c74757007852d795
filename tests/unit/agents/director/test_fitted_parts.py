"""Parts of vehicles: they are on their vehicle, and people are at, in and on the vehicle, not on loose parts."""

from __future__ import annotations

from typing import Any

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.fitted_parts import FittedParts
from storyblender.agents.director.reading import Deed, Person, Reading, SceneReading, StateChange, Thing, Unit
from storyblender.catalog.parts import PART_PROPS, is_shell, part_box, part_named
from storyblender.catalog.props import PROPS
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.scene_context import Spot
from storyblender.screenplay.fountain import parse

TEXT = "EXT. YARD - DAY\n\nAnn sits down in the sedan.\n"


def _reading(*parts: Thing, kit: str = "", **unit: Any) -> Reading:
    things = [Thing("sedan", "green sedan", kind="vehicle"), *parts]
    one = Unit("action", 0, 1, 17, 44, "Ann sits down in the sedan.", on_stage=["ann"], people=["ann"],
               things=[thing.id for thing in things], **unit)  # fmt: skip
    return Reading(
        parse(TEXT), [Person("ann", "Ann")], things,
        [SceneReading(1, "EXT. YARD - DAY", "YARD", scene_type="outdoor", kit=kit, end=44)], [one],
    )  # fmt: skip


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("driver's seat of the minivan", "seat_driver"), ("steering wheel", "steering_wheel"), ("seat lever", "lever"),
        ("rear-view mirror", "mirror"), ("back seat", "seat_rear"), ("floor mat", "mat"), ("pedals", "pedals"),
        ("spare wheel", ""), ("wing mirror", ""), ("birthday card", ""), ("mirror on the wall", "mirror"),
    ],
)  # fmt: skip
def test_a_name_means_a_part(name: str, part: str) -> None:
    assert part_named(name) == part


def test_every_part_can_be_built() -> None:
    assert {*PART_PROPS.values()} <= {*PROPS}


@pytest.mark.parametrize("part", sorted(PART_PROPS))
def test_a_part_of_a_model_without_parts_is_inside_it(part: str) -> None:
    box = part_box(part, (1.8, 4.5, 1.5), (Anchor(kind="seat", name="driver", location=(0.4, -0.4, 0.47)),))
    assert abs(box.x) + box.width / 2 < 0.9 and abs(box.y) + box.depth / 2 < 2.25 and box.z >= 0 and box.top < 1.5


def test_a_changed_part_is_no_loose_thing() -> None:
    seat = Thing("seat", "driver's seat", kind="set_piece", part_of="sedan")
    board = storyboard(_reading(seat, changes=[StateChange("seat", "one notch forward")], held={"ann": ["seat"]}))
    (asset,) = [asset for asset in board.asset_sheet if asset.asset_id == "seat"]
    assert (asset.fitted_part, asset.part_of, asset.kind) == ("seat_driver", "sedan", "car_seat")
    assert all("seat" not in state.held for shot in board.shot_details for state in shot.states)


def test_who_sits_on_the_seat_sits_in_the_vehicle() -> None:
    seat = Thing("seat", "driver's seat", part_of="sedan")
    spot = {"ann": Spot(relation="on", anchor_id="seat")}
    reading = _reading(seat, posture={"ann": ("sit", "seat")}, spots=spot, deeds=[Deed("ann", "sit", "seat")])
    (unit,) = FittedParts.of(reading).rewritten(reading).units
    assert unit.posture == {"ann": ("sit", "sedan")} and unit.deeds[0].target == "sedan"
    assert (unit.spots["ann"].relation, unit.spots["ann"].anchor_id, unit.spots["ann"].side) == (
        "inside",
        "sedan",
        "driver",
    )


def test_a_door_is_the_vehicle_and_who_is_at_it_stands_on_its_side() -> None:
    door = Thing("door", "passenger door", kind="set_piece", part_of="sedan")
    reading = _reading(door, spots={"ann": Spot(anchor_id="door")}, changes=[StateChange("door", "open")])
    (unit,) = FittedParts.of(reading).rewritten(reading).units
    assert (unit.spots["ann"].anchor_id, unit.spots["ann"].side) == ("sedan", "passenger")
    assert [change.subject for change in unit.changes] == ["sedan"]


def test_a_part_without_a_whole_belongs_to_the_only_vehicle_of_its_scene() -> None:
    assert FittedParts.of(_reading(Thing("w", "steering wheel"))).whole == {"w": "sedan"}
    assert FittedParts.of(_reading(Thing("m", "mirror"))).whole == {}, "outdoors a mirror is a mirror"
    assert FittedParts.of(_reading(Thing("m", "mirror"), kit="car")).whole == {"m": "sedan"}


def test_a_chair_keeps_its_seat() -> None:
    chair, seat = Thing("chair", "old chair"), Thing("seat", "seat", part_of="chair")
    assert FittedParts.of(_reading(chair, seat)).whole == {}
    assert is_shell("driver's door") and not is_shell("door handle")


def test_who_drives_sits_at_the_wheel() -> None:
    reading = _reading(deeds=[Deed("ann", "drive", "sedan")])
    (unit,) = FittedParts.of(reading).rewritten(reading).units
    assert unit.posture == {"ann": ("sit", "sedan")} and unit.spots["ann"].side == "driver"
    stands = _reading(deeds=[Deed("ann", "drive", "sedan")], posture={"ann": ("stand", None)})
    assert FittedParts.of(stands).rewritten(stands).units[0].posture == {"ann": ("stand", None)}


def test_who_drives_as_the_scene_opens_is_at_the_wheel_from_the_first_frame() -> None:
    (shot, *_) = storyboard(_reading(deeds=[Deed("ann", "drive", "sedan")])).shot_details
    (state,) = shot.states
    assert (state.posture, state.support_id) == ("sit", "sedan")
