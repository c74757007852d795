"""Stories whose roles a strong model played once, replayed from its answers, mistakes included, to storyboards."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from storyblender.language.answer_folder import asked
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import TRACE, read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from tests.stand_in_engine import StandInEngine

RECORDINGS = sorted((Path(__file__).parent.parent / "data/recordings").iterdir())


def roles_of(recording: Path) -> set[str]:
    return {name.partition("-")[0] for name, _ in asked(recording / "answers")}


def crew_of(recording: Path) -> str:
    answers = recording / "answers"
    return ",".join(["rules", *(f"{role}=replay:{answers}" for role in sorted(roles_of(recording)))])


def script_of(recording: Path) -> Path:
    return next(path for path in sorted(recording.iterdir()) if path.is_file())


def events_of(project: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (project / TRACE).read_text().splitlines()]


@pytest.mark.parametrize("recording", RECORDINGS, ids=lambda path: path.name)
def test_a_recorded_story_is_read_and_cut_as_the_model_said(recording: Path, tmp_path: Path) -> None:
    Studio(Settings(crew=crew_of(recording))).plan(script_of(recording), tmp_path)
    graph = read_project_graph(tmp_path)
    events = events_of(tmp_path)
    assert {event["role"] for event in events if event["kind"] == "accept"} == {"director", "shot_director"}
    assert not [event for event in events if event["kind"] == "handover"], "the rules take nothing over"
    answers = asked(recording / "answers")
    noted = [json.loads(answer) for name, answer in answers if answer is not None and name.startswith("director-")]
    people = {person["id"] for notes in noted for person in notes["people"]}
    groups = {person["id"] for notes in noted for person in notes["people"] if person.get("kind") == "group"}
    cast = {asset.asset_id for asset in graph.assets if asset.asset_type == "character"}
    assert {name for name in cast if name.rpartition("_")[0] not in groups} <= people
    begun = {unit["number"] for notes in noted for unit in notes["units"] if "new_scene" in unit}
    assert len(graph.scenes) >= len(begun) + 1


@pytest.mark.slow
@pytest.mark.parametrize("recording", RECORDINGS, ids=lambda path: path.name)
def test_a_recorded_story_becomes_the_same_storyboard_every_time(
    recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    first, second = (replayed(recording, tmp_path / name) for name in ("first", "second"))
    accepted = {event["role"] for event in events_of(tmp_path / "first") if event["kind"] == "accept"}
    assert {role for role in roles_of(recording) if not role.endswith("_critic")} <= accepted, "critics judge drafts"
    assert all(shot.camera is not None and shot.frame is not None for shot in first.shots)
    assert first == second


def replayed(recording: Path, project: Path) -> ContinuityMemoryGraph:
    models = tuple(recording.glob("models"))
    settings = Settings(width=320, look="fast", animatic=False, crew=crew_of(recording), models=models, jobs=1)
    Studio(settings).make(script_of(recording), project)
    return read_project_graph(project)
