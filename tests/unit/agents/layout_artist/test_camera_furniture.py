"""Furniture that stands before the people is moved for a picture; backs of pianos and cupboards are no picture."""

from dataclasses import replace

import pytest
from test_camera_operator import ANNA, FILM, TOM, figure, view_of

from storyblender.agents.layout_artist.camera_crowd import find_crowd_in_front
from storyblender.agents.layout_artist.camera_furniture import (
    find_furniture_in_front,
    share_of_backs,
)
from storyblender.agents.layout_artist.camera_scout import scout_takes, take_cost
from storyblender.agents.layout_artist.camera_start import compose_take, take_with_camera
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import project

PAIR = {"kind": "two_shot", "size": "FS", "focus_on_ids": ("anna", "tom")}
TABLE, LAMP = Box(0, -2.6, 0, 1.6, 0.9, 0.75), Box(0.1, -2.6, 0.75, 0.3, 0.3, 0.5)
PIANO = Box(0.9, -1.0, 0, 1.5, 0.8, 1.3)


def test_a_table_before_two_people_is_moved_with_the_lamp_on_it() -> None:
    view = view_of((ANNA, TOM), props={"table": TABLE, "lamp": LAMP}, **PAIR)
    camera = compose_take(view).camera
    assert abs(camera.azimuth) < 20, "the table is before the camera"
    assert set(find_furniture_in_front(view, camera)) == {"table", "lamp"}
    assert any({"table", "lamp"} <= set(each.hidden) for each in scout_takes(view))


@pytest.mark.parametrize(
    ("props", "more"),
    [
        ({"table": TABLE}, {"used": ("table",)}),
        ({"table": replace(TABLE, y=-0.8)}, {}),
        ({"table": replace(TABLE, y=2.6)}, {}),
        ({"table": TABLE}, {"kind": "establishing"}),
    ],
)
def test_what_is_used_or_theirs_or_behind_them_stays_and_a_place_is_shown_as_it_is(
    props: dict[str, Box], more: dict[str, object]
) -> None:
    view = view_of((ANNA, TOM), props=props, **{**PAIR, **more})
    assert find_furniture_in_front(view, compose_take(replace(view, props={})).camera) == []


EXTRA = Box(0.0, -1.6, 0.0, 0.5, 0.4, 1.7)


@pytest.mark.parametrize("kind", ["single", "two_shot"])
def test_an_extra_before_the_subject_is_out_of_the_picture_and_one_behind_stays(kind: str) -> None:
    view = view_of((ANNA, TOM), **{**PAIR, "kind": kind})
    camera = compose_take(view).camera
    (x, y, _), (to_x, to_y, _) = camera.position, view.people[0].base
    extras = {
        "set_bystander_1": replace(EXTRA, x=float(x + to_x) / 2, y=float(y + to_y) / 2),
        "set_bystander_2": replace(EXTRA, x=float(2 * to_x - x), y=float(2 * to_y - y)),
    }
    crowded = replace(view, props=extras)
    assert find_crowd_in_front(crowded, camera) == ["set_bystander_1"]
    takes = scout_takes(crowded)
    assert takes
    assert all({*find_crowd_in_front(crowded, take.camera)} <= {*take.hidden} for take in takes)


def test_a_place_keeps_its_crowd_and_a_named_guest_stays() -> None:
    crowd = [figure(f"guest_{index}", 0.4 * index - 1.0, -1.6, 0) for index in range(4)]
    place = view_of((ANNA, TOM, *crowd), kind="establishing", size="WS", focus_on_ids=("anna",))
    assert find_crowd_in_front(place, compose_take(place).camera) == []
    single = view_of((ANNA, TOM, *crowd), kind="single", size="FS", focus_on_ids=("anna",))
    gone = find_crowd_in_front(single, compose_take(single).camera)
    assert gone and all(node.startswith("guest_") for node in gone)
    told = view_of((ANNA, TOM, *crowd), kind="group", size="FS", focus_on_ids=("anna", "guest_1"))
    assert "guest_1" not in find_crowd_in_front(told, compose_take(told).camera)


def test_the_back_of_a_piano_counts_and_its_front_does_not() -> None:
    view = view_of((ANNA, TOM), props={"piano": PIANO}, **PAIR)
    camera = FILM.look((0.3, 0.0, 1.2), 0.0, 3.0, 4.0, 35.0)
    turned = replace(view, props={"piano": replace(PIANO, yaw=3.1416)})
    assert share_of_backs(view, take_with_camera(view, camera), 4.5) == 0
    assert share_of_backs(turned, take_with_camera(turned, camera), 4.5) > 0.1
    assert take_cost(turned, take_with_camera(turned, camera)) > take_cost(view, take_with_camera(view, camera)) + 0.3


@pytest.mark.parametrize(("x", "minded"), [(-0.5, True), (-3.5, False)])
def test_who_is_beside_the_first_person_is_not_shown_from_behind(x: float, minded: bool) -> None:
    def price(yaw: float) -> float:
        view = view_of((TOM, figure("guard", x, 0, yaw)), kind="single", size="WS", focus_on_ids=("tom",))
        return take_cost(view, take_with_camera(view, FILM.look((0.0, 0.0, 1.0), 0.0, 2.0, 8.0, 28.0)))

    assert (price(180) > price(0) + 0.5) == minded


@pytest.mark.parametrize(("size", "least"), [("EWS", 0.2), ("WS", 0.24)])
def test_who_is_in_a_place_is_a_quarter_of_its_picture_and_whole(size: str, least: float) -> None:
    plane = {"plane": Box(0, 12, 0, 29, 9, 5)}
    view = view_of((ANNA, TOM), props=plane, kind="establishing", size=size, focus_on_ids=("anna", "plane"))
    camera = compose_take(replace(view, in_frame=("anna", "tom"))).camera
    (_, top), (_, bottom) = project(camera, [TOM.crown, TOM.base])[0]
    assert bottom - top > least and bottom < 1


def test_people_far_apart_are_all_in_the_picture_of_their_place() -> None:
    far = [figure("anna", -5, 3, 0), figure("tom", 5, -2, 0)]
    view = view_of(far, kind="establishing", size="WS", focus_on_ids=("anna", "tom"), in_frame=("anna", "tom"))
    for turn in (0, 30, 60, 95):
        screen, depth = project(compose_take(view, turn).camera, [p for each in far for p in (each.crown, each.base)])
        assert depth.min() > 0 and ((screen > 0) & (screen < 1)).all()
