"""The Frame Critic compares a frame with what a person asked of its camera."""

from __future__ import annotations

import math
from typing import Any

import pytest

from storyblender.agents.frame_critic.critic import FrameCritic, verdict_of
from storyblender.agents.frame_critic.frame_view import FrameView
from storyblender.memory.camera_decision import CameraDecision
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, ShotContext
from storyblender.memory.shot_sizes import SHOT_SIZES, SIZES

_INSTRUCTION = CameraInstruction(focus_on_ids=("mara",), kind="single", size="MS")


def _person(name: str, head: float, angle: float = 20.0, x: float = 0.5) -> SubjectView:
    return SubjectView(
        node_id=name, visible_fraction=0.9, in_frame_fraction=0.95, box=(0.3, 0.1, 0.6, 0.9), pixels=0.2,
        face=(x, 0.3), face_visible=0.9, head_height=head, face_angle=angle,
    )  # fmt: skip


def _faults(asked: dict[str, Any], *seen: SubjectView, down: float = 2.0, lens: float = 50.0) -> set[str]:
    """Return what is wrong with a frame of a camera that looks so many degrees down, and that it then does not pass."""
    decision = CameraDecision.model_validate(asked)
    tilt = math.radians(90 - down) / 2
    pose = CameraPose(pivot=(0, 0, 1.5), rotation=(math.cos(tilt), math.sin(tilt), 0, 0), distance=2, lens=lens)
    shot = ShotContext(
        scene_id=1, shot_id=1, on_stage=("mara", "ben", "cleo"), in_frame=("mara",), duration=48,
        camera_instruction=decision.applied(_INSTRUCTION), camera_decision=decision if asked else None,
        camera=CameraState(poses=(pose,)),
    )  # fmt: skip
    people = frozenset({"mara", "ben", "cleo"})
    view = FrameView(shot, CameraView(subjects=seen, void=0.0), people, None, {}, {})
    critique = FrameCritic().judge(view)
    assert (verdict_of(critique.score) == "pass") == (not critique.faults)
    return {fault.kind for fault in critique.faults}


def test_a_head_is_as_large_as_the_size_that_was_asked_for() -> None:
    for asked in SHOT_SIZES[2:]:
        for drawn in SHOT_SIZES[2:]:
            wrong = "not_the_size" in _faults({"size": asked}, _person("mara", SIZES[drawn].head))
            far = abs(math.log(SIZES[asked].head / SIZES[drawn].head)) > math.log(1.7)
            assert wrong == far, (asked, drawn)


def test_nothing_is_compared_where_nothing_was_asked() -> None:
    assert not _faults({}, _person("mara", 0.5), down=80, lens=18)


@pytest.mark.parametrize(
    ("angle", "down", "wrong"),
    [("low angle", -16, False), ("low angle", 4, True), ("bird's-eye", 65, False), ("bird's-eye", 20, True),
     ("eye-level", 40, True), ("dutch", 2, True)],
)  # fmt: skip
def test_the_camera_looks_down_as_asked(angle: str, down: float, wrong: bool) -> None:
    assert ("not_the_angle" in _faults({"angle": angle}, _person("mara", 0.21), down=down)) == wrong


def test_lens_and_move_are_as_asked() -> None:
    assert _faults({"lens": 85}, _person("mara", 0.21), lens=50) == {"not_the_lens"}
    assert not _faults({"lens": 85}, _person("mara", 0.21), lens=85)
    assert _faults({"movement": "push in"}, _person("mara", 0.21)) == {"no_move"}


def test_the_shoulder_that_was_asked_for_is_in_front_and_seen_from_behind() -> None:
    asked = {"kind": "ots", "over_id": "ben", "focus_on_ids": ["mara"]}
    mara = _person("mara", 0.21)
    assert not _faults(asked, mara, _person("ben", 0.3, angle=140, x=0.2))
    assert _faults(asked, mara) == {"no_shoulder"}
    assert _faults(asked, mara, _person("ben", 0.3, angle=20, x=0.2)) == {"no_shoulder"}
    assert _faults(asked, mara, _person("ben", 0.1, angle=140, x=0.2)) == {"no_shoulder"}


def test_everybody_who_was_asked_for_is_seen() -> None:
    asked = {"kind": "group", "focus_on_ids": ["mara", "ben", "cleo"], "size": "MS"}
    people = [_person(name, 0.21) for name in ("mara", "ben", "cleo")]
    assert not _faults(asked, *people)
    for gone in people:
        assert "person_missing" in _faults(asked, *(each for each in people if each is not gone))
