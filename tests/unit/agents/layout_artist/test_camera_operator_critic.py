"""What the critic takes off for what the viewfinder saw: every picture here is written down, not drawn."""

from collections.abc import Sequence
from dataclasses import replace
from types import SimpleNamespace

import pytest
from test_camera_operator import ANNA, GUARD, TOM, figure, view_of

from storyblender.agents.layout_artist.camera_operator import apply_numbers, numbers_of
from storyblender.agents.layout_artist.camera_operator_critic import CameraOperatorCritic, moments_to_judge
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment
from storyblender.agents.layout_artist.camera_scout import take_cost
from storyblender.agents.layout_artist.camera_start import compose_take, take_with_camera
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import project
from storyblender.geometry.orbit import pan, roll
from storyblender.memory.camera_decision import CameraDecision, FreeCamera
from storyblender.memory.measure import CameraView, SubjectView, ViewRequest
from storyblender.reflection import Fault

SEEN = {"visible_fraction": 0.8, "in_frame_fraction": 0.8, "box": (0.3, 0.2, 0.6, 1.0), "pixels": 0.1}
FACE = {"face": (0.5, 0.25), "face_visible": 1.0, "head_height": 0.2, "head_top": 0.12, "face_angle": 40.0}
CUP = Box(0.3, 0.3, 0.8, 0.1, 0.1, 0.1)


class Written:
    """A viewfinder that sees what is written for a frame."""

    def __init__(self, views: dict[int, tuple[SubjectView, ...]]) -> None:
        self.views = views

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        return [CameraView(subjects=self.views[request.frame], void=0.0) for request in requests]


def sight(node: str, **changes) -> SubjectView:
    return SubjectView(node_id=node, **({**SEEN, **FACE} | changes))


def thing(node: str, **changes) -> SubjectView:
    return SubjectView(node_id=node, **(SEEN | changes))


def faults(
    view: CameraOperatorView, *subjects: SubjectView, **others: tuple[SubjectView, ...]
) -> dict[tuple[str, str], Fault]:
    views = {view.story_moment.frame: subjects} | {int(frame[1:]): seen for frame, seen in others.items()}
    found = CameraOperatorCritic(Written(views)).judge(compose_take(view), view).faults
    return {(fault.kind, fault.subject): fault for fault in found}


def test_a_thing_in_a_picture_of_people_weighs_less_than_a_person_in_it() -> None:
    view = view_of(kind="two_shot", size="MS", focus_on_ids=("anna", "tom", "cup"), props={"cup": CUP})
    behind = {"visible_fraction": 0.0}
    found = faults(view, sight("anna"), sight("tom", **behind), thing("cup", **behind))
    assert found["hidden", "cup"].severity < 1.5 < found["hidden", "tom"].severity
    alone = view_of((), kind="insert", size="CU", focus_on_ids=("cup",), props={"cup": CUP})
    assert faults(alone, thing("cup", **behind))["hidden", "cup"].severity > 2


def test_a_face_may_turn_away_before_it_is_drawn() -> None:
    moments = tuple(Moment(frame, (ANNA, TOM)) for frame in (0, 20, 40))
    view = view_of(moments=moments, kind="two_shot", size="MS", focus_on_ids=("anna", "tom"), movement="push in")
    good, away = (sight("anna"), sight("tom")), (sight("anna", face_angle=170.0), sight("tom"))
    assert ("face_away", "anna") not in faults(view, *good, _0=away, _40=good)
    assert ("face_away", "anna") in faults(view, *away, _0=good, _40=good)


@pytest.mark.parametrize(("size", "cut"), [("MS", True), ("MCU", False)])
def test_the_frame_takes_no_crown_off_whoever_belongs_in_it(size: str, cut: bool) -> None:
    wish = {"kind": "ots", "size": size, "focus_on_ids": ("anna",), "over_id": "tom", "in_frame": ("guard",)}
    view = view_of((ANNA, TOM, GUARD), **wish)
    found = faults(view, sight("anna"), sight("tom"), sight("guard", head_top=-0.08, face=(0.8, 0.05)))
    assert (("beheaded", "guard") in found) == cut
    if cut:
        assert found["beheaded", "guard"].fix["pan_y"] == pytest.approx(0.12)


