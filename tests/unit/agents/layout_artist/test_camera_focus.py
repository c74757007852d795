"""What the lens is focused on: told people and things stay sharp, orders are obeyed."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from tests.unit.agents.layout_artist.test_camera_operator import NumberFinder, figure

from storyblender.agents.layout_artist.camera_focus import with_focus
from storyblender.agents.layout_artist.camera_operator import operate
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment, pose_of
from storyblender.geometry.boxes import Box
from storyblender.geometry.camera_path import camera_at, focus_at
from storyblender.geometry.framing import Figure, Film, project
from storyblender.geometry.orbit import camera_looking_at
from storyblender.look.optics import SHARP, Lens
from storyblender.memory.shot_context import CameraInstruction, CameraState
from storyblender.memory.shot_sizes import SHOT_SIZES, TIGHT

FILM = Film()
ANA, BEN = figure("ana", 0, 0, 0), figure("ben", 0.4, 3.0, 0)
STATE = CameraState(poses=(pose_of(camera_looking_at((0, -2.2, 1.64), ANA.face, 85)),), f_number=4)


def view(*figures: Figure, props: dict[str, Box] | None = None, **wanted: Any) -> CameraOperatorView:
    instruction = CameraInstruction.model_validate({"focus_on_ids": ("ana",), "kind": "single", "size": "CU"} | wanted)
    moments = tuple(Moment(frame, figures or (ANA, BEN)) for frame in (0, 40, 95))
    return CameraOperatorView(1, 1, instruction, 96, moments, props=props or {})


def blur(state: CameraState, point: tuple[float, float, float], frame: int = 0) -> float:
    focus, depth = focus_at(state, frame, FILM), float(project(camera_at(state, frame, FILM), [point])[1][0])
    assert focus is not None
    return abs(float(Lens(85, state.f_number, focus).blur_circle(np.array([depth]))[0]))


@pytest.mark.parametrize("size", SHOT_SIZES)
def test_without_an_order_only_tight_shots_have_a_depth_of_field(size: str) -> None:
    found = with_focus(view(size=size), STATE)
    assert bool(found.focus) == (size in TIGHT)
    assert found.focus or found == STATE


def test_the_eyes_are_sharp_and_who_stands_behind_is_not() -> None:
    found = with_focus(view(), STATE)
    eyes = (0, ANA.face[1] - 0.4 * ANA.head, ANA.face[2])
    assert blur(found, eyes) < SHARP / 36 < blur(found, BEN.face)


def test_it_is_stopped_down_until_what_the_shot_is_about_is_sharp() -> None:
    other = figure("ben", 0.3, 0.4, 0)
    found = with_focus(view(ANA, other, kind="two_shot", focus_on_ids=("ana", "ben"), explicit=True), STATE)
    assert found.focus and found.f_number > 4 and blur(found, other.face) < 1.3 * SHARP / 36
    apart = with_focus(view(focus_on_ids=("ana", "ring"), props={"ring": Box(0.1, 9, 1.6, 0.1, 0.1, 0.1)}), STATE)
    assert apart == STATE  # no stop will do: everything is sharp


def test_an_order_is_obeyed_in_any_size() -> None:
    found = with_focus(view(size="WS", f_number=2.0), STATE)
    assert found.f_number == 2 and found.focus[0].node_id == "ana"
    on_ben = with_focus(view(size="WS", focus="ben"), STATE)
    assert on_ben.focus[0].node_id == "ben" and on_ben.f_number <= 2


def test_who_is_not_there_is_said_and_the_subject_is_sharp() -> None:
    found = with_focus(view(focus="guard"), STATE)
    assert found.focus[0].node_id == "ana"
    assert [(flaw.kind, flaw.subject) for flaw in found.residual] == [("focus", "guard")]


def test_a_rack_focus_goes_from_one_to_the_other_and_not_at_the_moment_that_is_drawn() -> None:
    found = with_focus(view(size="MS", focus="ana", focus_to="ben"), STATE)
    depths = [focus_at(found, frame, FILM) or 0 for frame in range(96)]
    drawn = depths[40]
    assert depths[0] == pytest.approx(2.2, abs=0.15) and depths[-1] == pytest.approx(5.2, abs=0.15)
    assert min(abs(drawn - depths[0]), abs(drawn - depths[-1])) < 0.02
    assert all(later >= earlier - 1e-6 for earlier, later in pairwise(depths))


def test_the_focus_follows_who_walks() -> None:
    near = figure("ana", 0, -1.0, 0)
    walk = view()
    walk = CameraOperatorView(1, 1, walk.instruction, 96, (Moment(0, (ANA,)), Moment(48, (ANA,)), Moment(95, (near,))))
    found = with_focus(walk, STATE)
    depths = [focus_at(found, frame, FILM) or 0 for frame in (0, 48, 95)]
    assert depths[0] == pytest.approx(depths[1]) and depths[1] - depths[2] == pytest.approx(1.0, abs=0.05)


def test_the_operator_hands_over_a_focused_camera() -> None:
    tight = view()
    found = operate(tight, NumberFinder(tight.moments, {}))
    assert found.focus and found.focus[0].node_id == "ana"
