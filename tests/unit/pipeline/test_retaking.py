"""A poor frame is taken again with a camera that may mend it; what the script or a person ordered is left alone."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.stage import Stage

from storyblender.memory.shot_context import CameraDecision, CameraInstruction, ShotContext
from storyblender.pipeline.retaking import _another_camera, _with_camera
from storyblender.pipeline.reviewing import FrameReview
from storyblender.reflection import Fault


def _review(kind: str, score: float = 4.0) -> FrameReview:
    return FrameReview(shot="SC010_SH010", judged="", score=score, faults=(Fault(kind=kind, message="", severity=4),))


def _shot(**camera: object) -> ShotContext:
    instruction = CameraInstruction.model_validate({"size": "MS", **camera})
    return ShotContext(scene_id=1, shot_id=1, camera_instruction=instruction)


@pytest.mark.parametrize(
    ("kind", "attempt", "choice"),
    [
        ("person_missing", 0, CameraDecision(size="MWS")),
        ("person_missing", 1, CameraDecision(size="FS")),
        ("flat", 0, CameraDecision(size="MCU")),
        ("person_hidden", 0, CameraDecision(angle="high angle")),
        ("person_hidden", 1, CameraDecision(size="FS")),
    ],
)
def test_the_worst_fault_chooses_the_camera(kind: str, attempt: int, choice: CameraDecision) -> None:
    assert _another_camera(_shot(), _review(kind), attempt) == choice


def test_what_passes_or_was_decided_stays() -> None:
    poor = _review("person_missing")
    assert _another_camera(_shot(), _review("person_missing", score=9.0), 0) is None
    assert _another_camera(_shot(kind="insert"), poor, 0) is None
    assert _another_camera(_shot().model_copy(update={"locked": ("camera",)}), poor, 0) is None
    assert _another_camera(_shot().model_copy(update={"camera_decision": CameraDecision(lens=50)}), poor, 0) is None
    assert _another_camera(_shot(), _review("stand_in"), 0) is None, "no camera mends that"


def test_a_retake_is_kept_apart_from_what_the_director_planned() -> None:
    taken = _with_camera(_shot(lens=50.0), CameraDecision(size="WS"))
    assert taken.camera is None and taken.camera_instruction.size == "WS" and taken.camera_instruction.lens is None
    assert taken.camera_retake == CameraDecision(size="WS") and taken.camera_decision is None


def test_an_ordered_size_is_kept_and_the_angle_is_the_crews() -> None:
    assert _another_camera(_shot(explicit=True), _review("person_hidden"), 0) == CameraDecision(angle="high angle")
    assert _another_camera(_shot(explicit=True, angle="low angle"), _review("person_hidden"), 0) is None
    assert _another_camera(_shot(explicit=True), _review("flat"), 0) is None, "only another size would mend that"
    assert _another_camera(_shot(explicit=True), _review("person_missing"), 1) is None


def test_a_shot_is_tried_once_and_a_later_run_leaves_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stage = Stage(tmp_path / "p", monkeypatch, retakes=2)
    first = stage.render()
    assert first["render_frame"] > 3, "every shot is poor, and at least one was taken again"
    assert not stage.render(), "nothing is left to do"