def test_a_shoulder_has_its_head_in_the_picture_or_nearly() -> None:
    view = view_of(kind="ots", size="MS", focus_on_ids=("anna",), over_id="tom")
    assert ("no_shoulder", "tom") in faults(view, sight("anna"), sight("tom", face=(1.2, 0.2)))
    assert ("no_shoulder", "tom") not in faults(view, sight("anna"), sight("tom", face=(0.9, 0.2)))


@pytest.mark.parametrize("kind", ["face_out", "out_of_frame"])
@pytest.mark.parametrize(("dx", "dy"), [(0.9, 0.0), (-0.7, 0.2), (0.1, -0.8)])
def test_a_lone_subject_outside_the_picture_is_panned_back_by_numbers(kind: str, dx: float, dy: float) -> None:
    view = view_of((ANNA,), kind="single", size="MCU", focus_on_ids=("anna",))
    good = compose_take(view).camera
    take = take_with_camera(view, pan(good, dx, dy))
    gone = {"face": (1.4, 0.3), "in_frame_fraction": 0.5 if kind == "face_out" else 0.0}
    finder = Written({view.story_moment.frame: (sight("anna", **gone),)})
    told = {fault.kind: fault for fault in CameraOperatorCritic(finder).judge(take, view).faults}
    assert "ops" not in told[kind].fix, "numbers alone, which code applies"
    back = apply_numbers(take.camera, numbers_of(told[kind]))
    assert project(back, [ANNA.face])[0][0] == pytest.approx((0.5, 0.4), abs=0.01)


def test_of_two_subjects_neither_is_panned_out_for_the_other() -> None:
    view = view_of(kind="two_shot", size="MS", focus_on_ids=("anna", "tom"))
    fix = faults(view, sight("anna", face=(1.3, 0.3)), sight("tom"))["face_out", "anna"].fix
    assert fix == {"ops": "zoom_out"}


@pytest.mark.parametrize(("pixels", "hidden"), [(0.001, True), (0.2, False)])
def test_an_insert_of_hidden_feet_is_taken_from_elsewhere(pixels: float, hidden: bool) -> None:
    feet = Box(0.0, 0.0, 0.0, 0.3, 0.3, 0.1)
    view = replace(view_of((ANNA,), kind="insert", size="CU", focus_on_ids=("anna",)), detail=feet)
    found = faults(view, sight("anna", pixels=pixels))
    assert (("hidden", "anna") in found) == hidden


def test_the_larger_a_body_without_a_head_the_worse() -> None:
    view = view_of((ANNA, TOM, GUARD), kind="single", size="MS", focus_on_ids=("anna",))
    bodies = (sight("guard", head_top=-0.3, face=(0.8, -0.2), pixels=pixels) for pixels in (0.02, 0.12, 0.3))
    costs = [faults(view, sight("anna"), body)["beheaded", "guard"].severity for body in bodies]
    assert costs == sorted(set(costs)) and costs[0] == 1.0 and costs[-1] == 3.0


def test_of_an_insert_nobody_is_asked_to_be_whole() -> None:
    cut = sight("anna", face=(0.5, -0.4), head_top=-0.6, box=(0.0, 0.0, 0.5, 1.0), pixels=0.3)
    view = view_of((ANNA,), kind="insert", size="CU", focus_on_ids=("cup",), props={"cup": CUP}, in_frame=("anna",))
    found = faults(view, cut, thing("cup", box=(0.2, 0.2, 0.75, 0.75)))
    assert not [kind for kind, subject in found if subject == "anna"]


def test_a_picture_of_a_place_alone_is_not_empty() -> None:
    assert faults(view_of((), kind="action", size="WS")) == {}


