"""A feature and the beginning of one, made by two workers and killed twice on the way: all frames, in bounded memory.

The whole feature takes most of an hour.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.feature_script import PEOPLE, SCENES, feature
from benchmarks.watched_run import watched

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader.reader import read_script
from storyblender.agents.director.settings import DirectorSettings
from storyblender.memory.base import shot_name
from storyblender.project import read_project_graph
from storyblender.screenplay.fountain import parse

SHOTS_PER_SCENE = 6
MOST = 3 * 1024
"""MiB that a process may hold; the .blend of a story is made in it too."""
OPTIONS = [
    "--look",
    "fast",
    "--width",
    "320",
    "--no-animatic",
    "--jobs",
    "2",
    "--shots-per-scene",
    str(SHOTS_PER_SCENE),
]


@pytest.mark.slow
@pytest.mark.blender
@pytest.mark.timeout(9000)
@pytest.mark.parametrize("scenes", [12, SCENES])
def test_a_long_story_gets_through_two_kills(scenes: int, tmp_path: Path) -> None:
    script, project = tmp_path / "feature.fountain", tmp_path / "feature.storyboard"
    script.write_text(feature(scenes), encoding="utf-8")
    arguments = ["make", str(script), "--out", str(project), *OPTIONS]
    runs = [watched(arguments, kill_at) for kill_at in (("camera", 0.4), ("frames", 0.4), None)]
    assert [run.code for run in runs] == [-9, -9, 0]
    assert max(max(run.workers.values()) for run in runs) < MOST
    graph = read_project_graph(project)
    assert len(graph.scenes) == scenes
    frames = {path.stem for path in (project / "frames").glob("SC*.png")}
    assert frames == {shot_name(shot.scene_id, shot.shot_id) for shot in graph.shots}
    for name in ("story.blend", "board.pdf", "shots.csv", "timeline.otio", "index.html"):
        assert (project / name).stat().st_size, name
    assert not list((project / "assets").glob("*part*"))


def test_the_generator_writes_a_feature() -> None:
    """Some 1,200 shots, the whole cast, and the same words each time; a shorter one is the beginning of it."""
    text = feature()
    assert text == feature() and text.startswith(feature(5).rstrip())
    board = storyboard(read_script(parse(text)), DirectorSettings(shots_per_scene=SHOTS_PER_SCENE))
    assert len(board.scene_details) == SCENES == 190
    assert 1100 <= len(board.shot_details) <= 1300
    assert sum(asset.asset_type == "character" for asset in board.asset_sheet) == len(PEOPLE)
