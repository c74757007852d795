"""Several people in a room: the camera stays in it, nothing stands before them, and nobody's head fills the picture."""

from dataclasses import replace

import numpy as np
import pytest
from test_camera_operator import NumberFinder
from test_camera_room import ROOM, person, view_of

from storyblender.agents.layout_artist.camera_composition import find_composition_faults
from storyblender.agents.layout_artist.camera_operator_view import (
    CameraOperatorDraft,
    CameraOperatorView,
    Moment,
    pose_of,
)
from storyblender.agents.layout_artist.camera_room import reach_back, share_outside, void_points
from storyblender.agents.layout_artist.camera_scout import scout_takes, take_cost
from storyblender.agents.layout_artist.camera_solids import body_boxes
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.agents.layout_artist.wild_walls import find_hidden_nodes
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import (
    Figure,
    Film,
    crown_screen_y,
    frame_group,
    frame_group_from,
    head_share,
    project,
)
from storyblender.geometry.orbit import camera_looking_at, orbit
from storyblender.geometry.sight import find_hidden
from storyblender.memory.measure import CameraView, SubjectView, ViewRequest

APART = person("anna", -2.4, 1.8, 60), person("tom", 2.3, -0.5, -60), person("sam", 1.9, 2.2, -20)
NAMES = ("anna", "tom", "sam")


@pytest.mark.parametrize("size", ["FS", "MWS", "MS"])
def test_a_group_is_never_taken_from_beyond_the_walls(size: str) -> None:
    view = view_of(*APART, in_frame=NAMES, kind="action", size=size, focus_on_ids=NAMES, explicit=True)
    for turn in (0, 30, -70, 125, 180):
        take = compose_take(view, turn)
        assert share_outside(ROOM, take.camera, take.hidden) < 0.03
        assert np.abs(take.camera.position[:2]).max() < 3.31
    best = scout_takes(view)[0]
    screen, depth = project(best.camera, [who.face for who in APART])
    assert (depth > 0).all() and ((screen > 0) & (screen < 1)).all()


def test_a_camera_that_turns_on_its_place_holds_everybody_with_the_longest_lens_that_does() -> None:
    place = (0.0, -2.6, 1.5)
    camera = frame_group_from(Film(), APART[::2], "MS", place, 50.0, 18.0)
    assert camera.position == pytest.approx(place)
    screen, _ = project(camera, [who.face for who in APART[::2]])
    assert screen[:, 0].min() == pytest.approx(1 - screen[:, 0].max(), abs=0.06)
    assert 18 < camera.lens < 30 and screen[:, 0].max() - screen[:, 0].min() > 0.6
    near = frame_group_from(Film(), APART[2:], "MS", (1.9, 0.0, 1.5), 85.0, 18.0)
    away = project(near, [APART[2].face])[1][0]
    assert 0.19 < APART[2].head / away / (2 * near.tangent) < 0.28, "no larger than a medium shot wants"


def test_small_heads_stand_lower_in_the_picture_than_large_ones() -> None:
    assert crown_screen_y(0.03) > crown_screen_y(0.08) > crown_screen_y(0.2)
    far = person("anna", -4, 0, 0), person("tom", 4, 0, 0)
    camera = frame_group(Film(), far, "MS", 0.0, 2.0, 35.0)
    assert 1.0 < camera.position[2] < 2.2, "from the height of eyes, not of knees"


def test_only_what_hides_the_room_is_taken_away() -> None:
    camera = camera_looking_at((0.0, -3.2, 1.5), (2.0, 2.0, 1.4), 18.0, sensor_width=36.0, aspect=16 / 9)
    assert find_hidden_nodes(ROOM, {}, [camera], [np.array(APART[1].face)]) == ["front"]


def test_the_room_before_a_wall_can_be_asked_for() -> None:
    camera = camera_looking_at((0.0, -8.0, 1.5), (0.0, 0.0, 1.5), 35.0, sensor_width=36.0, aspect=16 / 9)
    assert reach_back(ROOM, camera) == pytest.approx(3.3)
    assert reach_back(ROOM, camera, 0.35) == pytest.approx(2.65)


def test_nothing_costs_much_more_than_an_edge() -> None:
    assert void_points(0.01) == 0 and void_points(0.1) > 2 and void_points(1.0) == 5


def test_what_stands_before_everybody_looms_and_vanishes_at_a_price() -> None:
    pair = person("anna", -0.5, 1.5, 20), person("tom", 0.5, 1.5, -20)
    view = view_of(*pair, in_frame=("anna", "tom"), kind="two_shot", size="MWS", focus_on_ids=("anna", "tom"))
    take = replace(compose_take(view), hidden=("front",))
    eye, middle = take.camera.position, np.array([0.0, 1.5])
    x, y = eye[:2] + (middle - eye[:2]) * 0.4
    blocked = replace(view, props={"pier": Box(float(x), float(y), 0.0, 0.35, 0.35, 3.0)})
    piano = replace(view, props={"piano": Box(2.2, 0.0, 0.0, 1.5, 1.3, 1.3)})
    assert take_cost(blocked, take) > take_cost(view, take) + 1
    assert take_cost(piano, replace(take, hidden=("front", "piano"))) > take_cost(piano, take) + 1