@pytest.mark.parametrize(("focus", "minded"), [((), False), (("cup",), True)])
def test_the_floor_of_a_place_is_no_foreground(focus: tuple[str, ...], minded: bool) -> None:
    view = view_of((), kind="establishing", size="EWS", focus_on_ids=focus, props={"cup": CUP})
    finder = SimpleNamespace(
        look=lambda requests: [CameraView(subjects=(), void=0.0, foreground=0.4) for _ in requests]
    )
    found = CameraOperatorCritic(finder).judge(compose_take(view), view).faults
    assert ("foreground" in {fault.kind for fault in found}) == minded


def test_of_two_in_each_others_arms_one_face_is_enough() -> None:
    close = (figure("anna", -0.12, 0, 90, 1.65), figure("tom", 0.12, 0, -90, 1.8))
    back = sight("tom", face_angle=165.0)
    for people, one_is_enough in ((close, True), ((ANNA, TOM), False)):
        view = view_of(people, kind="action", size="MWS", focus_on_ids=("anna", "tom"))
        assert (("face_away", "tom") not in faults(view, sight("anna"), back)) == one_is_enough
    view = view_of(close, kind="action", size="MWS", focus_on_ids=("anna", "tom"))
    assert ("face_away", "tom") in faults(view, sight("anna", face_angle=165.0), back)


def test_a_camera_that_stands_still_is_looked_through_when_it_is_drawn() -> None:
    moments = (Moment(0, (GUARD, TOM)), Moment(20, (ANNA, TOM)), Moment(40, (ANNA, GUARD)))
    still = view_of(moments=moments, kind="two_shot", size="MS", focus_on_ids=("anna", "tom"))
    assert moments_to_judge(still, [compose_take(still)]) == [still.story_moment]
    pushed = view_of(moments=moments, kind="two_shot", size="MS", focus_on_ids=("anna", "tom"), movement="push in")
    assert moments_to_judge(pushed, [compose_take(pushed)]) == list(moments)


@pytest.mark.parametrize(("x", "cut"), [(0.03, True), (0.15, False)])
def test_the_frame_cuts_nobody_of_a_group_at_its_sides(x: float, cut: bool) -> None:
    view = view_of(kind="two_shot", size="MS", focus_on_ids=("anna", "tom"))
    found = faults(view, sight("anna", face=(x, 0.25)), sight("tom", face=(1 - x, 0.25)))
    assert (("squeezed", "anna") in found) == cut
    camera = compose_take(view).camera
    near = replace(camera, distance=camera.distance * (0.7 if cut else 1.0))
    assert (
        take_cost(view, replace(compose_take(view), start=near, end=near, camera=near))
        > take_cost(view, compose_take(view)) + 1
    ) == cut


@pytest.mark.parametrize(("angle", "placed"), [("eye-level", 0.0), ("dutch", 12.0)])
def test_a_horizon_that_leans_is_brought_back_by_its_number(angle: str, placed: float) -> None:
    view = view_of(kind="single", size="MS", focus_on_ids=("anna",), angle=angle)
    critic = CameraOperatorCritic(Written({view.story_moment.frame: (sight("anna"),)}))
    composed = compose_take(view)
    assert "roll" not in {fault.kind for fault in critic.judge(composed, view).faults}
    for off in (-14.0, 9.0, 30.0):
        leaning = take_with_camera(view, roll(composed.camera, off))
        [found] = [fault for fault in critic.judge(leaning, view).faults if fault.kind == "roll"]
        mended = take_with_camera(view, apply_numbers(leaning.camera, numbers_of(found)))
        assert abs(mended.camera.roll) == pytest.approx(placed)
        assert "roll" not in {fault.kind for fault in critic.judge(mended, view).faults}
        by_hand = replace(
            view, asked=CameraDecision(placed=FreeCamera(start={"location": (0, 0, 1), "target": (1, 0, 1)}))
        )
        assert "roll" not in {fault.kind for fault in critic.judge(leaning, by_hand).faults}
