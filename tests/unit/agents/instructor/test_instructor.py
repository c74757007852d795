"""Words of a person become edits; what is not understood is said, and nothing is done."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from tests.answering import Scripted
from tests.crew import crew_of
from tests.stage import Stage

from storyblender.agents.instructor.instructor import (
    Instruction,
    InstructorCritic,
    InstructorView,
    RulesInstructor,
    ShotNow,
    instructor_view,
)
from storyblender.agents.instructor.language_instructor import language_instructor
from storyblender.agents.instructor.mentions import Mentions
from storyblender.errors import InputError
from storyblender.memory.camera_decision import CameraInstruction
from storyblender.memory.edits import CameraEdit, DurationEdit, LockEdit
from storyblender.reflection import reflect
from storyblender.settings import Settings
from storyblender.studio import Studio

NAMES = {"rick": "Rick Blaine", "ilsa": "Ilsa Lund", "piano": "upright piano"}
SHOT = "SC010_SH020"


def view(words: str) -> InstructorView:
    now = ShotNow(
        name=SHOT, camera=CameraInstruction(size="MS", focus_on_ids=("ilsa",)), frames=48, lens=50.0, on_stage=("rick",)
    )
    return InstructorView(words, (now,), NAMES, 24)


def meant(words: str) -> dict[str, object]:
    """Return what the words decide about the camera."""
    draft = RulesInstructor().propose(view(words))
    assert not draft.unclear, draft.unclear
    assert InstructorCritic().judge(draft, view(words)).score == 10
    [edit] = draft.edits
    assert isinstance(edit, CameraEdit) and edit.shot == SHOT
    return edit.decision.model_dump(exclude_none=True)


@pytest.mark.parametrize(
    ("words", "decision"),
    [
        ("closer", {"size": "MCU"}),
        ("Much closer, please.", {"size": "CU"}),
        ("a bit wider", {"size": "MWS"}),
        ("way further back", {"size": "FS"}),
        ("close-up", {"size": "CU"}),
        ("extreme close-up of Ilsa", {"size": "ECU", "focus_on_ids": ("ilsa",)}),
        ("wide shot", {"size": "WS"}),
        ("lower", {"angle": "low angle"}),
        ("higher", {"angle": "high angle"}),
        ("low angle", {"angle": "low angle"}),
        ("bird's-eye view", {"angle": "bird's-eye"}),
        ("dutch angle", {"angle": "dutch"}),
        ("85 mm", {"lens": 85.0}),
        ("longer lens", {"lens": 70.0}),
        ("wider lens", {"lens": 36.0}),
        ("f/2.8", {"f_number": 2.8}),
        ("shallow focus", {"f_number": 1.4}),
        ("deep focus", {"f_number": 32.0}),
        ("focus on Rick", {"focus": "rick"}),
        ("rack focus from Ilsa to the piano", {"focus": "ilsa", "focus_to": "piano"}),
        ("slow push in", {"movement": "push in"}),
        ("pan left", {"movement": "pan", "direction": "left"}),
        ("tilt up", {"movement": "tilt", "direction": "up"}),
        ("hold still", {"movement": "static"}),
        ("no movement", {"movement": "static"}),
        ("on Rick", {"focus_on_ids": ("rick",)}),
        ("show Rick and Ilsa", {"focus_on_ids": ("rick", "ilsa")}),
        ("two-shot of Rick and Ilsa", {"kind": "two_shot", "focus_on_ids": ("rick", "ilsa")}),
        ("insert of the piano", {"kind": "insert", "focus_on_ids": ("piano",)}),
        ("over Rick's shoulder on Ilsa", {"kind": "ots", "over_id": "rick", "focus_on_ids": ("ilsa",)}),
        ("Ilsa's point of view", {"kind": "pov", "pov_id": "ilsa"}),
        ("closer, shallow focus", {"size": "MCU", "f_number": 1.4}),
        ("closer and lower", {"size": "MCU", "angle": "low angle"}),
        ("low angle; 35 mm; on Rick", {"angle": "low angle", "lens": 35.0, "focus_on_ids": ("rick",)}),
    ],
)
def test_words_of_film_people_are_understood(words: str, decision: dict[str, object]) -> None:
    assert meant(words) == decision


@pytest.mark.parametrize(
    ("words", "seconds"),
    [
        ("4 seconds", 4), ("hold for 2.5 s", 2.5), ("longer", 3), ("twice as long", 4), ("half as long", 1),
        ("1 second longer", 3),
    ],
)  # fmt: skip
def test_lengths_are_edits_of_the_length(words: str, seconds: float) -> None:
    [edit] = RulesInstructor().propose(view(words)).edits
    assert isinstance(edit, DurationEdit) and edit.seconds == pytest.approx(seconds, abs=0.01)


def test_a_shot_is_locked_and_a_camera_changed_in_one_breath() -> None:
    edits = RulesInstructor().propose(view("closer, lock it")).edits
    assert [type(edit) for edit in edits] == [CameraEdit, LockEdit]


@pytest.mark.parametrize("words", ["make it sing", "brick walls", "on Sam", "closer, and warmer", "a sadder coat"])
def test_what_is_not_understood_is_said(words: str) -> None:
    assert RulesInstructor().propose(view(words)).unclear


def test_names_are_found_by_any_of_their_words_but_not_inside_others() -> None:
    assert Mentions(NAMES).named("Lund and the piano, not Patrick") == ["ilsa", "piano"]


def test_an_edit_of_another_shot_or_of_nobody_is_never_accepted() -> None:
    for decision, shot in (({"size": "CU"}, "SC990_SH010"), ({"focus_on_ids": ["sam"]}, SHOT)):
        edit = {"kind": "camera", "shot": shot, "decision": decision}
        draft = Instruction.model_validate({"edits": [edit]})
        assert InstructorCritic().judge(draft, view("closer")).score < 8


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    return Stage(tmp_path / "p", monkeypatch)


@pytest.mark.parametrize("words", ["closer", "SC010_SH010:", ": closer", "../x: closer"])
def test_words_without_a_shot_or_a_wish_are_refused(stage: Stage, words: str) -> None:
    with Studio(Settings()).open(stage.folder) as session, pytest.raises(InputError, match="names no shot"):
        instructor_view(session.graph, words)


def test_an_instruction_is_one_undo_and_draws_only_its_shot(stage: Stage) -> None:
    stage.render()
    settings = Settings(width=160, look="fast", animatic=False)
    with Studio(settings).open(stage.folder) as session:
        before = session.graph
        applied = session.instruct("SC010_SH010: extreme close-up, low angle")
        assert applied.stale == ("SC010_SH010",)
        assert session.graph.shots[0].camera_instruction.size == "ECU"
        session.undo()
        assert session.graph == before
        with pytest.raises(InputError, match="not understood: sadder"):
            session.instruct("SC010_SH010: closer, sadder")
        assert session.graph == before, "half an instruction is none"


def test_a_model_understands_what_the_rules_do_not() -> None:
    edit = {"kind": "camera", "shot": SHOT, "decision": {"size": "EWS", "angle": "high angle"}}
    model = Scripted([json.dumps({"edits": [edit | {"shot": "SC990_SH010"}]}), json.dumps({"edits": [edit]})])
    role = crew_of(Settings()).instructor
    policy = language_instructor(model, cache(lambda: None))  # pyright: ignore[reportArgumentType]
    outcome = reflect(replace(role, policies=(policy, *role.policies)), SHOT, view("lonelier"))
    [done] = outcome.draft.edits
    assert isinstance(done, CameraEdit) and done.decision.size == "EWS"
    assert "not among the shots" in model.asked[1].feedback[0]
    shown = json.loads(model.asked[0].view)
    assert shown["words"] == "lonelier" and shown["shots"][0]["size"] == "MS"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("Note: too slow, cut on the look. Really.", {"kind": "note", "text": "too slow, cut on the look. Really."}),
        ("note from Ilsa: closer", {"kind": "note", "text": "closer", "author": "Ilsa"}),
        ("resolve note 2", {"kind": "note", "action": "resolve", "number": 2}),
        ("note 2 is done", {"kind": "note", "action": "resolve", "number": 2}),
        ("approve it", {"kind": "approve", "approved": True}),
        ("withdraw the approval", {"kind": "approve", "approved": False}),
    ],
)
def test_notes_and_approval_in_words(words: str, said: dict[str, object]) -> None:
    draft = RulesInstructor().propose(view(words))
    assert not draft.unclear, draft.unclear
    assert InstructorCritic().judge(draft, view(words)).score == 10
    [edit] = draft.edits
    assert edit == type(edit).model_validate({"shot": SHOT, **said})


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("omit it", {"kind": "omit"}),
        ("leave this shot out", {"kind": "omit"}),
        ("bring it back", {"kind": "restore"}),
        ("before SC010_SH010", {"kind": "reorder", "before": "SC010_SH010"}),
        ("move it after SC010_SH030", {"kind": "reorder", "after": "SC010_SH030"}),
    ],
)
def test_the_cut_in_words(words: str, said: dict[str, object]) -> None:
    draft = RulesInstructor().propose(view(words))
    [edit] = draft.edits
    assert edit == type(edit).model_validate({"target": SHOT, **said})
    scene = replace(view(words), named=("SC010",))
    [edit] = RulesInstructor().propose(scene).edits
    assert edit == type(edit).model_validate({"target": "SC010", **said})
    assert InstructorCritic().judge(Instruction(edits=(edit,)), view(words)).score < 8, "another one than was named"