def test_a_followed_walk_is_composed_when_it_is_drawn() -> None:
    steps = ((0, -2.0), (20, 1.4), (47, 1.6))
    moments = tuple(Moment(frame, (person("anna", x, 0.0, 90),)) for frame, x in steps)
    wish = {"kind": "action", "size": "MWS", "focus_on_ids": ("anna",), "movement": "track"}
    view = replace(view_of(moments[0].figures[0], in_frame=("anna",), **wish), moments=moments, plan=None)
    take = compose_take(view)
    assert take.moves
    (drawn,), _ = project(take.at(20 / 47), [moments[1].figures[0].face])
    (composed,), _ = project(take.camera, [moments[1].figures[0].face])
    assert drawn == pytest.approx(composed, abs=0.02)
    assert 0.25 < drawn[0] < 0.75


def test_whoever_has_arrived_is_taken_by_the_face_and_not_by_the_way() -> None:
    wish = {"kind": "action", "size": "MS", "focus_on_ids": ("anna",)}
    came = (-3.0, 0.0)
    for drawn, stride in ((1.5, False), (-0.5, True)):
        way = tuple(Moment(frame, (person("anna", x, 0.0, 90),)) for frame, x in ((0, came[0]), (20, drawn), (47, 1.6)))
        turned = Moment(20, (person("anna", drawn, 0.0, 180 if not stride else 90),))
        view = replace(
            view_of(turned.figures[0], in_frame=("anna",), **wish), moments=(way[0], turned, way[2]), plan=None
        )
        assert view.walks and view.in_stride == stride
        assert view.people[0].turned_from(compose_take(view).camera.position) < 70


def test_who_walks_up_and_bends_over_a_thing_is_in_the_picture_all_the_way() -> None:
    wish = {"kind": "action", "size": "FS", "focus_on_ids": ("anna",), "movement": "track"}
    here, came = person("anna", 1.5, 0.0, 90), person("anna", -2.0, 0.0, 90)
    bent = replace(here, face=(2.0, 0.0, 0.85))
    view = replace(
        view_of(here, in_frame=("anna",), **wish),
        moments=(Moment(0, (came,)), Moment(40, (bent,)), Moment(47, (here,))),
        plan=None,
    )
    assert view.upright(bent).face == (1.5, 0.0, here.face[2]) and view.upright(here) is here
    take = compose_take(view)
    for moment in view.moments:
        (face,), _ = project(take.at(moment.frame / 47), [moment.figures[0].face])
        assert ((face > 0) & (face < 1)).all()
    told = {
        fault.kind for fault in find_composition_faults(view, take.camera, view.story_moment, _seen(view, take, bent))
    }
    assert "headroom" not in told


def _seen(view: CameraOperatorView, take: CameraOperatorDraft, figure: Figure) -> CameraView:
    (face, top), _ = project(take.camera, [figure.face, figure.crown])
    sight = SubjectView(
        node_id="anna", visible_fraction=1.0, in_frame_fraction=1.0, face=tuple(face), head_top=float(top[1]),
        head_height=0.108,
    )  # fmt: skip
    return CameraView(subjects=(sight,), void=0.0)


def test_walks_are_held_only_where_people_stay_large_enough() -> None:
    sizes = []
    for first in (-1.5, -9.0):
        here, there = person("anna", -0.6, 0.0, 90), person("anna", first, 0.0, 90)
        tom = person("tom", 0.6, 0.0, -90)
        view = view_of(here, tom, in_frame=("anna", "tom"), kind="action", size="FS", focus_on_ids=("anna", "tom"))
        moments = (Moment(0, (there, tom)), Moment(20, (here, tom)), Moment(47, (here, tom)))
        camera = compose_take(replace(view, moments=moments, plan=None)).camera
        (seen,), depth = project(camera, [there.face])
        sizes.append((head_share(camera, tom), bool(depth[0] > 0 and 0 < seen[0] < 1)))
    assert sizes[0][1] and not sizes[1][1], "the long walk comes into the picture"
    assert all(share > 0.6 * 0.108 for share, _ in sizes)


def test_a_shoulder_that_is_not_in_the_picture_costs() -> None:
    pair = person("anna", 0.0, 0.0, 0), person("tom", 0.0, -1.5, 180)
    wish = {"kind": "ots", "size": "MCU", "focus_on_ids": ("anna",), "over_id": "tom"}
    view = view_of(*pair, in_frame=("anna", "tom"), **wish)
    best = scout_takes(view)[0]
    aside = replace(best, camera=orbit(best.camera, 60))
    assert take_cost(view, aside) > take_cost(view, best) + 1.4


