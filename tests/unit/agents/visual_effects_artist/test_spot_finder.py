"""The script's spots on the floor of a small room with a table, two chairs, a car and a door."""

from __future__ import annotations

import math

import pytest

from storyblender.agents.visual_effects_artist.animator import AnimatorView, RulesAnimator
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.catalog.set_plan import Opening, PlanMark, SetPlan, Wall
from storyblender.geometry.seating import list_seats
from storyblender.memory.asset_sheet import Anchor, Asset, CanonicalAsset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Layout, LayoutObject, SceneSize, Spot
from storyblender.memory.shot_context import (
    Blocking,
    BodyState,
    CameraInstruction,
    CharacterAction,
    PropState,
    ShotContext,
)

SIZE = SceneSize(x=6, x_negative=-6, y=5, y_negative=-5)
DOOR = Opening(name="door", kind="door", x=2.0, width=0.95, height=2.1)
LEFT = Wall(node_id="wall_left", start=(-6, 5), end=(-6, -5), height=3.0, material="plaster", openings=(DOOR,))
ENTER = PlanMark(name="way_in", location=(-5.4, 2.5, 0), yaw=90, tags=("enter", "exit"))
PLAN = SetPlan(kit="room", indoor=True, size=SIZE, walls=(LEFT,), marks=(ENTER,))
SEAT = Anchor(kind="seat", name="seat", location=(0, -0.24, 0.45), size=(0.46, 0.42))
TOP = Anchor(kind="top", name="top", location=(0, 0, 0.75), size=(1.1, 0.8))
CAR = (
    Anchor(kind="seat", name="driver", location=(0.4, -0.3, 0.5), size=(0.5, 0.5)),
    Anchor(kind="seat", name="passenger", location=(-0.4, -0.3, 0.5), size=(0.5, 0.5)),
    Anchor(kind="seat", name="rear_left", location=(0.4, 0.7, 0.5), size=(0.5, 0.5)),
    Anchor(kind="door", name="door_left", location=(1.0, -0.4, 0.0), direction=(-1, 0, 0)),
    Anchor(kind="door", name="door_right", location=(-1.0, -0.4, 0.0), direction=(1, 0, 0)),
)


def _asset(asset_id: str, size: Vec3, *anchors: Anchor, person: bool = False) -> Asset:
    source, kind = ("person", "character") if person else ("catalog", "object")
    canonical = CanonicalAsset(source=source, key=asset_id, dimensions=size, anchors=anchors, digest="d")
    return Asset(asset_id=asset_id, asset_type=kind, description=asset_id, canonical=canonical)


def _at(node_id: str, x: float, y: float, yaw: float = 0.0, asset_id: str = "") -> LayoutObject:
    return LayoutObject(node_id=node_id, asset_id=asset_id or node_id, location=(x, y, 0), rotation=(0, 0, yaw))


ASSETS = (
    _asset("chair", (0.46, 0.48, 0.9), SEAT),
    _asset("dining_table", (1.1, 0.8, 0.75), TOP),
    _asset("car", (1.8, 4.4, 1.5), *CAR),
    _asset("bar_counter", (2.4, 0.6, 1.1)),
    _asset("counter", (2.4, 0.6, 1.1)),
    _asset("bucket", (0.3, 0.3, 0.3)),
    _asset("ball", (0.1, 0.1, 0.1)),
    _asset("laptop", (0.34, 0.3, 0.23)),
    _asset("ann", (0.5, 0.3, 1.7), person=True),
    _asset("bo", (0.5, 0.3, 1.7), person=True),
)
LAYOUT = Layout(
    scene_size=SIZE,
    objects=(
        _at("dining_table", 0, 2.0),
        _at("chair_l", -0.9, 2.0, 90, "chair"),
        _at("chair_r", 0.9, 2.0, -90, "chair"),
        _at("car", 3.5, -1.5),
        _at("bar_counter", -3.0, -3.5, 180),
        _at("bucket", -4.0, 0.0),
        _at("ball", 2.0, 3.5),
        LayoutObject(node_id="laptop", asset_id="laptop", location=(0, 1.8, 0.75)),
        _at("ann", -1, -1),
        _at("bo", 1, -1),
    ),
)


