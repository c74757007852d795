"""Who lies, kneels or sits does it where there is room, alone."""

from __future__ import annotations

import math

import pytest
from tests.unit.agents.visual_effects_artist.test_animator import (
    ASSETS,
    LAYOUT,
    PLAN,
    _at,
    _cues,
    _do,
    _end,
    _shot,
    _stage,
    _start,
    _thing,
    _view,
)

from storyblender.agents.visual_effects_artist.animator import RulesAnimator
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.on_the_floor import SPANS, find_room_on_floor
from storyblender.geometry.boxes import shortest_turn
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import BodyState
from storyblender.memory.vocabulary import Posture

FLOOR = Floor(LAYOUT, ASSETS, PLAN)


@pytest.mark.parametrize("posture", ["lie", "kneel"])
def test_nobody_lies_or_kneels_in_a_table(posture: Posture) -> None:
    place, yaw = find_room_on_floor(FLOOR, posture, (0.0, 0.3), math.pi, 1.0)
    for share in (0, 0.25, 0.5, 0.75, 1):
        along = SPANS[posture][0] + share * (SPANS[posture][1] - SPANS[posture][0])
        spot = (place[0] + along * math.sin(yaw), place[1] - along * math.cos(yaw))
        assert FLOOR.room_at(spot) > 0.1
    assert math.dist(place, (0.0, 0.3)) < 1.2


def test_who_has_room_stays() -> None:
    assert find_room_on_floor(FLOOR, "lie", (0.0, -1.5), 0.4, 1.0) == ((0.0, -1.5), 0.4)


def test_who_lies_keeps_away_from_who_stands_and_from_where_others_sit_down() -> None:
    place, yaw = find_room_on_floor(FLOOR, "lie", (0.0, -1.5), 0.0, 1.0, [(0.0, -1.0)])
    assert (place, yaw) != ((0.0, -1.5), 0.0)
    seat = FLOOR.seats("chair_l")[0]
    place, yaw = find_room_on_floor(FLOOR, "lie", seat.standing_spot(1.0), 0.0, 1.0)
    assert math.dist(place, seat.standing_spot(1.0)) > 0.4


def test_who_is_found_lying_before_a_chair_lies_beside_it() -> None:
    states = (BodyState(asset_id="rick", posture="lie"),)
    (shot,) = _stage(_shot(1, _do("ilsa", "sit", target_id="chair_l"), states=states, seconds=9))
    lies = _start(shot, "rick")
    assert (lies.posture, _end(shot, "ilsa").posture) == ("lie", "sit")
    assert math.dist(lies.location, _end(shot, "ilsa").location) > 0.5


def test_who_falls_before_a_table_begins_where_there_is_room() -> None:
    at_table = BodyState(asset_id="rick", posture="sit", support_id="chair_l")
    first, second = _stage(_shot(1, states=(at_table,)), _shot(2, _do("rick", "rise"), _do("rick", "fall"), seconds=9))
    assert _cues(second, "rick")[-1] == "fall"
    lies = _end(second, "rick")
    yaw = math.radians(lies.yaw)
    head = (lies.location[0] - 0.8 * math.sin(yaw), lies.location[1] + 0.8 * math.cos(yaw))
    assert FLOOR.room_at(head) > 0.15
    assert _end(first, "rick").posture == "sit"


def test_two_do_not_sit_on_one_seat() -> None:
    states = tuple(BodyState(asset_id=who, posture="sit", support_id="chair_l") for who in ("rick", "ilsa"))
    (shot,) = _stage(_shot(1, states=states))
    rick, ilsa = _start(shot, "rick"), _start(shot, "ilsa")
    assert (rick.support_id, ilsa.support_id) == ("chair_l", "chair_r")


