"""Conflicts with Blender wait in the project; those that are taken together are one undo."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.stage import Stage

from storyblender.edits.pull_conflicts import PullConflict, let_wait
from storyblender.edits.pulling import Choice
from storyblender.edits.words import edits_of
from storyblender.errors import InputError
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.studio import Studio


def lens(shot: str, number: float) -> PullConflict:
    edits = edits_of([{"kind": "camera", "shot": shot, "decision": {"lens": number}}])
    return PullConflict(id=f"{shot}.lens", words=f"{shot} has {number:g} mm", project=("user: lens 24",), edits=edits)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = Stage(tmp_path / "p", monkeypatch).folder
    gone = lens("SC990_SH010", 50)
    with Project(folder) as project:
        let_wait(project, [lens("SC010_SH010", 77), lens("SC010_SH020", 88), gone])
    return folder


def test_conflicts_that_are_taken_together_are_one_undo(folder: Path) -> None:
    with Studio(Settings.load(project=folder)).open(folder) as session:
        before = session.graph
        pulled = session.pull(choice=Choice(take=("SC010_SH010.lens", "SC010_SH020.lens", "SC990_SH010.lens")))
        decided = [shot.camera_decision for shot in session.graph.shots_of(1)[:2]]
        assert [each.lens if each else None for each in decided] == [77, 88]
        assert len(pulled.understood) == 2 and not pulled.conflicts
        assert ["SC990" in sentence for sentence in pulled.kept] == [True], "what cannot be is told"
        session.undo()
        assert session.graph == before


def test_what_nobody_chooses_waits_and_the_project_stands(folder: Path) -> None:
    with Studio(Settings.load(project=folder)).open(folder) as session:
        before = session.graph
        pulled = session.pull(choice=Choice(leave=("SC010_SH010.lens",)))
        assert [each.id for each in pulled.conflicts] == ["SC010_SH020.lens", "SC990_SH010.lens"]
        assert session.graph == before
        with pytest.raises(InputError, match="there is no conflict"):
            session.pull(choice=Choice(take=("SC010_SH010.lens",)))
