"""Any crew runs the same pipeline: here one that knows nothing but the drafts of another."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import pytest
from tests.crew import crew_of
from tests.recorded_crew import recorded_crew
from tests.stand_in_engine import StandInEngine

from storyblender.crew_setting import RoleName
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import DRAFTS, TRACE, read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio

SETTINGS = Settings(width=160, look="fast", animatic=False)
CASABLANCA = Path(__file__).parents[2] / "examples" / "casablanca.fountain"
LAST_SCENES = "INT. RICK'S APARTMENT - NIGHT"
"""Begins the part of Casablanca that is made: two scenes, in which every member of the crew has something to do."""


def made(folder: Path, drafts_of: Path | None = None) -> ContinuityMemoryGraph:
    """Make the end of Casablanca without Blender, by rules or from the drafts of a project."""
    script = folder.with_name("casablanca.fountain")
    script.write_text(LAST_SCENES + CASABLANCA.read_text().partition(LAST_SCENES)[2])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
        if drafts_of is not None:
            crew = recorded_crew(crew_of(SETTINGS), drafts_of)
            patch.setattr("storyblender.studio.rules_crew", lambda *_: crew)
        Studio(SETTINGS).make(script, folder)
    return read_project_graph(folder)


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    folder = tmp_path_factory.mktemp("crew") / "first"
    made(folder)
    yield folder


def test_a_story_is_made_again_from_its_drafts_alone(project: Path, tmp_path: Path) -> None:
    assert made(tmp_path / "second", drafts_of=project) == read_project_graph(project)


def test_a_draft_that_is_missing_stops_the_run(project: Path, tmp_path: Path) -> None:
    (tmp_path / "first").mkdir()
    shutil.copy(project / DRAFTS, tmp_path / "first")
    kept = [line for line in (project / TRACE).read_text().splitlines() if json.loads(line)["role"] != "animator"]
    (tmp_path / "first" / TRACE).write_text("\n".join(kept))
    with pytest.raises(KeyError):
        made(tmp_path / "second", drafts_of=tmp_path / "first")


def test_every_member_of_the_crew_tells_what_it_decided(project: Path) -> None:
    events = [json.loads(line) for line in (project / TRACE).read_text().splitlines()]
    accepted = [event for event in events if event["kind"] == "accept"]
    unasked = {
        "instructor",
        "asset_formatter",
        "asset_generator",
        *(name for name in get_args(RoleName) if name.endswith("_critic")),
    }
    assert {event["role"] for event in accepted} == {*get_args(RoleName)} - unasked, (
        "there is no model file, and the library has everything"
    )
    known = {json.loads(line)["digest"] for line in (project / DRAFTS).read_text().splitlines()}
    assert {event["draft"] for event in accepted} <= known
