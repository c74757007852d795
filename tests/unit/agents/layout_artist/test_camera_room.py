"""The camera in a room: what lies outside is known from the plan, and lenses fit the floor there is."""

import math
from dataclasses import replace

import numpy as np
import pytest

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView, Moment
from storyblender.agents.layout_artist.camera_room import VOID, fit_lens_to_room, share_outside
from storyblender.agents.layout_artist.camera_scout import scout_takes, take_cost
from storyblender.agents.layout_artist.camera_start import compose_take, take_with_camera
from storyblender.agents.layout_artist.wild_walls import find_hidden_nodes
from storyblender.catalog.set_plan import Piece, SetPlan, Slab, Wall
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Figure, Film, project
from storyblender.geometry.orbit import camera_looking_at
from storyblender.memory.scene_context import SceneSize
from storyblender.memory.shot_context import CameraInstruction

FILM = {"sensor_width": 36.0, "aspect": 16 / 9}
CORNERS = [(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)]
NAMES = ["front", "right", "back", "left"]
ROOM = SetPlan(
    kit="room",
    indoor=True,
    size=SceneSize(x=3, x_negative=-3, y=3, y_negative=-3),
    walls=tuple(
        Wall(node_id=name, start=CORNERS[k], end=CORNERS[(k + 1) % 4], height=2.8, material="plaster")
        for k, name in enumerate(NAMES)
    ),
    slabs=(Slab(node_id="ceiling", role="ceiling", polygon=tuple(CORNERS), z=2.8, material="plaster"),),
)


def person(name: str, x: float, y: float, yaw: float) -> Figure:
    forward = (math.sin(math.radians(yaw)), -math.cos(math.radians(yaw)), 0.0)
    return Figure(name, (x, y, 1.6), forward, 0.23, (x, y, 0.0))


def view_of(*people: Figure, in_frame: tuple[str, ...] = (), **more) -> CameraOperatorView:
    return CameraOperatorView(
        1, 1, CameraInstruction(**more), 48, (Moment(0, people),), plan=ROOM, film=Film(), in_frame=in_frame
    )


@pytest.mark.parametrize(
    ("eye", "hidden", "low", "high"),
    [
        ((0, -2.5, 1.5), (), 0.0, 0.0),
        ((0, -3.2, 1.5), ("front",), 0.0, 0.02),
        ((0, -8.0, 1.5), ("front",), 0.2, 0.9),
        ((0, -3.5, 1.5), (), 1.0, 1.0),
        ((0, 0, 1.5), ("back",), 0.4, 1.0),
    ],
)
def test_what_lies_outside_counts(eye, hidden, low: float, high: float) -> None:
    camera = camera_looking_at(eye, (0.0, 2.9, 1.4), 28.0, **FILM)
    assert low <= share_outside(ROOM, camera, hidden) <= high


def test_outdoors_there_is_no_outside() -> None:
    open_air = ROOM.model_copy(update={"indoor": False})
    assert share_outside(open_air, camera_looking_at((0, -8, 1.5), (0, 0, 1), 28.0, **FILM), ()) == 0.0


def test_a_long_lens_gives_way_to_the_room_and_keeps_the_size() -> None:
    camera = camera_looking_at((0, -7.0, 1.5), (0, 0, 1.5), 50.0, **FILM)
    inside = fit_lens_to_room(ROOM, camera, "WS")
    assert inside.lens < 50 and abs(inside.position[1]) < 3.5
    assert inside.frame_height == pytest.approx(camera.frame_height)


@pytest.mark.parametrize("kind", ["establishing", "group"])
def test_a_master_indoors_stays_in_the_room_and_shows_people_large(kind: str) -> None:
    people = (person("anna", -1, 1, 30), person("tom", 0.6, 1.2, -20))
    names = ("anna", "tom")
    take = scout_takes(view_of(*people, in_frame=names, kind=kind, size="WS", focus_on_ids=names))[0]
    assert share_outside(ROOM, take.camera, take.hidden) < 0.03
    heights = [float(project(take.camera, [who.base, who.crown])[0][:, 1] @ (1, -1)) for who in people]
    assert 0.17 < max(heights) < 0.75


def test_a_picture_of_things_stays_in_the_room_however_large_they_are() -> None:
    tree, bone = Box(1.0, 1.0, 0.0, 1.8, 1.8, 2.2), Box(-2.0, 1.0, 0.0, 0.1, 0.1, 0.1)
    shot = view_of(kind="action", size="MS", focus_on_ids=["tree", "bone"])
    shot = replace(shot, props={"tree": tree, "bone": bone})
    assert shot.things, "the picture is of them"
    camera = compose_take(shot).camera
    assert share_outside(ROOM, camera, [wall.node_id for wall in ROOM.walls]) < 0.9
    assert max(abs(value) for value in camera.position[:2]) < 3.5


def test_a_lens_that_was_asked_for_is_the_lens() -> None:
    pair = person("anna", -0.6, 0, 90), person("tom", 0.6, 0, -90)
    asked = {"kind": "establishing", "size": "WS", "focus_on_ids": ["anna", "tom"]}
    free, told = compose_take(view_of(*pair, **asked)).camera, compose_take(view_of(*pair, **asked, lens=35.0)).camera
    assert free.lens < 35, "the room calls for a wider one"
    assert told.lens == 35


