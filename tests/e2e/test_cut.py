"""The cut is changed with real frames: none is drawn again, and film, timeline and Blender file follow."""

from __future__ import annotations

import shutil
from pathlib import Path

import av
import opentimelineio as otio
import pytest

from storyblender.project import read_project_graph
from tests.e2e.conftest import storyblender, typed

pytestmark = [pytest.mark.blender, pytest.mark.timeout(900)]


def told(project: Path) -> tuple[list[str], int]:
    """Return the clips of the timeline, and the frames of the film."""
    timeline = otio.adapters.read_from_file(str(project / "timeline.otio"))
    with av.open(str(project / "animatic.mp4")) as film:
        return [clip.name for clip in timeline.tracks[0]], sum(1 for _ in film.decode(video=0))


def frames(project: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in (project / "frames").glob("SC*.png")}


def test_the_film_follows_the_cut_and_no_frame_is_drawn(project: Path, tmp_path: Path) -> None:
    project = shutil.copytree(project, tmp_path / "p")
    drawn, (names, length) = frames(project), told(project)
    first, second = names[:2]
    shots = {
        f"SC{10 * shot.scene_id:03d}_SH{10 * shot.shot_id:03d}": shot for shot in read_project_graph(project).shots
    }
    typed("shot", "omit", project, first, "--no-render")
    typed("shot", "move", project, names[2], "--before", second, "--no-render")
    typed("shot", "note", project, second, "Slower.", "--no-render")
    done = storyblender("shot", "approve", project, second, "--quiet")
    assert done.returncode == 0, done.stderr[-2000:]
    cut = [names[2], second, *names[3:]]
    assert told(project) == (cut, length - shots[first].duration) and frames(project) == drawn
    for _ in range(4):
        typed("undo", project)
    done = storyblender("render", project, "--no-animatic", "--quiet")
    assert done.returncode == 0, done.stderr[-2000:]
    assert told(project) == (names, length) and frames(project) == drawn
