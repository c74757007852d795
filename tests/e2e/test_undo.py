"""A changed camera is undone and made again: each time only its picture is drawn, and it is the same to the pixel."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.memory.base import shot_name
from storyblender.project import read_project_graph
from tests.e2e.conftest import storyblender

pytestmark = [pytest.mark.blender, pytest.mark.timeout(900)]


def done(*arguments: str | Path) -> str:
    result = storyblender(*arguments)
    assert result.returncode == 0, result.stderr[-2000:]
    return result.stdout


def stamps(project: Path) -> dict[str, tuple[int, bytes]]:
    return {path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in (project / "frames").glob("SC*.png")}


def pixels(stamped: dict[str, tuple[int, bytes]]) -> dict[str, bytes]:
    return {name: content for name, (_, content) in stamped.items()}


def test_undo_and_redo_draw_one_picture_again(project: Path) -> None:
    shot = read_project_graph(project).shots[-1]
    name = shot_name(shot.scene_id, shot.shot_id)
    before, graph = stamps(project), read_project_graph(project)
    told = done("edit", project, name, "--lens", "90", "--json")
    stale = [line for line in told.splitlines() if "still shows" in line]
    assert stale and name in stale[0], "the film was not shot again"
    edited, changed = stamps(project), read_project_graph(project)
    assert [key for key in before if edited[key] != before[key]] == [f"{name}.png"]

    assert f"{name}: lens 90" in done("undo", project)
    assert read_project_graph(project) == graph
    done("render", project, "--quiet")
    undone = stamps(project)
    assert pixels(undone) == pixels(before)
    assert [key for key in before if undone[key][0] != edited[key][0]] == [f"{name}.png"]
    assert read_project_graph(project) == graph, "a picture that is drawn again changes nothing"

    done("redo", project)
    assert read_project_graph(project) == changed
    done("render", project, "--quiet")
    assert pixels(stamps(project)) == pixels(edited)