def test_who_has_no_part_is_left_out() -> None:
    anna, guard = person("anna", 0, 0, 0), person("guard", 0.9, 1.4, 0)
    view = view_of(anna, guard, in_frame=("anna",), kind="single", size="MS", focus_on_ids=("anna",))
    screen, _ = project(scout_takes(view)[0].camera, [guard.face])
    assert not 0 < screen[0, 0] < 1
    assert take_cost(view, scout_takes(view)[0]) < take_cost(view, compose_take(view, 180))


def test_a_tight_shot_is_about_the_first() -> None:
    view = view_of(
        person("anna", 0, 0, 0), person("tom", 2, 1, 180), kind="reaction", size="MCU", focus_on_ids=("anna", "tom")
    )
    assert view.focus == ("anna",)
    take: CameraOperatorDraft = scout_takes(view)[0]
    assert view.people[0].turned_from(take.camera.position) < 60


def test_what_somebody_lies_on_stays_where_the_wall_before_it_goes() -> None:
    sleeper, guest = person("anna", 0.0, -2.4, 0), person("tom", 0.0, 1.5, 0)
    view = view_of(sleeper, guest, in_frame=("anna", "tom"), kind="group", size="MWS", focus_on_ids=("tom",))
    bed = {"bed": Box(0.0, -2.4, 0.0, 1.0, 2.0, 1.4)}
    camera = camera_looking_at((0.0, -4.5, 1.2), (0.0, 1.5, 1.2), 24.0, **FILM)
    assert "bed" not in take_with_camera(replace(view, props=bed), camera).hidden
    empty = view_of(guest, in_frame=("tom",), kind="single", size="MWS", focus_on_ids=("tom",))
    assert "bed" in take_with_camera(replace(empty, props=bed), camera).hidden, "nobody would float without it"


def test_who_bows_into_a_wall_opens_none() -> None:
    bowed = replace(person("anna", -3.05, 0, -90), base=(-2.6, 0.0, 0.0))
    camera = camera_looking_at((0, 0, 1.5), bowed.face, 35.0, **FILM)
    assert find_hidden_nodes(ROOM, {}, [camera], [np.array(bowed.face)]) == []
    assert find_hidden_nodes(ROOM, {}, [camera], [np.array((-3.6, 0.0, 1.6))]) == ["left"], (
        "who is behind a wall is seen"
    )
    best = scout_takes(view_of(bowed, kind="action", size="MWS", focus_on_ids=("anna",)))[0]
    assert share_outside(ROOM, best.camera, best.hidden) < VOID


def test_what_hangs_on_a_wall_goes_with_it() -> None:
    mirror, lamp = (
        Piece(node_id=name, part="mirror", location=place) for name, place in (("m", (0, -3, 1)), ("l", (0, 0, 2.5)))
    )
    plan = ROOM.model_copy(update={"pieces": (mirror, lamp)})
    camera = camera_looking_at((0, -3.25, 1.5), (0, 0, 1.5), 35.0, **FILM)
    assert find_hidden_nodes(plan, {}, [camera], [np.array([0, 0, 1.5])]) == ["front", "m"]


@pytest.mark.parametrize("kind", ["action", "insert"])
def test_things_too_large_for_the_room_at_the_lens_of_their_size_take_a_wider_one(kind: str) -> None:
    view = view_of(kind=kind, size="CU", focus_on_ids=("boiler",))
    shot = compose_take(replace(view, props={"boiler": Box(0, 2, 0, 2.4, 1.5, 2.2)})).camera
    top, low = project(shot, [(0, 1.25, 2.2), (0, 1.25, 0)])[0][:, 1]
    assert shot.lens < 85 and 0 < top < low < 1


def test_tall_things_with_their_backs_to_a_wall_go_with_it_even_beside_the_sight() -> None:
    bookcase, sideboard = Box(3.0, -2.85, 0.0, 0.8, 0.3, 1.9), Box(-3.0, -2.85, 0.0, 0.8, 0.3, 0.8)
    folding_screen = Box(3.0, -1.5, 0.0, 0.8, 0.3, 1.9)
    props = {"bookcase": bookcase, "sideboard": sideboard, "folding_screen": folding_screen}
    hidden = find_hidden_nodes(
        ROOM, props, [camera_looking_at((0, -4.5, 1.5), (0, 0, 1.5), 35.0, **FILM)], [np.array([0, 0, 1.5])]
    )
    assert hidden == ["front", "bookcase"], "a low one may be a foreground, and so may what stands in the room"


def test_what_stands_on_a_thing_that_goes_with_its_wall_goes_too() -> None:
    shelf, cup = Box(0.0, -2.8, 0.0, 1.6, 0.4, 0.9), Box(0.3, -2.8, 0.9, 0.1, 0.1, 0.1)
    table, lamp = Box(1.5, 1.0, 0.0, 1.2, 0.8, 0.75), Box(1.5, 1.0, 0.75, 0.2, 0.2, 0.4)
    props = {"shelf": shelf, "cup": cup, "lamp": lamp, "table": table}
    hidden = find_hidden_nodes(
        ROOM, props, [camera_looking_at((0, -4.5, 0.8), (0, 0, 0.5), 35.0, **FILM)], [np.array([0, 0, 0.5])]
    )
    assert {"front", "shelf", "cup"} <= {*hidden} and not {"lamp", "table"} & {*hidden}
