"""A poor frame is taken again with a camera that may mend it; what the script or a person ordered is left alone."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.stage import Stage

from storyblender.memory.shot_context import (
    Blocking,
    CameraDecision,
    CameraInstruction,
    CameraRetake,
    CharacterAction,
    Mark,
    ShotContext,
)
from storyblender.pipeline.retaking import _another_camera, _another_moment, _better, _choice, _simpler, _with_camera
from storyblender.pipeline.reviewing import FrameReview
from storyblender.reflection import Fault


def _review(kind: str, score: float = 4.0) -> FrameReview:
    return FrameReview(shot="SC010_SH010", judged="", score=score, faults=(Fault(kind=kind, message="", severity=4),))


def _shot(**camera: object) -> ShotContext:
    instruction = CameraInstruction.model_validate({"size": "MS", **camera})
    return ShotContext(scene_id=1, shot_id=1, camera_instruction=instruction)


@pytest.mark.parametrize(
    ("kind", "choice"),
    [
        ("person_missing", CameraRetake(size="MWS")),
        ("flat", CameraRetake(size="MCU")),
        ("person_hidden", CameraRetake(angle="high angle")),
    ],
)
def test_the_worst_fault_chooses_the_camera(kind: str, choice: CameraRetake) -> None:
    assert _another_camera(_shot(), _review(kind)) == choice


@pytest.mark.parametrize(("apart", "size"), [(2.8, "MWS"), (3.6, "FS"), (11.0, "WS")])
def test_a_two_shot_grows_until_both_are_in_it(apart: float, size: str) -> None:
    both = _shot(kind="two_shot", focus_on_ids=("anna", "tom"))
    marks = [Mark(asset_id=name, location=(x, 0.0, 0.0), yaw=0.0) for name, x in (("anna", 0.0), ("tom", apart))]
    there = both.model_copy(update={"on_stage": ("anna", "tom"), "blocking": tuple(map(_stands, marks))})
    review = FrameReview(
        shot="SC010_SH010", judged="", score=4.0, faults=(Fault(kind="partner_missing", subject="tom", message=""),)
    )
    assert _another_camera(there, review) == CameraRetake(size=size)
    assert _another_camera(both, review) is None, "no size shows who is not there"


def _stands(mark: Mark) -> Blocking:
    return Blocking(start=mark, end=mark)


def test_what_passes_or_was_decided_stays() -> None:
    poor = _review("person_missing")
    assert _choice(_another_camera, _shot(), _review("person_missing", score=9.0)) is None
    assert _choice(_another_camera, _shot(kind="insert"), poor) is None
    assert _choice(_another_camera, _shot().model_copy(update={"locked": ("camera",)}), poor) is None
    decided = _shot().model_copy(update={"camera_decision": CameraDecision(lens=50)})
    assert _choice(_another_camera, decided, poor) is None
    assert _choice(_another_camera, _shot(), _review("stand_in")) is None, "no camera mends that"


def test_a_retake_is_kept_apart_from_what_the_director_planned() -> None:
    taken = _with_camera(_shot(lens=50.0), CameraRetake(size="WS"))
    assert taken.camera is None and taken.camera_instruction.size == "WS" and taken.camera_instruction.lens is None
    assert taken.camera_retake == CameraRetake(size="WS") and taken.camera_decision is None


def test_what_does_not_fit_from_below_is_first_seen_level() -> None:
    below = _shot(angle="low angle")
    assert _another_camera(below, _review("face_out")) == CameraRetake(angle="eye-level")
    assert _another_camera(_shot(angle="eye-level"), _review("face_out")) == CameraRetake(size="MWS")


def test_an_ordered_size_is_kept_and_the_angle_is_the_crews() -> None:
    assert _another_camera(_shot(explicit=True), _review("person_hidden")) == CameraRetake(angle="high angle")
    assert _another_camera(_shot(explicit=True, angle="low angle"), _review("person_hidden")) is None
    assert _another_camera(_shot(explicit=True), _review("flat")) is None, "only another size would mend that"


def _scene(**camera: object) -> ShotContext:
    deeds = (("tom", "walk"), ("anna", "talk"))
    actions = tuple(CharacterAction(asset_id=who, motion=what, action_description="") for who, what in deeds)
    camera = {"kind": "two_shot", "focus_on_ids": ("tom", "anna"), "over_id": None, **camera}
    return _shot(**camera).model_copy(update={"on_stage": ("tom", "anna"), "character_actions": actions})


def test_a_simpler_shot_is_of_who_speaks_or_else_of_the_subject() -> None:
    poor = _review("apart")
    silent = _scene().model_copy(update={"character_actions": ()})
    speaker, subject = _simpler(_scene(), poor), _simpler(silent, poor)
    assert speaker is not None and speaker.focus_on_ids == ("anna",) and speaker.kind == "single"
    assert subject is not None and subject.focus_on_ids == ("tom",)
    taken = _with_camera(_scene(axis=("tom", "anna")), speaker)
    assert taken.camera_instruction.focus_on_ids == ("anna",) and taken.camera_instruction.axis is None
    assert _choice(_simpler, _with_camera(silent, subject), poor) is None, "it is that picture"


@pytest.mark.parametrize("wish", [{"explicit": True}, {"kind": "insert"}, {"kind": "pov"}])
def test_what_the_script_orders_is_not_made_simpler(wish: dict[str, object]) -> None:
    assert _simpler(_scene(**wish), _review("apart")) is None


def test_a_moment_that_was_chosen_stays() -> None:
    hidden = _review("person_hidden")
    assert _another_moment(_scene(), hidden) == CameraRetake(moment="end")
    assert _another_moment(_scene().model_copy(update={"moment": "start"}), hidden) is None
    assert _another_moment(_scene(), _review("dark")) is None
    assert _with_camera(_scene(), CameraRetake(moment="end")).moment == "end"


def test_a_shot_is_tried_once_and_a_later_run_leaves_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stage = Stage(tmp_path / "p", monkeypatch, retakes=2)
    first = stage.render()
    assert first["render_frame"] > 3, "every shot is poor, and at least one was taken again"
    assert not stage.render(), "nothing is left to do"


def _of_faults(*severities: float) -> FrameReview:
    faults = tuple(Fault(kind="flat", message="", severity=each) for each in severities)
    return FrameReview(shot="SC010_SH010", judged="", score=max(1.0, 10 - sum(severities)), faults=faults)


def test_the_better_of_two_very_poor_takes_is_kept() -> None:
    worst, poor = _of_faults(4, 4, 4, 4), _of_faults(4, 4, 3)
    assert worst.score == poor.score == 1.0
    assert _better(poor, worst, CameraRetake(size="WS"))
    assert not _better(worst, poor, CameraRetake(size="WS"))
    assert not _better(poor, poor, CameraRetake(size="WS"))
    assert not _better(_of_faults(3), _of_faults(4), CameraRetake(angle="high angle")), "people look worse from above"


def test_another_moment_that_no_longer_shows_an_action_is_not_better() -> None:
    hidden, done = Fault(kind="face_hidden", message="", severity=4), {"kind": "not_done", "message": "", "severity": 1}
    review = _review("face_hidden")
    before = review.model_copy(update={"faults": (hidden, Fault(**done, subject="anna"))})
    end = CameraRetake(moment="end")
    assert _better(review.model_copy(update={"faults": (Fault(**done, subject="anna"),)}), before, end)
    unseen = review.model_copy(update={"faults": (Fault(**done, subject="bert"),)})
    assert not _better(unseen, before, end)
    assert _better(unseen, before, CameraRetake(size="WS")), "that is for its cameras to say"
