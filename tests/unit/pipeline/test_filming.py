"""Setting cameras: faces are asked for once, and a run that is stopped keeps the scenes that are done."""

from __future__ import annotations

import threading
from concurrent.futures import Future
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from tests.crew import RULES

from storyblender.geometry.framing import Figure
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, ShotContext
from storyblender.pipeline import filming
from storyblender.pipeline.filming import FIGURES, PackViewfinder, film
from storyblender.pipeline.run import Run
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.studio import Studio

SCRIPT = "INT. ROOM - DAY\n\nANNA waits.\n\nEXT. STREET - NIGHT\n\nANNA runs.\n"


class Eyes:
    """Sees one face, wherever the timeline stands, and remembers what it was asked for."""

    def __init__(self) -> None:
        self.asked: list[list[int]] = []

    def read_figures(self, pack: PackRef, frames: list[int]) -> Future[list[list[Figure]]]:
        self.asked.append(list(frames))
        seen: Future[list[list[Figure]]] = Future()
        seen.set_result(
            [[Figure("anna", (frame / 3, 0.1, 1.6), (0.0, -1.0, 0.0), 0.23, (0.0, 0.0, 0.0))] for frame in frames]
        )
        return seen


def test_the_faces_of_a_scene_are_read_once(tmp_path: Path) -> None:
    shots = [
        ShotContext(scene_id=1, shot_id=number, duration=48, camera_instruction=CameraInstruction())
        for number in (1, 2)
    ]
    eyes, folder = Eyes(), tmp_path / FIGURES
    with Project(tmp_path) as project:

        def finder(path: str) -> PackViewfinder:
            run = cast(Run, SimpleNamespace(project=project, outputs=project.outputs, engine=eyes))
            return PackViewfinder(run, PackRef(scene_id=1, path=path, starts=((1, 1), (2, 49))), shots)

        first = finder("build/scenes/SC010-a.blend")
        moments = [first.moments(shot) for shot in shots]
        assert len(eyes.asked) == 1, "a call a scene, not a shot"
        assert [finder("build/scenes/SC010-a.blend").moments(shot) for shot in shots] == moments
        assert len(eyes.asked) == 1, "kept, to the last digit"
        finder("build/scenes/SC010-b.blend").moments(shots[0])
        assert len(eyes.asked) == 2 and [path.name for path in folder.iterdir()] == ["SC010-b.json"]


@pytest.fixture
def graph(tmp_path: Path) -> ContinuityMemoryGraph:
    script = tmp_path / "s.fountain"
    script.write_text(SCRIPT)
    return Studio(Settings()).plan(script, tmp_path / "p").graph


def test_stopped_it_keeps_the_scenes_that_are_done(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done = threading.Event()
    pose = CameraPose(pivot=(0, 0, 1), rotation=(1, 0, 0, 0), distance=2, lens=35)

    def film_scene(run: Run, graph: ContinuityMemoryGraph, scene_id: int) -> Any:
        if scene_id == 1:
            assert done.wait(10)
            raise KeyboardInterrupt
        done.set()
        return {shot.shot_id: CameraState(poses=(pose,)) for shot in graph.shots_of(scene_id)}, []

    monkeypatch.setattr(filming, "film_scene", film_scene)
    with Project(tmp_path / "p") as project:
        run = Run(project, cast(Any, SimpleNamespace(processes=2)), RULES, Settings(), lambda _: None)
        run.packs = {scene.scene_id: PackRef(scene_id=scene.scene_id, path="", starts=()) for scene in graph.scenes}
        with pytest.raises(KeyboardInterrupt):
            film(run)
    with Project(tmp_path / "p") as project:
        cameras = {shot.scene_id: shot.camera for shot in project.graph.shots}
        assert cameras[1] is None and cameras[2] is not None
        assert all((shot.frame is None) == (shot.camera is None) for shot in project.graph.shots)
