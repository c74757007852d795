"""The project folder: atomic, locked, resumable, undoable."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from storyblender.errors import InputError, ProjectLocked, Rejected
from storyblender.folder import Folder
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.history import replace
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.project import Project, read_project_graph
from storyblender.trace import Event


def asset(name: str) -> Asset:
    return Asset(asset_id=name, asset_type="object", description="")


def add(project: Project, name: str) -> None:
    project.commit(replace(project.graph, asset(name)), "director", f"adds {name}")


def names(project: Project) -> list[str]:
    return [item.asset_id for item in project.graph.assets]


def test_commits_survive_a_kill_before_the_checkpoint(tmp_path: Path) -> None:
    project = Project(tmp_path / "p")
    add(project, "cup")
    add(project, "key")
    project._lock.release()  # killed: nothing else ran
    assert not (tmp_path / "p" / "graph.json").exists()
    assert [item.asset_id for item in read_project_graph(tmp_path / "p").assets] == ["cup", "key"]
    with Project(tmp_path / "p") as again:
        assert names(again) == ["cup", "key"] and again.revision == 2


def test_undo_redo_survive_reopening(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        add(project, "cup")
        add(project, "key")
        assert next(project.backwards()).reason == "adds key"
        project.go_to(1)
        assert names(project) == ["cup"]
    with Project(tmp_path / "p") as project:
        assert names(project) == ["cup"] and [commit.reason for commit in project.forwards()] == ["adds key"]
        project.go_to(2)
        assert names(project) == ["cup", "key"] and not project.has_undone
        project.go_to(1)
        add(project, "box")
        assert not project.has_undone and names(project) == ["cup", "box"]
        assert [commit.author for commit in project.log()] == ["director", "director"]


def test_a_new_commit_ends_what_could_be_redone(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        for name in ("cup", "key", "hat"):
            add(project, name)
    project = Project(tmp_path / "p")
    project.go_to(0)
    add(project, "box")
    assert not project.has_undone and names(project) == ["box"]
    project._lock.release()  # killed: the checkpoint of three commits ago must not need what was forgotten
    with Project(tmp_path / "p") as again:
        assert names(again) == ["box"] and not again.has_undone


def test_killed_before_the_first_commit_it_is_a_project_all_the_same(tmp_path: Path) -> None:
    project = Project(tmp_path / "p")
    project.files.write("script.fountain", "INT. ROOM - DAY")
    project._lock.release()
    with pytest.raises(InputError, match=r"stopped before it was made.*make"):
        read_project_graph(tmp_path / "p")
    with Project(tmp_path / "p") as again:
        assert again.revision == 0


def test_a_half_written_commit_is_not_the_head(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        add(project, "cup")
    (tmp_path / "p" / "history" / "000002.json").write_text('{"revision": 2, "auth')
    with Project(tmp_path / "p") as project:
        assert names(project) == ["cup"]
        add(project, "key")
        assert names(project) == ["cup", "key"]


def test_a_rejected_commit_leaves_no_trace(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        add(project, "cup")
        bad = ShotContext(scene_id=7, shot_id=1, camera_instruction=CameraInstruction())
        with pytest.raises(Rejected):
            project.commit(replace(project.graph, bad), "director", "bad")
        assert project.revision == 1 and not project.graph.shots


def test_one_writer_at_a_time(tmp_path: Path) -> None:
    with Project(tmp_path / "p"), pytest.raises(ProjectLocked, match="another run"):
        Project(tmp_path / "p")
    Project(tmp_path / "p")._lock.release()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("{", "cannot be read"),
        ("[]", "cannot be read"),
        ('{"schema_version": 99}', "newer StoryBlender"),
        ('{"schema_version": 1, "shots": 3}', "cannot be read"),
    ],
)
def test_a_damaged_graph_is_one_clear_error(tmp_path: Path, content: str, words: str) -> None:
    (tmp_path / "graph.json").write_text(content)
    with pytest.raises(InputError, match=words):
        Project(tmp_path)


def test_a_foreign_folder_is_refused_and_left_alone(tmp_path: Path) -> None:
    (tmp_path / "holiday.jpg").write_text("x")
    with pytest.raises(InputError, match="not a project"):
        Project(tmp_path)
    assert not (tmp_path / "history").exists()


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    (tmp_path / "f").write_text("x")
    with pytest.raises(InputError, match="is a file"):
        Project(tmp_path / "f")


def test_paths_cannot_leave_the_folder(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project, pytest.raises(InputError, match="leaves the project"):
        project.path("..", "evil.txt")


def test_the_graph_reads_without_a_lock(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        add(project, "cup")
        project.checkpoint()
        assert [item.asset_id for item in read_project_graph(tmp_path / "p").assets] == ["cup"]
    with pytest.raises(InputError, match="not a StoryBlender project"):
        read_project_graph(tmp_path)


def test_events_are_appended_as_lines(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        project.record(Event(kind="score", role="camera_operator", score=7.5))
        project.record(Event(kind="refine", role="camera_operator"))
    lines = (tmp_path / "p" / "trace.jsonl").read_text().splitlines()
    assert [json.loads(line)["kind"] for line in lines] == ["score", "refine"]


def test_stopped_between_the_head_and_its_graph_the_checkpoint_is_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(folder: Folder, name: str, content: str | bytes) -> None:
        write(folder, name, content)
        if name == "history/HEAD":
            raise KeyboardInterrupt

    write = Folder.write

    with Project(tmp_path / "p") as project:
        add(project, "cup")
        monkeypatch.setattr(Folder, "write", stopped)
        with pytest.raises(KeyboardInterrupt):
            add(project, "key")
        monkeypatch.undo()
    with Project(tmp_path / "p") as again:
        assert names(again) == ["cup", "key"] and again.revision == 2