def _state(who: str, posture: str = "stand", support: str | None = None, **spot: object) -> BodyState:
    told = Spot.model_validate(spot) if spot else None
    return BodyState.model_validate({"asset_id": who, "posture": posture, "support_id": support, "spot": told})


def _shot(*states: BodyState, number: int = 1, **fields: object) -> ShotContext:
    who = tuple(state.asset_id for state in states)
    camera = CameraInstruction(focus_on_ids=who)
    return ShotContext.model_validate(
        {"scene_id": 1, "shot_id": number, "on_stage": who, "states": states, "camera_instruction": camera, **fields}
    )


def _played(*shots: ShotContext) -> tuple[list[dict[str, Blocking]], list[tuple[PropState, ...]]]:
    view = AnimatorView(scene_id=1, layout=LAYOUT, plan=PLAN, assets=ASSETS, shots=shots)
    draft = RulesAnimator().propose(view)
    return [{b.start.asset_id: b for b in shot.blocking} for shot in draft.shots], [s.prop_states for s in draft.shots]


def _start(*states: BodyState) -> dict[str, Blocking]:
    return _played(_shot(*states))[0][0]


def test_who_is_in_the_doorway_is_in_it() -> None:
    place = _start(_state("ann", relation="in", anchor_id="doorway"))["ann"].start
    assert abs(place.location[0] + 6) < 0.2 and abs(place.location[1] - 2.5) < 0.1


def test_a_name_from_the_script_finds_what_stands_for_it() -> None:
    place = _start(_state("ann", relation="behind", anchor_id="counter"))["ann"].start
    assert -4.2 < place.location[0] < -1.8 and -4.6 < place.location[1] < -3.8, "at the back of the bar"


@pytest.mark.parametrize(("side", "seat"), [("driver", "driver"), ("passenger", "passenger"), ("rear", "rear_left")])
def test_who_is_in_a_car_has_the_seat_that_is_told(side: str, seat: str) -> None:
    mark = _start(_state("ann", relation="inside", anchor_id="car", side=side))["ann"].start
    assert (mark.posture, mark.support_id, mark.anchor_name) == ("sit", "car", seat)


def test_who_is_at_the_drivers_side_is_at_its_door() -> None:
    place = _start(_state("ann", relation="at", anchor_id="car", side="driver"))["ann"].start.location
    assert place[0] > 3.5 + 0.9 and abs(place[1] + 1.9) < 0.3


def test_who_sits_at_a_table_has_one_of_its_chairs_and_who_sits_on_it_has_none() -> None:
    at = _start(_state("ann", "sit", "dining_table", relation="at", anchor_id="dining_table"))["ann"].start
    on = _start(_state("ann", "sit", "dining_table", relation="on", anchor_id="dining_table"))["ann"].start
    assert at.support_id in ("chair_l", "chair_r") and on.support_id == "dining_table"


def test_the_distance_and_the_facing_that_are_told_are_kept() -> None:
    ann = _state("ann", relation="in_front_of", anchor_id="dining_table", distance=1.0)
    bo = _state("bo", relation="facing", anchor_id="ann", distance=2.0, facing="away")
    marks = _start(ann, bo)
    one, two = marks["ann"].start, marks["bo"].start
    assert math.dist(one.location, two.location) == pytest.approx(2.0, abs=0.05)
    away = math.atan2(two.location[0] - one.location[0], one.location[1] - two.location[1])
    assert math.cos(away - math.radians(two.yaw)) > 0.99


def test_a_spot_is_kept_until_another_is_told_and_the_height_counts() -> None:
    up = _state("ann", relation="at", anchor_id="dining_table", height=2.5)
    blockings, _ = _played(
        _shot(up), _shot(up, number=2), _shot(_state("ann", relation="at", anchor_id="car"), number=3)
    )
    first, second, third = (each["ann"].start for each in blockings)
    assert first.location == second.location and first.location[2] == 2.5
    assert third.location[2] == 0.0 and math.dist(third.location, first.location) > 2


