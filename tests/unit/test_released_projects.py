"""A finished project of each released schema opens for ever, with its undo and redo."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from storyblender.catalog.props.prop_names import props_of
from storyblender.edits.undo import redo_edit, undo_edit
from storyblender.errors import InputError
from storyblender.history_files import UPGRADES, load
from storyblender.memory.graph import SCHEMA_VERSION
from storyblender.memory.history import Commit
from storyblender.project import Project, read_project_graph
from storyblender.settings import Settings

RELEASED = sorted((Path(__file__).parents[1] / "data" / "projects").glob("schema-*"))


def test_every_schema_has_its_project() -> None:
    assert [folder.name for folder in RELEASED] == [f"schema-{version}" for version in range(1, SCHEMA_VERSION + 1)]
    assert set(UPGRADES) == set(range(1, SCHEMA_VERSION))


def _undone(project: Project) -> Iterator[Commit]:
    """Undo everything that can be undone, last first."""
    with suppress(InputError):
        while True:
            yield from reversed(undo_edit(project))


@pytest.mark.parametrize("released", RELEASED, ids=lambda folder: folder.name)
def test_a_released_project_opens_with_its_history(released: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(released, tmp_path / "p")
    assert Settings.load(project=folder).look == "fast"
    graph = read_project_graph(folder)
    assert graph.schema_version == SCHEMA_VERSION and len(graph.shots) == 7
    assert all(shot.camera is not None and shot.lights for shot in graph.shots)
    assert all(scene.environment and scene.setup.kit == scene.environment.kit for scene in graph.scenes)
    with Project(folder) as project:
        assert project.graph == graph
        close = graph.shot(1, 2)
        assert (close.camera_instruction.size, close.camera_instruction.lens) == ("CU", 50)
        while project.has_undone:
            redo_edit(project)
        last, latest = project.revision, project.graph
        assert latest != graph, "something was undone"
        undone = [commit.reason for commit in _undone(project)]
        assert [reason for reason in undone if reason.startswith("SC010_SH020")][-1].startswith("SC010_SH020: size CU")
        assert project.graph.shot(1, 2).camera_instruction.size != "CU"
        project.go_to(last)
        assert project.graph == latest
    (folder / "graph.json").unlink()
    assert load(folder).graph == latest, "the commits alone make the same graph"


def test_scenes_that_were_not_staged_before_schema_6_have_no_kit(tmp_path: Path) -> None:
    with Project(shutil.copytree(RELEASED[4], tmp_path / "p")) as project:
        kits: dict[int, list[str]] = {}
        for revision in (20, 9, 5):
            project.go_to(revision)
            kits[revision] = [scene.setup.kit for scene in project.graph.scenes]
    assert kits == {20: ["kitchen", "park"], 9: ["kitchen", ""], 5: ["", ""]}


@pytest.mark.parametrize("released", RELEASED, ids=lambda folder: folder.name)
def test_what_the_things_of_a_released_project_are_is_known_whatever_they_are_made_from(released: Path) -> None:
    assets = read_project_graph(released).assets
    props = props_of(assets)
    assert {"table", "cup", "bench", "gate"} <= props.keys() and not {"ada", "tom"} & props.keys()
    bare = [asset.model_copy(update={"canonical": None}) for asset in assets]
    assert props_of(bare) == props


def test_a_project_that_is_not_at_its_last_change_says_so(tmp_path: Path) -> None:
    """Schema 1 has no digest in ``history/HEAD``: another number there may be an undo that was killed, or damage."""
    folder = shutil.copytree(RELEASED[0], tmp_path / "p")
    (folder / "history" / "HEAD").write_text("2")
    with Project(folder) as project:
        assert project.notices == ("the project is at change 2 of 25; `storyblender redo` makes the later ones again",)
        project.go_to(25)
    with Project(folder) as project:
        assert not project.notices and len(project.graph.shots) == 7
