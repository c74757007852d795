"""A session: one call after the other on an open project, cancelled and gone on with, heard from inside its jobs."""

from __future__ import annotations

import json
import shutil
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.stage import SETTINGS, Stage, camera_edit
from tests.stand_in_engine import StandInEngine

from storyblender.errors import Cancelled, ProjectLocked, StoryBlenderError
from storyblender.memory.edits import CameraEdit
from storyblender.memory.shot_context import CameraDecision
from storyblender.session import Session
from storyblender.studio import Studio
from storyblender.trace import Event

MOVING, STILL = (SETTINGS.model_copy(update={"animatic": moving}) for moving in (True, False))
EDIT = [CameraEdit(shot="SC010_SH010", decision=CameraDecision(size="ECU", lens=90.0))]


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    return Stage(tmp_path / "p", monkeypatch)


def cancel_at(session: Session, step: int) -> None:
    """Cancel the next call, from another thread, when it causes its n-th event of progress."""
    heard: list[Event] = []

    def hear(event: Event) -> None:
        heard.append(event)
        if len(heard) == step:
            canceller = threading.Thread(target=session.cancel)
            canceller.start()
            canceller.join()

    session.listen(hear)


def graph_of(folder: Path) -> dict[str, Any]:
    body = json.loads((folder / "graph.json").read_text())
    return {name: body[name] for name in body if name not in ("digest", "commit", "revision")}


def frames_of(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in (folder / "frames").iterdir()}


def test_a_session_is_open_for_many_calls_and_takes_no_second_one(stage: Stage) -> None:
    with Studio(STILL).open(stage.folder) as session:
        session.render()
        engine, drawn = stage.engine, stage.engine.calls["render_frame"]
        session.draw(session.apply(EDIT))
        assert stage.engine is engine and engine.calls["render_frame"] == drawn + 1
        with pytest.raises(ProjectLocked, match="another run has it open"):
            Studio(STILL).open(stage.folder)
        assert next(commit.author for commit in session.undo()) == "user"
        session.redo()
    with Studio(STILL).open(stage.folder):
        pass
    with pytest.raises(StoryBlenderError, match="the session is closed"):
        session.render()


def test_a_render_that_was_cancelled_goes_on_to_what_it_would_have_been(stage: Stage, tmp_path: Path) -> None:
    heard: list[Event] = []
    copies = {step: shutil.copytree(stage.folder, tmp_path / str(step)) for step in (1, 4, 9, 13)}
    Studio(STILL, heard.append).edit(stage.folder, [camera_edit("SC010_SH010", {"size": "ECU", "lens": 90.0})])
    whole = graph_of(stage.folder), frames_of(stage.folder)
    assert len(heard) > max(copies), "every cancel comes before the end"
    for step, folder in copies.items():
        told: list[Event] = []
        with Studio(STILL, told.append).open(folder) as session:
            session.apply(EDIT)
            cancel_at(session, step)
            with pytest.raises(Cancelled, match="what is finished is kept"):
                session.render(["SC010_SH010"])
            assert [event.kind for event in told].count("cancel") == 1
            assert not [path for path in folder.rglob("*.part*")], "nothing is half-written"
            session.render(["SC010_SH010"])
        assert (graph_of(folder), frames_of(folder)) == whole, step


def test_a_cancel_between_calls_ends_none(stage: Stage) -> None:
    with Studio(STILL).open(stage.folder) as session:
        session.cancel()
        assert session.render().files
        session.cancel()
        assert session.check().rows


def test_events_come_from_inside_jobs_to_every_listener_until_it_leaves(stage: Stage) -> None:
    first: list[Event] = []
    second: list[Event] = []
    with Studio(MOVING, first.append).open(stage.folder) as session:
        leave: Callable[[], None] = session.listen(second.append)
        session.render()
        inside = [(event.subject, event.step, event.total) for event in first if event.kind == "job"]
        assert ("SC010_SH010", 1, 2) in inside
        assert second == first
        leave()
        session.check()
    assert len(second) < len(first)


def test_the_film_has_every_shot_moving_also_where_one_is_named(stage: Stage) -> None:
    Studio(MOVING).render(stage.folder, ["SC010_SH010"])
    assert stage.engine.calls["render_motion"] == 3, "a shot without moving frames would be a still in the film"


def test_undo_starts_no_blender(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stage = Stage(tmp_path / "p", monkeypatch)
    stage.render("SC010_SH010")

    def none(*_: object, **__: object) -> StandInEngine:
        pytest.fail("Blender was opened")

    monkeypatch.setattr("storyblender.studio.BlenderEngine", none)
    Studio(SETTINGS).undo(stage.folder)


def test_a_session_may_be_closed_on_another_thread(stage: Stage) -> None:
    session = Studio(STILL).open(stage.folder)
    closing = threading.Thread(target=session.close)
    closing.start()
    closing.join()
    with Studio(STILL).open(stage.folder) as again:
        assert again.made
