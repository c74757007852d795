"""The vision critic of the camera beside the engine's: what it is shown, and what its faults lead to."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest
from tests.answering import Answering, Scripted
from tests.unit.agents.layout_artist.test_language_camera_operator import ANNA, FILM, VIEW, Finder

from storyblender.agents.layout_artist.camera_critic import with_camera_critic
from storyblender.agents.layout_artist.camera_operator import operate, rules_operator
from storyblender.agents.layout_artist.camera_operator_view import Moment
from storyblender.agents.layout_artist.language_camera_operator import language_operator
from storyblender.errors import NoAnswer
from storyblender.geometry.camera_path import orbit_of
from storyblender.memory.camera_decision import CameraDecision, CameraPosition, FreeCamera
from storyblender.memory.shot_context import CameraState
from storyblender.trace import Event


def said(score: float, *faults: dict[str, Any]) -> str:
    return json.dumps({"score": score, "faults": faults})


def judged(critic: Any, view: Any = VIEW, events: list[Event] | None = None) -> CameraState:
    """Return the camera of a shot by rules, with a vision critic."""
    listener = (events if events is not None else []).append
    return operate(view, Finder(), with_camera_critic(critic, rules_operator), listener)


def azimuth(state: CameraState) -> float:
    return orbit_of(state.poses[0], FILM).azimuth


def test_a_picture_that_it_likes_is_the_rules_own() -> None:
    critic = Scripted([said(9)])
    state = judged(critic)
    assert (state.poses, state.hidden_node_ids) == (operate(VIEW, Finder()).poses, ())
    assert 9.25 < state.score < 10
    asked = critic.asked[0]
    assert (asked.role, asked.subject, [each.name for each in asked.pictures]) == (
        "camera_critic", "SC010_SH020", ["frame_0"],
    )  # fmt: skip
    assert json.loads(asked.view)["shot"]["subjects"] == ["anna"]


def test_what_it_minds_leads_to_another_camera() -> None:
    """A post behind her: whoever looks from the rules' own side is told to go around."""
    home = azimuth(operate(VIEW, Finder()))

    def look(view: dict[str, Any]) -> dict[str, Any]:
        if abs(view["camera"]["azimuth"] - home) > 10:
            return {"score": 8.5}
        fault = {"message": "a post grows out of her head", "subject": "anna", "operations": ["orbit_left"]}
        return {"score": 5, "faults": [fault]}

    events: list[Event] = []
    state = judged(Answering(look), events=events)
    assert abs(azimuth(state) - home) > 10
    assert state.score >= 9.25
    told = [detail for event in events if event.kind == "score" for detail in event.details]
    assert any("camera_critic gives 5: a post grows out of her head (orbit_left)" in each for each in told)


def test_what_nothing_mends_is_kept_with_the_camera() -> None:
    fault = {"message": "she is lost before the wall"}
    state = judged(Answering(lambda view: {"score": 6, "faults": [fault]}))
    assert state.score < 9.25
    assert "she is lost before the wall" in [flaw.message for flaw in state.residual]


def test_without_an_answer_the_camera_is_the_rules_own() -> None:
    critic = Scripted([NoAnswer("gone")] * 9)
    assert judged(critic) == operate(VIEW, Finder())


def test_a_camera_that_a_person_placed_is_not_judged_by_a_model() -> None:
    start = CameraPosition(location=(0.5, -3.0, 1.5), target=(0.0, 0.0, 1.5))
    state = judged(Scripted([]), replace(VIEW, asked=CameraDecision(placed=FreeCamera(start=start))))
    assert orbit_of(state.poses[0], FILM).position == pytest.approx(start.location)


def test_where_people_walk_it_sees_beginning_moment_and_end() -> None:
    far = replace(ANNA, face=(2.0, 0.0, 1.6), base=(2.0, 0.0, 0.0))
    walk = replace(VIEW, moments=(Moment(0, (ANNA,)), Moment(20, (ANNA,)), Moment(47, (far,))))
    critic = Answering(lambda view: {"score": 9})
    judged(critic, walk)
    assert [each.name for each in critic.asked[0].pictures] == ["frame_0", "frame_20", "frame_47"]


@pytest.mark.parametrize("score", [3, 8])
def test_a_model_at_the_camera_reads_what_the_critic_said(score: float) -> None:
    model = Scripted(['{"view": 1}', *['{"operations": ["orbit_left"]}', '{"operations": ["orbit_right"]}'] * 5])
    fault = {"message": "a post grows out of her head", "operations": ["orbit_left"]}
    critic = Answering(lambda view: {"score": score, "faults": [fault]})
    operate(VIEW, Finder(), with_camera_critic(critic, language_operator(model, rules_operator)))
    if score >= 8:
        assert len(model.asked) == 1
    else:
        now = json.loads(model.asked[1].view)["now"]
        assert {"is": fault["message"], "try": fault["operations"]} in now["faults"]