def test_a_face_is_seen_beside_the_head_of_whom_we_look_past() -> None:
    shoulders, head = body_boxes(APART[0])
    assert shoulders.top == pytest.approx(head.z) and head.width < shoulders.width
    assert head.top == pytest.approx(APART[0].crown[2])
    pair = person("anna", 0.0, 0.0, 0), person("tom", 0.0, -1.8, 180)
    wish = {"kind": "ots", "size": "MCU", "focus_on_ids": ("anna",), "over_id": "tom"}
    view = replace(view_of(*pair, in_frame=("anna", "tom"), **wish), plan=None)
    assert not find_hidden(body_boxes(pair[1]), compose_take(view).camera.position, [pair[0].face]).any()


def test_a_rise_over_a_shoulder_is_a_rise_once() -> None:
    pair = person("anna", 0.0, 0.0, 0), person("tom", 0.0, -1.8, 180)
    wish = {"kind": "ots", "size": "MCU", "focus_on_ids": ("anna",), "over_id": "tom"}
    view = replace(view_of(*pair, **wish), plan=None)
    assert compose_take(view, 0, 9).camera.elevation - compose_take(view).camera.elevation == pytest.approx(9, abs=1.5)


def test_a_group_is_about_the_middle_when_it_is_drawn_whatever_its_walks_need() -> None:
    tom = person("tom", 0.3, 0.0, -90)
    steps = [Moment(20 * n, (person("anna", x, 0.1, 90), tom)) for n, x in enumerate((-2.4, -0.3, -0.3))]
    view = replace(view_of(*steps[1].figures, kind="two_shot", size="FS", focus_on_ids=("anna", "tom")), plan=None)
    camera = compose_take(replace(view, moments=tuple(steps))).camera
    across = project(camera, [each.face for each in steps[1].figures])[0][:, 0]
    assert abs(float(across.mean()) - 0.5) < 0.1


def test_air_above_small_heads_is_no_fault() -> None:
    far = person("anna", -4, 0, 0), person("tom", 4, 0, 0)
    wish = {"kind": "action", "size": "MWS", "focus_on_ids": ("anna", "tom"), "explicit": True}
    view = replace(view_of(*far, in_frame=("anna", "tom"), **wish), plan=None)
    take = compose_take(view)
    (look,) = NumberFinder(view.moments, {}).look([request(view, take)])
    kinds = {flaw.kind for flaw in find_composition_faults(view, take.camera, view.story_moment, look)}
    assert min(subject.head_top for subject in look.subjects if subject.head_top) > 0.33
    assert "headroom" not in kinds


def request(view: CameraOperatorView, take: CameraOperatorDraft) -> ViewRequest:
    return ViewRequest(scene_id=1, shot_id=1, frame=0, pose=pose_of(take.camera), focus_ids=view.focus)


def test_nobody_of_a_group_fills_the_foreground() -> None:
    view = view_of(*APART, in_frame=NAMES, kind="group", size="FS", focus_on_ids=NAMES)
    near = frame_group_from(Film(), APART, "FS", (-2.7, 0.9, 1.5), 35.0, 18.0)
    far = frame_group_from(Film(), APART, "FS", (0.0, -2.6, 1.5), 35.0, 18.0)
    assert (
        take_cost(view, CameraOperatorDraft(near, near, near))
        > take_cost(view, CameraOperatorDraft(far, far, far)) + 0.5
    )


def test_who_bends_without_a_walk_keeps_the_head_before_and_after() -> None:
    here = person("anna", 0.0, 0.0, 90)
    bent = replace(here, face=(0.35, 0.0, here.face[2] - 0.45))
    wish = {"kind": "action", "size": "MS", "focus_on_ids": ("anna",)}
    moments = (Moment(0, (here,)), Moment(24, (bent,)), Moment(47, (here,)))
    view = replace(view_of(bent, in_frame=("anna",), **wish), moments=moments, plan=None)
    camera = compose_take(view).camera
    for figure in (here, bent):
        screen, _ = project(camera, [figure.crown, figure.face])
        assert ((screen > 0) & (screen < 1)).all()


@pytest.mark.parametrize(
    "wish",
    [
        {"kind": "group", "size": "FS", "focus_on_ids": NAMES},
        {"kind": "single", "size": "FS", "focus_on_ids": ("anna",)},
        {"kind": "pov", "size": "MCU", "focus_on_ids": ("tom",), "pov_id": "anna"},
    ],
)
def test_a_room_too_short_for_a_lens_takes_another_of_the_kit(wish: dict[str, object]) -> None:
    free = replace(view_of(*APART, in_frame=NAMES, **wish), kit=())
    view = replace(free, kit=(16.0, 21.0, 40.0, 65.0))
    lenses = [compose_take(view, turn).camera.lens for turn in (0, 30, -70, 125, 180)]
    assert set(lenses) <= {*view.kit} and min(lenses) < 65
    assert {compose_take(free, turn).camera.lens for turn in (0, 30, -70)} - {*view.kit}, (
        "any lens where no kit is told"
    )