def test_who_sits_on_a_parcel_sits_on_its_edge() -> None:
    parcel = _thing("parcel", (0.45, 0.35, 0.32))
    layout = LAYOUT.model_copy(update={"objects": (*LAYOUT.objects, _at("parcel", 0.0, -1.5))})
    view = _view(_shot(1, states=(BodyState(asset_id="rick", posture="sit", support_id="parcel"),)))
    view = view.model_copy(update={"assets": (parcel, *ASSETS), "layout": layout})
    (shot,) = RulesAnimator().propose(view).shots
    mark = _start(shot, "rick")
    assert (mark.posture, mark.support_id) == ("sit", "parcel")
    assert mark.location[:2] == pytest.approx((0.0, -1.675))


def test_who_kneels_to_somebody_on_the_floor_kneels_beside_their_breast() -> None:
    states = (BodyState(asset_id="ilsa", posture="lie"),)
    (shot,) = _stage(_shot(1, _do("rick", "kneel", target_id="ilsa"), states=states, seconds=9))
    ilsa, rick = _start(shot, "ilsa"), _end(shot, "rick")
    yaw = math.radians(ilsa.yaw)
    breast = (ilsa.location[0] - 0.75 * math.sin(yaw), ilsa.location[1] + 0.75 * math.cos(yaw))
    assert math.dist(rick.location[:2], breast) < 0.75
    towards = math.atan2(breast[0] - rick.location[0], rick.location[1] - breast[1])
    assert abs(shortest_turn(math.radians(rick.yaw), towards)) < math.radians(40)


def test_who_sits_goes_to_the_far_table_that_they_put_something_on() -> None:
    far = BodyState(asset_id="rick", posture="sit", support_id="stool", held=("letter",))
    stool = _thing("stool", (0.4, 0.4, 0.45))
    layout = LAYOUT.model_copy(update={"objects": (*LAYOUT.objects, _at("stool", -3.0, -2.4))})
    put = _do("rick", "put_down", target_id="table", prop_id="letter")
    view = _view(_shot(1, put, states=(far,), seconds=12))
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": (stool, *ASSETS), "layout": layout})).shots
    assert _cues(shot, "rick")[:2] == ["rise", "walk"]
    down = next(cue for cue in shot.cues if cue.clip == "put_down")
    assert down.mark is not None
    assert math.dist(down.mark.location[:2], _end(shot, "rick").location[:2]) < 1.0
    assert down.mark.location[2] == pytest.approx(0.75)


def test_who_sits_puts_nothing_on_a_bar_behind_them() -> None:
    bar = _thing("bar", (2.4, 0.6, 1.12), Anchor(kind="top", location=(0, 0, 1.12), size=(2.4, 0.6)))
    objects = [item for item in LAYOUT.objects if item.node_id != "table"]
    layout = LAYOUT.model_copy(update={"objects": (*objects, _at("bar", -1.95, 1.0, 90))})
    sits = BodyState(asset_id="rick", posture="sit", support_id="chair_l", held=("letter",))
    view = _view(_shot(1, _do("rick", "put_down", prop_id="letter"), states=(sits,), seconds=6))
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": (bar, *ASSETS), "layout": layout})).shots
    down = next(cue for cue in shot.cues if cue.clip == "put_down")
    assert down.mark is not None
    assert down.mark.location[2] < 1.0


def test_nobody_takes_the_seat_of_who_is_found_there_later() -> None:
    objects = [item for item in LAYOUT.objects if item.node_id != "ilsa"]
    layout = LAYOUT.model_copy(update={"objects": (*objects, _at("ilsa", -1.06, 1.0, 90))})
    sits = BodyState(asset_id="ilsa", posture="sit")
    shots = (
        _shot(1, _do("rick", "sit", target_id="chair"), on_stage=("rick",), seconds=9),
        _shot(2, states=(sits,)),
    )
    view = _view(*shots).model_copy(update={"layout": layout})
    first, second = RulesAnimator().propose(view).shots
    assert _end(first, "rick").support_id == "chair_r"
    assert _start(second, "ilsa").support_id == "chair_l"
