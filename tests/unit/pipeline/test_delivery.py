"""Clips for editors only of shots that look as they do in the film; contact sheets written where they are new."""

from __future__ import annotations

import io
from pathlib import Path
from typing import cast

from PIL import Image
from tests.crew import RULES

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline, ShotOutline
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.pipeline.delivery import _contact_sheets, _place_clips, clip_paths
from storyblender.pipeline.run import Run
from storyblender.ports import Engine
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.trace import silent


def story() -> ContinuityMemoryGraph:
    outlines = tuple(ShotOutline(shot_id=number) for number in (1, 2))
    shots = tuple(
        ShotContext(scene_id=1, shot_id=number, camera_instruction=CameraInstruction(), duration=24)
        for number in (1, 2)
    )
    return ContinuityMemoryGraph(
        outline=(SceneOutline(scene_id=1, scene_description="", shots=outlines),),
        scenes=(SceneContext(scene_id=1, setup=SceneSetup()),),
        shots=shots,
    )


def test_only_a_contact_sheet_that_shows_something_new_is_written(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        run = Run(project, cast(Engine, None), RULES, Settings(), silent)
        frames = {f"SC010_SH{number:03d}": project.path(f"thumbnails/{number}.jpg") for number in range(70)}
        for number in range(70):
            project.outputs.write(f"thumbnails/{number}.jpg", jpeg(number))
        names = _contact_sheets(run, frames)
        assert names == ["contact_sheet.jpg", "contact_sheet_2.jpg"], "sixty pictures of this shape a sheet"
        before = [project.path(name).stat().st_ino for name in names]
        project.outputs.write("thumbnails/69.jpg", jpeg(200))
        assert _contact_sheets(run, frames) == names
        after = [project.path(name).stat().st_ino for name in names]
        assert after[0] == before[0] and after[1] != before[1]


def jpeg(grey: int) -> bytes:
    buffer = io.BytesIO()
    Image.new("L", (16, 9), grey).save(buffer, "JPEG")
    return buffer.getvalue()


def test_a_shot_has_its_clip_until_it_looks_otherwise(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        shots = ("SC010_SH010", "SC010_SH020")
        segments = {name: project.outputs.write(f"build/film/{name[-1:-4:-1]}.mp4", name) for name in shots}
        project.commit(story(), "user", "a story")
        run = Run(project, cast(Engine, None), RULES, Settings(), silent)
        assert clip_paths(run) == {}
        _place_clips(run, segments)
        placed = clip_paths(run)
        assert {name: path.read_bytes().decode() for name, path in placed.items()} == {name: name for name in segments}
        before = placed["SC010_SH020"].stat().st_ino
        _place_clips(run, segments)
        assert placed["SC010_SH020"].stat().st_ino == before, "what is the same is not written again"
        (project.folder / "clips" / "my edit.mp4").touch()
        _place_clips(run, {"SC010_SH020": placed["SC010_SH020"]})
        assert list(clip_paths(run)) == ["SC010_SH020"]
        assert (project.folder / "clips" / "my edit.mp4").exists()
