"""A small project, planned and set as a crew would, that is drawn without Blender."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from storyblender.folder import Folder
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.base import Frozen
from storyblender.memory.camera_decision import CameraDecision
from storyblender.memory.edits import CameraEdit
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.history import Item, replace
from storyblender.memory.jobs import (
    AssetJob,
)
from storyblender.memory.scene_context import Environment, Layout, Lighting, SceneSize, Sky
from storyblender.memory.shot_context import CameraPose, CameraState
from storyblender.pipeline import retaking
from storyblender.project import Project
from storyblender.settings import REMEMBERED, Settings
from storyblender.studio import Studio
from tests.stand_in_engine import StandInEngine

STEPS = retaking._STEPS
SCRIPT = "INT. ROOM - DAY\n\nANNA sits at the table.\n\nANNA\nWell.\n\nEXT. STREET - NIGHT\n\nANNA runs.\n"
SETTINGS = Settings(width=160, animatic_width=160)
GREY = (0.2, 0.2, 0.2)


def made(item: Frozen) -> Item:
    """Return an item of a plan as a made project has it."""
    pose = CameraPose(pivot=(0, 0, 1), rotation=(1, 0, 0, 0), distance=2, lens=35)
    size = SceneSize(x=4, x_negative=-4, y=4, y_negative=-4)
    match item:
        case Asset():
            source = "person" if item.asset_type == "character" else "catalog"
            canonical = CanonicalAsset(source=source, key="chair", dimensions=(1, 1, 1), digest="", geometry_hash="g")
            digest = AssetJob(asset=item.model_copy(update={"canonical": canonical})).digest
            return item.model_copy(update={"canonical": canonical.model_copy(update={"digest": digest})})
        case _ if hasattr(item, "shot_id"):
            return item.model_copy(update={"camera": CameraState(poses=(pose,))})  # type: ignore[return-value]
        case _:
            light = Lighting(sky=Sky(zenith=GREY, horizon=GREY, ground=GREY))
            room = Environment(kit="room")
            update = {"environment": room, "layout": Layout(scene_size=size), "lighting": light}
            return item.model_copy(update=update)  # type: ignore[return-value]


def plan(folder: Path) -> ContinuityMemoryGraph:
    """Plan the story, and set what the crew would set."""
    script = folder.parent / f"{folder.name}.fountain"
    script.write_text(SCRIPT)
    Studio(SETTINGS).plan(script, folder)
    Folder(folder).write(REMEMBERED, SETTINGS.remembered(Path(folder)))
    with Project(folder) as project:
        graph = replace(project.graph, *map(made, (*project.graph.assets, *project.graph.scenes, *project.graph.shots)))
        project.commit(graph, "user", "made by hand")
        return project.graph


class Stage:
    """A planned project that is drawn without Blender.

    The stand-in sees nothing in its frames, so none of them tells its lines.

    Args:
        folder: The project.
        monkeypatch: Puts the stand-in for Blender in place.
        retakes: Most retakes of a shot.

    Attributes:
        folder: The project.
        engine: Of the last run.
    """

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, retakes: int = 0) -> None:
        self.folder, self.engine = folder, StandInEngine(folder)
        self.told: list[str] = []
        monkeypatch.setattr("storyblender.studio.BlenderEngine", self._engine)
        monkeypatch.setattr(retaking, "_STEPS", STEPS[:retakes])
        plan(folder)

    def render(self, *shots: str, wide: int = 160) -> Counter[str]:
        """Render the project and return which tools were called how often."""
        self.told.clear()
        settings = SETTINGS.model_copy(update={"width": wide})
        with Project(self.folder) as project:
            form = ProjectFormat(fps=settings.fps, width=wide)
            project.commit(project.graph.model_copy(update={"format": form}), "user", "picture size")
        Studio(settings, self._hear).render(self.folder, shots)
        return self.engine.calls

    def content(self) -> dict[str, bytes]:
        """Return every file that is no record of runs, by name."""
        files = (path for path in self.folder.rglob("*") if path.is_file())
        names = {path.relative_to(self.folder).as_posix(): path for path in files}
        passed = (".lock", "outputs.jsonl", "trace.jsonl", "drafts.jsonl", "graph.json")
        return {
            name: path.read_bytes()
            for name, path in sorted(names.items())
            if name not in passed and not name.startswith("history/")
        }

    def _engine(self, root: Path, *_: Any, **named: Any) -> StandInEngine:
        self.engine = StandInEngine(root, **named)
        return self.engine

    def _hear(self, event: Any) -> None:
        if event.kind == "warning":
            self.told.append(f"{event.role} {event.message}")


def camera_edit(shot: str, words: dict[str, Any]) -> CameraEdit:
    """Return what a person decides about the camera of a shot as an edit."""
    return CameraEdit(shot=shot, decision=CameraDecision.model_validate(words))
