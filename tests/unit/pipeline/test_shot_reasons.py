"""Why a shot is as it is, from the trace and the rules' own ledger."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.stage import Stage

from storyblender.memory.edits import CameraEdit
from storyblender.pipeline.shot_reasons import role_reasons
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event

SHOT = "SC010_SH010"


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    return Stage(tmp_path / "tale.storyboard", monkeypatch)


def event(kind: str, role: str = "camera_operator", **more: object) -> Event:
    return Event.model_validate({"kind": kind, "role": role, "subject": SHOT, **more})


def test_only_the_last_decision_of_a_role_counts_with_all_that_was_mended_on_the_way() -> None:
    events = [
        event("propose", draft="a"), event("score", score=3.0, details=("old",)), event("accept", by="rules"),
        event("propose", draft="b"), event("score", score=5.0, details=("too low",)),
        event("refine", turn=1, details=("headroom: tilt 3",)), event("score", turn=1, score=9.5),
        event("accept", turn=1, by="model"), event("propose", "director", message="a flag, no draft"),
    ]  # fmt: skip
    [found] = role_reasons(events, (SHOT,))
    assert (found.by, found.score, found.turns) == ("model", 9.5, 1)
    assert found.fixes == ("headroom: tilt 3",) and not found.remarks


def test_roles_of_the_scene_come_before_those_of_the_shot() -> None:
    events = [event("propose", draft="a"), event("propose", "animator", draft="b", subject="SC010")]
    events.append(event("propose", draft="c", subject="SC020_SH010"))
    assert [each.role for each in role_reasons(events, ("SC010", SHOT))] == ["animator", "camera_operator"]


def test_a_shot_tells_who_decided_and_on_which_words(stage: Stage) -> None:
    with Studio(Settings.load(project=stage.folder)).open(stage.folder) as session:
        assert not session.why(SHOT).decided
        session.apply([CameraEdit.model_validate({"kind": "camera", "shot": SHOT, "decision": {"size": "ECU"}})])
        session.render([SHOT])
        found = session.why(SHOT)
        assert any("ECU" in each for each in found.decided)
        assert [(each.role, each.by) for each in found.roles if each.score] == [("camera_operator", "rules")]
        assert found.words, "the rules read something in the first shot"
        for word in found.words:
            assert found.lines[word.line][word.start : word.end].strip()
        before = (session.folder / "trace.jsonl").read_bytes()
        session.why(SHOT)
        assert (session.folder / "trace.jsonl").read_bytes() == before, "asking why leaves no trace"


def test_a_trace_that_was_cut_off_in_the_middle_of_a_line_is_read_up_to_there(stage: Stage) -> None:
    with Studio(Settings.load(project=stage.folder)).open(stage.folder) as session:
        whole = session.why(SHOT)
        with (session.folder / "trace.jsonl").open("a") as trace:
            trace.write('{"kind":"propose","role":"camera_op')
        assert session.why(SHOT) == whole
