"""Shots are split, joined and added with real frames: only those are drawn; film, timeline and Blender file follow."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from storyblender.deliver.panel import panels
from storyblender.memory.coverage import spans_of
from storyblender.project import read_project_graph
from tests.e2e.conftest import storyblender, typed
from tests.e2e.test_cut import frames, told
from tests.e2e.test_story_blend import read

pytestmark = [pytest.mark.blender, pytest.mark.timeout(1800)]


def render(project: Path) -> None:
    done = storyblender("render", project, "--animatic", "--quiet")
    assert done.returncode == 0, done.stderr[-2000:]


def test_only_what_is_split_joined_or_added_is_drawn(project: Path, tmp_path: Path) -> None:
    project = shutil.copytree(project, tmp_path / "p")
    drawn, (names, length) = frames(project), told(project)
    scenes = {path.name: path.stat().st_mtime_ns for path in (project / "build/scenes").iterdir()}
    first, second, third, fourth = names[:4]
    half, insert = (f"{name[:-1]}5" for name in (first, second))
    typed("shot", "split", project, first, "--seconds", "1", "--no-render")
    typed("shot", "add", project, second, "--on", "ada", "--size", "CU", "--seconds", "1", "--no-render")
    typed("shot", "join", project, third, fourth, "--no-render")
    render(project)
    film = {panel.name: panel.shot.duration for panel in panels(read_project_graph(project))}
    assert [*film] == [first, half, second, insert, third, *names[4:]]
    assert told(project) == ([*film], length + film[insert]) and film[first] == film[insert] == 24
    now = frames(project)
    assert {name for name in drawn if now.get(name) != drawn[name]} <= {f"{first}.png", f"{third}.png", f"{fourth}.png"}
    assert {f"{half}.png", f"{insert}.png"} <= {*now}
    packs = {path.name: path.stat().st_mtime_ns for path in (project / "build/scenes").iterdir()}
    assert packs == scenes, "nothing is staged again"
    scene = read(project)["scenes"]
    assert [name for name, *_ in scene["EDIT"]["strips"]] == [*film]
    assert [frames for *_, frames in scene["EDIT"]["strips"]] == [*film.values()]
    shots = read_project_graph(project).shots_of(1)
    starts = {each.shot_id: span[0] + 1 for each in shots if (span := spans_of(shots).get(each.shot_id))}
    markers = {name: frame for name, frame, _ in scene["SC010"]["markers"]}
    assert [*markers] == [name for name in film if name.startswith("SC010") and name != insert]
    assert markers[half] == starts[50_015] == 25
    for _ in range(3):
        typed("undo", project)
    assert [panel.name for panel in panels(read_project_graph(project))] == names
