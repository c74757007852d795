"""A script goes in, everything comes out; a second run draws nothing; a changed camera draws one frame."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import av
import opentimelineio as otio
import pytest
from PIL import Image

from storyblender.project import read_project_graph
from tests.e2e.conftest import SMALL, made, storyblender

pytestmark = [pytest.mark.blender, pytest.mark.timeout(900)]


def shots(project: Path) -> list[str]:
    return [row["shot"] for row in csv.DictReader((project / "shots.csv").open(encoding="utf-8-sig"))]


def stamps(project: Path) -> dict[str, tuple[int, bytes]]:
    return {path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in (project / "frames").glob("SC*.png")}


def test_everything_is_there_and_agrees(project: Path) -> None:
    names = shots(project)
    assert len(names) >= 3
    for name in names:
        with Image.open(project / "frames" / f"{name}.png") as frame:
            assert frame.size == (320, 180)
            low, high = frame.convert("L").getextrema()
            assert high - low > 60, f"{name} shows nothing"
    graph = read_project_graph(project)
    total = sum(shot.duration for shot in graph.shots)
    timeline = otio.adapters.read_from_file(str(project / "timeline.otio"))
    assert timeline.duration().value == total
    with av.open(str(project / "animatic.mp4")) as film:
        assert sum(1 for _ in film.decode(video=0)) == total
    assert (project / "board.pdf").read_bytes().startswith(b"%PDF")
    assert (project / "story.blend").stat().st_size > 100_000
    page = (project / "index.html").read_text("utf-8")
    assert all(f'id="{name}"' in page for name in names) and "You came back." in page


def test_the_graph_knows_who_sits_and_who_walks(project: Path) -> None:
    graph = read_project_graph(project)
    people = {asset.asset_id for asset in graph.assets if asset.asset_type == "character"}
    assert people == {"ada", "tom"}
    first = graph.shots[0]
    ada = next(blocking for blocking in first.blocking if blocking.start.asset_id == "ada")
    assert ada.start.posture == "sit" and ada.start.support_id
    assert any(cue.clip == "walk" and cue.asset_id == "tom" for shot in graph.shots for cue in shot.cues)


def test_the_project_is_clean(project: Path) -> None:
    done = storyblender("check", project, "--json")
    report = json.loads(done.stdout.splitlines()[-1])
    rows = {row["name"]: row["value"] for row in report["rows"]}
    assert rows["layout violations"] == "0" and float(rows["metres that untouched things move (SDE)"]) == 0
    assert rows["cameras inside geometry"] == "0"


def test_a_second_run_draws_nothing(project: Path, script: Path) -> None:
    before = stamps(project)
    made([script, "--out", project, *SMALL])
    assert stamps(project) == before


def test_a_changed_camera_draws_one_frame(project: Path) -> None:
    before = stamps(project)
    name = shots(project)[1]
    done = storyblender("edit", project, name, "--size", "ECU", "--look", "fast", "--quiet")
    assert done.returncode == 0, done.stderr[-2000:]
    after = stamps(project)
    assert [key for key in before if after[key] != before[key]] == [f"{name}.png"]
    assert read_project_graph(project).shots[1].camera_instruction.size == "ECU"


@pytest.mark.slow
@pytest.mark.parametrize("look", ["fast", "board", "pencil"])
def test_twice_the_same_is_the_same(look: str, script: Path, tmp_path: Path) -> None:
    small = ("--look", look, "--width", "320", "--quiet", "--no-animatic")
    made([script, "--out", tmp_path / "a", *small])
    made([script, "--out", tmp_path / "b", *small, "--jobs", "1"])
    first, second = read_project_graph(tmp_path / "a"), read_project_graph(tmp_path / "b")
    assert first == second
    frames = sorted((tmp_path / "a" / "frames").glob("SC*.png"))
    assert frames
    for frame in frames:
        assert frame.read_bytes() == (tmp_path / "b" / "frames" / frame.name).read_bytes(), frame.name
