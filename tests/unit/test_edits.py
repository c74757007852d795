"""Undo and redo as a person means them: one change, with all that the crew did in consequence."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

import pytest

from storyblender.edits import camera_decision, decide_cameras, redo_edit, shots_named, undo_edit
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.shot_context import CameraDecision, CameraInstruction, ShotContext
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


@pytest.mark.parametrize("words", [{"lens": 0.0}, {"lens": 9000.0}, {"size": "HUGE"}])
def test_a_camera_that_cannot_be_is_refused_with_what_can(words: dict[str, str | float]) -> None:
    with pytest.raises(InputError, match=r"it is (one of|a number)"):
        camera_decision(words)


def test_a_move_may_say_where_it_goes() -> None:
    assert camera_decision({"movement": "pan left"}) == CameraDecision(movement="pan", direction="left")
    assert camera_decision({"movement": "push in"}) == CameraDecision(movement="push in")
    with pytest.raises(InputError, match="movement cannot be 'spin left'; it is one of: static"):
        camera_decision({"movement": "spin left"})


class Noted:
    """A run that notes what is committed."""

    commits: list[tuple[str, tuple[ShotContext, ...]]]

    def __init__(self) -> None:
        self.commits = []

    def commit(self, _author: str, reason: str, *fresh: ShotContext) -> None:
        self.commits.append((reason, fresh))


def test_another_lens_asks_for_nothing_else_than_the_lens() -> None:
    over = CameraInstruction(kind="ots", focus_on_ids=("anna",), over_id="tom")
    shot = ShotContext(scene_id=1, shot_id=1, camera_instruction=over)
    decide_cameras(cast(Any, run := Noted()), [shot], CameraDecision(lens=50))
    [(reason, [fresh])] = run.commits
    assert fresh.camera_instruction == over.model_copy(update={"lens": 50.0}), "the script asked for no shoulder"
    assert fresh.camera_decision == CameraDecision(lens=50) and reason == "SC010_SH010: lens 50"


def test_one_command_is_one_commit() -> None:
    shots = [ShotContext(scene_id=1, shot_id=n, camera_instruction=CameraInstruction(lens=35)) for n in (1, 2, 3)]
    decide_cameras(cast(Any, run := Noted()), shots, CameraDecision(size="CU"))
    [(reason, fresh)] = run.commits
    assert reason == "SC010_SH010, SC010_SH020, SC010_SH030: size CU"
    assert all(shot.camera_instruction.size == "CU" and shot.camera_instruction.lens is None for shot in fresh)
    locked = shots[2].model_copy(update={"locked": ("camera",)})
    with pytest.raises(InputError, match="camera of SC010_SH030 is locked"):
        decide_cameras(cast(Any, run), [*shots[:2], locked], CameraDecision(size="WS"))
    assert len(run.commits) == 1, "all or none"


def test_a_later_decision_stands_on_an_earlier_one() -> None:
    first = CameraDecision(size="CU", lens=85, movement="pan", direction="left")
    assert first.then(CameraDecision(angle="low angle")) == first.model_copy(update={"angle": "low angle"})
    assert first.then(CameraDecision(size="WS")) == CameraDecision(size="WS", movement="pan", direction="left")
    assert first.then(CameraDecision(movement="push in")) == CameraDecision(size="CU", lens=85, movement="push in")
    racked = CameraDecision(f_number=2, focus="ana", focus_to="ben")
    assert racked.then(CameraDecision(size="WS")) == racked.model_copy(update={"size": "WS"})
    assert racked.then(CameraDecision(focus="ben")) == CameraDecision(f_number=2, focus="ben")
    assert racked.words == "f number 2, focus ana, focus to ben"


def test_shots_are_named_in_any_case_and_a_slip_is_told_apart() -> None:
    shots = tuple(ShotContext(scene_id=1, shot_id=n, camera_instruction=CameraInstruction()) for n in (1, 2, 3))
    graph = ContinuityMemoryGraph(shots=shots)
    assert shots_named(graph, ["sc010_sh020"]) == [shots[1]]
    assert shots_named(graph, []) == list(shots)
    with pytest.raises(InputError, match="'SC010SH030'; did you mean SC010_SH030"):
        shots_named(graph, ["SC010SH030"])
    with pytest.raises(InputError, match="they go from SC010_SH010 to SC010_SH030"):
        shots_named(graph, ["last"])