def test_who_walks_ends_where_the_script_has_them() -> None:
    walk = CharacterAction(asset_id="ann", action_description="goes", motion="walk", target_id="car")
    end = _state("ann", relation="at", anchor_id="car", side="passenger")
    blocking = _played(_shot(_state("ann"), character_actions=(walk,), end_states=(end,)))[0][0]["ann"]
    assert blocking.end.location[0] < 3.5 - 0.9 and abs(blocking.end.location[1] + 1.9) < 0.3


def test_a_thing_that_is_told_elsewhere_without_a_deed_is_there_from_then_on() -> None:
    told = {"bucket": Spot(relation="in_front_of", anchor_id="car", distance=0.5)}
    shots = (_shot(_state("ann"), thing_spots={"bucket": Spot(relation="at", anchor_id="dining_table")}),)
    _, props = _played(*shots, _shot(_state("ann"), number=2, thing_spots=told), _shot(_state("ann"), number=3))
    assert not any(state.asset_id == "bucket" for state in props[0]), "the layout has stood it there"
    for states in props[1:]:
        (bucket,) = (state for state in states if state.asset_id == "bucket")
        assert bucket.location is not None and -5.0 < bucket.location[1] < -3.7


def test_what_is_absent_is_hidden_while_it_is() -> None:
    _, props = _played(_shot(_state("ann"), absent=("car",)), _shot(_state("ann"), number=2))
    assert [state.visible for state in props[0] if state.asset_id == "car"] == [False]
    assert all(state.visible for state in props[1])


@pytest.mark.parametrize("anchor", ["doorway", "bo"])
def test_nobody_stands_on_top_of_a_door_or_a_person(anchor: str) -> None:
    marks = _start(
        _state("bo", relation="at", anchor_id="dining_table"), _state("ann", relation="on", anchor_id=anchor)
    )
    assert marks["ann"].start.location[2] == 0.0
    assert math.dist(marks["ann"].start.location[:2], marks["bo"].start.location[:2]) > 0.4


def test_who_rides_on_somebodys_back_is_there_in_every_shot() -> None:
    rider = _state("ann", "ride", "bo")
    shots = (_shot(_state("bo", relation="at", anchor_id="dining_table"), rider),
             _shot(_state("bo", relation="at", anchor_id="car"), rider, number=2))  # fmt: skip
    for marks in _played(*shots)[0]:
        one, other = marks["ann"].start, marks["bo"].start
        assert math.dist(one.location[:2], other.location[:2]) < 0.3 and one.location[2] > 0.5


def test_a_person_is_no_thing_though_their_name_is() -> None:
    ivy = _asset("counter", (0.5, 0.3, 1.7), person=True)
    floor = Floor(LAYOUT, (*(each for each in ASSETS if each.asset_id != "counter"), ivy), PLAN)
    assert floor.thing("counter") is None


@pytest.mark.parametrize("height", [0.0, 1.2])
def test_who_walks_comes_down_and_goes_up_to_where_they_are_told(height: float) -> None:
    walk = CharacterAction(asset_id="ann", action_description="goes", motion="walk", target_id="car")
    up = _state("ann", relation="at", anchor_id="dining_table", height=0.8)
    end = _state("ann", relation="at", anchor_id="car", height=height)
    blocking = _played(_shot(up, character_actions=(walk,), end_states=(end,)))[0][0]["ann"]
    assert (blocking.start.location[2], blocking.end.location[2]) == (0.8, height)


def test_of_several_windows_the_nearest_is_meant() -> None:
    windows = tuple(Opening(name=f"window_{x}", kind="window", x=x, width=1.0, height=1.2) for x in (1, 8))
    wall = Wall(node_id="wall_back", start=(-5, 5), end=(5, 5), height=3.0, material="plaster", openings=windows)
    floor = Floor(LAYOUT, ASSETS, PLAN.model_copy(update={"walls": (wall,)}))
    for near in (-3.5, 3.5):
        window = floor.thing("window", (near, 0.0))
        assert window is not None and window.location[0] == pytest.approx(near, abs=0.1)


