"""A finished project of each released schema opens for ever, with its undo and redo."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from storyblender.edits import redo_edit, undo_edit
from storyblender.history_files import UPGRADES, load
from storyblender.memory.graph import SCHEMA_VERSION
from storyblender.project import Project, read_project_graph
from storyblender.settings import Settings

RELEASED = sorted((Path(__file__).parents[1] / "data" / "projects").glob("schema-*"))


def test_every_older_schema_has_its_project() -> None:
    assert {folder.name for folder in RELEASED} >= {f"schema-{version}" for version in range(1, SCHEMA_VERSION)}
    assert set(UPGRADES) == set(range(1, SCHEMA_VERSION))


@pytest.mark.parametrize("released", RELEASED, ids=lambda folder: folder.name)
def test_a_released_project_opens_with_its_history(released: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(released, tmp_path / "p")
    assert Settings.load(project=folder).look == "fast"
    graph = read_project_graph(folder)
    assert graph.schema_version == SCHEMA_VERSION and len(graph.shots) == 7
    assert all(shot.camera is not None and shot.lights for shot in graph.shots)
    with Project(folder) as project:
        assert project.graph == graph
        assert redo_edit(project)[0].reason == "SC020_SH010: angle low angle"
        angled = project.graph
        assert angled.shot(2, 1).camera_instruction.angle == "low angle"
        for reason in ("SC020_SH010: angle", "SC010_SH020: lens 50", "SC010_SH020: size CU"):
            assert undo_edit(project)[0].reason.startswith(reason)
        assert project.graph.shot(1, 2).camera_instruction.size != "CU"
        for _ in range(3):
            redo_edit(project)
        assert project.graph == angled
    (folder / "graph.json").unlink()
    assert load(folder).graph == angled, "the commits alone make the same graph"


def test_a_project_that_is_not_at_its_last_change_says_so(tmp_path: Path) -> None:
    """Schema 1 has no digest in ``history/HEAD``: another number there may be an undo that was killed, or damage."""
    folder = shutil.copytree(RELEASED[0], tmp_path / "p")
    (folder / "history" / "HEAD").write_text("2")
    with Project(folder) as project:
        assert project.notices == ("the project is at change 2 of 25; `storyblender redo` makes the later ones again",)
        project.go_to(25)
    with Project(folder) as project:
        assert not project.notices and len(project.graph.shots) == 7
