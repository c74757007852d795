"""Undo and redo as a person means them: one change, with all that the crew did in consequence."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.edits.undo import redo_edit, undo_edit
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.history import replace
from storyblender.project import Project


def add(project: Project, author: str, name: str) -> None:
    asset = Asset(asset_id=name, asset_type="object", description="")
    project.commit(replace(project.graph, asset), author, f"adds {name}")


def names(project: Project) -> list[str]:
    return [item.asset_id for item in project.graph.assets]


@pytest.fixture
def project(tmp_path: Path) -> Project:
    project = Project(tmp_path / "p")
    add(project, "director", "plan")
    add(project, "animator", "motion")
    return project


def test_an_edit_goes_and_comes_with_what_followed_from_it(project: Project) -> None:
    for author, name in [("user", "lens"), ("camera_operator", "camera"), ("user", "size"), ("animator", "walk")]:
        add(project, author, name)
    assert [commit.reason for commit in undo_edit(project)] == ["adds size", "adds walk"]
    assert [commit.reason for commit in undo_edit(project)] == ["adds lens", "adds camera"]
    assert names(project) == ["plan", "motion"]
    assert [commit.reason for commit in redo_edit(project)] == ["adds lens", "adds camera"]
    assert names(project) == ["plan", "motion", "lens", "camera"]


def test_the_first_reading_is_never_undone(project: Project) -> None:
    with pytest.raises(InputError, match="nothing to undo"):
        undo_edit(project)
    assert names(project) == ["plan", "motion"]


def test_a_second_reading_can_be(project: Project) -> None:
    add(project, "director", "second")
    undo_edit(project)
    assert names(project) == ["plan", "motion"]


def test_nothing_to_redo_after_another_change(project: Project) -> None:
    with pytest.raises(InputError, match="nothing to redo"):
        redo_edit(project)
    add(project, "user", "lens")
    undo_edit(project)
    add(project, "user", "size")
    with pytest.raises(InputError, match="nothing to redo"):
        redo_edit(project)
