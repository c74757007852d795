"""Undo and redo as a person means them: one change, with all that the crew did in consequence."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from storyblender.edits.undo import next_steps, redo_edit, undo_edit
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.history import TRIAL, replace
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


def test_redo_is_there_after_the_crew_has_worked_on_what_was_undone(project: Project) -> None:
    """A shot edited twice in a second: undone to the first edit, whose camera the crew never set, it sets it."""
    for author, name in [("user", "lens"), ("user", "size"), ("camera_operator", "camera")]:
        add(project, author, name)
    end = project.graph, project.version
    undo_edit(project)
    add(project, "camera_operator", "other_camera")
    assert names(project) == ["plan", "motion", "lens", "other_camera"]
    assert next_steps(project) == ("adds lens", "adds size")
    assert [commit.reason for commit in redo_edit(project)] == ["adds size", "adds camera"]
    assert (project.graph, project.version) == end
    assert next_steps(project) == ("adds size", "")


@given(st.lists(st.sampled_from(["user", "crew", "undo", "undo", "redo", "reopen", "trial"]), max_size=40))
@settings(max_examples=60, deadline=None)
def test_undo_and_redo_are_each_others_opposite(deeds: list[str]) -> None:
    """Whatever the crew does between: redo leads to the state that a person was at, until they change something."""
    with TemporaryDirectory() as folder:
        project = Project(Path(folder) / "p")
        add(project, "director", "plan")
        done, undone = list[str](), list[tuple[str, list[str]]]()
        for number, deed in enumerate(deeds):
            if deed == "user":
                add(project, "user", f"edit{number}")
                done, undone = [*done, f"edit{number}"], []
            elif deed == "crew":
                add(project, "animator", f"work{number}")
            elif deed == "undo" and done:
                undone.append((done.pop(), names(project)))
                undo_edit(project)
            elif deed == "redo" and undone:
                name, after = undone.pop()
                assert next_steps(project)[1] == f"adds {name}"
                redo_edit(project)
                assert names(project) == after
                done.append(name)
            elif deed == "reopen":
                project.__exit__(None, None, None)
                project = Project(Path(folder) / "p")
            elif deed == "trial":
                before, former = project.revision, project.graph
                add(project, TRIAL, f"trial{number}")
                add(project, "animator", f"tried{number}")
                project.drop(before)
                assert project.graph == former
            assert bool(next_steps(project)[1]) == bool(undone)
        project.__exit__(None, None, None)