@pytest.mark.parametrize("relation", ["in", "inside"])
def test_what_is_told_to_be_in_a_hollow_thing_later_lies_in_it(relation: str) -> None:
    told = {"ball": Spot(relation=relation, anchor_id="bucket")}
    first = _shot(_state("ann"), thing_spots={"ball": Spot(relation="at", anchor_id="dining_table")})
    _, props = _played(first, _shot(_state("ann"), number=2, thing_spots=told))
    lies = {state.asset_id: state.location for state in props[1]}["ball"]
    assert lies is not None and math.dist(lies[:2], (-4.0, 0.0)) < 0.15 and 0 < lies[2] < 0.3


@pytest.mark.parametrize("motion", ["climb", "jump"])
def test_who_climbs_onto_a_thing_ends_on_top_of_it(motion: str) -> None:
    up = CharacterAction(asset_id="ann", action_description="climbs up", motion=motion, target_id="dining_table")
    end = _state("ann", relation="on", anchor_id="dining_table")
    (shot,), _ = _played(_shot(_state("ann"), character_actions=(up,), end_states=(end,)))
    x, y, z = shot["ann"].end.location
    assert (x, y, z) == (pytest.approx(0, abs=0.6), pytest.approx(2.0, abs=0.45), pytest.approx(0.75, abs=0.01))
    assert shot["ann"].start.location[2] == 0


@pytest.mark.parametrize(("size", "thin"), [((2.0, 0.1, 1.5), True), ((1.0, 1.0, 1.4), False), ((0.1, 3.0, 2.0), True)])
def test_who_is_told_to_sit_on_a_fence_or_a_wall_sits_on_top(size: Vec3, thin: bool) -> None:
    (seat,) = list_seats((), size, on_top=True)
    assert seat.location[2] == size[2] and (max(map(abs, seat.location[:2])) < 0.2) == thin
    assert not list_seats((), size, asked=True)


@pytest.mark.parametrize(("motion", "place"), [("hold", "under_arm"), ("take", None)])
def test_what_is_under_an_arm_stays_there_until_a_hand_takes_it(motion: str, place: str | None) -> None:
    ann = _state("ann").model_copy(update={"held": ("ball",), "grips": (("ball", "under_arm"),)})
    deed = CharacterAction(asset_id="ann", action_description=motion, motion=motion, prop_id="ball")
    _, props = _played(_shot(ann), _shot(ann, number=2, character_actions=(deed,)))
    assert {state.asset_id: state.place for state in props[1]}["ball"] == place


@pytest.mark.parametrize(("motion", "moved"), [("type", False), ("take", True)])
def test_a_laptop_on_a_table_stays_there_while_somebody_types(motion: str, moved: bool) -> None:
    deed = CharacterAction(asset_id="ann", action_description=motion, motion=motion, prop_id="laptop")
    ann = _state("ann", relation="in_front_of", anchor_id="dining_table")
    _, props = _played(_shot(ann, character_actions=(deed,)), _shot(ann, number=2))
    assert ("laptop" in {state.asset_id for state in props[1]}) is moved


def test_in_front_of_what_somebody_holds_is_in_front_of_them() -> None:
    armed = _state("bo").model_copy(update={"held": ("ball",)})
    before = _state("ann", relation="in_front_of", anchor_id="ball", distance=1.0)
    (shot,), _ = _played(_shot(armed, before))
    assert math.dist(shot["ann"].end.location, shot["bo"].end.location) == pytest.approx(1.0, abs=0.4)


def test_who_stands_next_to_a_table_turns_to_who_sits_at_it() -> None:
    seated = _state("bo", "sit", "chair_r")
    (shot,), _ = _played(_shot(seated, _state("ann", relation="next_to", anchor_id="chair_r")))
    (ax, ay, _), (bx, by, _) = shot["ann"].end.location, shot["bo"].end.location
    ahead = math.sin(math.radians(shot["ann"].end.yaw)), -math.cos(math.radians(shot["ann"].end.yaw))
    assert ahead[0] * (bx - ax) + ahead[1] * (by - ay) > 0
