"""Face lights belong to a camera: to look at a project in another look leaves the history as it is."""

from __future__ import annotations

from pathlib import Path
from typing import cast

from tests.crew import RULES

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.jobs import FrameReport, Look
from storyblender.memory.scene_context import Light, SceneContext, SceneSetup
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import _commit_lights, _newly_lit
from storyblender.ports import Engine
from storyblender.project import Project
from storyblender.settings import REMEMBERED, Settings
from storyblender.trace import silent

SHOT = ShotContext(scene_id=1, shot_id=1, camera_instruction=CameraInstruction())


def report(name: str) -> FrameReport:
    return FrameReport(out="", lights=(Light(name=name, kind="AREA", power=10),))


def run_in(project: Project, look: Look) -> Run:
    engine = cast(Engine, None)
    return Run(project, engine, RULES, Settings(look=look), silent)


def keep(run: Run, report: FrameReport) -> None:
    """Keep the lights of the story's only shot as a drawn scene does."""
    _commit_lights(run, _newly_lit(run, run.graph.shots[0], report))


def lights(project: Project) -> list[str]:
    return [light.name for light in project.graph.shots[0].lights]


def test_another_look_changes_nothing_and_can_be_followed_by_redo(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        project.files.write(REMEMBERED, Settings(look="board").remembered(tmp_path))
        story = ContinuityMemoryGraph(scenes=(SceneContext(scene_id=1, setup=SceneSetup()),), shots=(SHOT,))
        project.commit(story, "director", "plans")
        board = run_in(project, "board")
        keep(board, report("key"))
        assert lights(project) == ["key"], "a new camera has none yet"
        keep(run_in(project, "pencil"), report("pencil"))
        assert lights(project) == ["key"]
        keep(board, report("better"))
        assert lights(project) == ["better"], "a newer StoryBlender lights it otherwise"

        cup = Asset(asset_id="cup", asset_type="object", description="")
        project.commit(replace(project.graph, cup), "user", "adds a cup")
        project.go_to(project.revision - 1)
        for look in ("board", "pencil"):
            keep(run_in(project, look), report("other"))
        assert lights(project) == ["better"] and project.has_undone
