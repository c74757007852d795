"""An engine without Blender that writes the files that workers write, and a small story that it can draw."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar

import pytest
from PIL import Image

from storyblender.folder import Folder
from storyblender.geometry.framing import Figure
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.base import Frozen
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.history import Item, replace
from storyblender.memory.jobs import (
    ASSETS,
    AssetJob,
    FrameJob,
    FrameReport,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
    asset_suffixes,
)
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, Layout, Lighting, SceneSize, Sky
from storyblender.memory.shot_context import CameraPose, CameraState
from storyblender.project import Project
from storyblender.settings import REMEMBERED, Settings
from storyblender.studio import Studio

Result = TypeVar("Result")
SCRIPT = "INT. ROOM - DAY\n\nANNA sits at the table.\n\nANNA\nWell.\n\nEXT. STREET - NIGHT\n\nANNA runs.\n"
SETTINGS = Settings(width=160, animatic_width=160)
GREY = (0.2, 0.2, 0.2)


class FileEngine:
    """Every tool writes files that only depend on what is asked for.

    Attributes:
        calls: Tool name to the number of its calls.
    """

    processes = 1

    def __init__(self, root: Path, *_: Any, build: Path | None = None, **__: Any) -> None:
        self.files = Folder(root, build)
        self.calls: Counter[str] = Counter()

    def __enter__(self) -> FileEngine:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        """Nothing runs."""

    def warm(self) -> None:
        """Nothing to start."""

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        measure = AssetMeasure(asset_id=job.asset.asset_id, digest=job.digest, geometry_hash="g", dimensions=(1, 1, 1))
        for suffix in (*asset_suffixes(job.asset), ".json"):
            self.files.write(f"{ASSETS}/{job.digest}{suffix}", f"{suffix} of {job.digest}")
        return self._answer("build_asset", measure)

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        starts, start = [], 1
        for shot in job.shots:
            starts.append((shot.shot_id, start))
            start += shot.duration
        self.files.write(job.out, f"pack {job.digest}")
        return self._answer("pack_scene", PackRef(scene_id=job.scene.scene_id, path=job.out, starts=tuple(starts)))

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        return self._answer("read_figures", [[] for _ in frames])

    def render_frame(self, job: FrameJob) -> Future[FrameReport]:
        with self.files.writing(job.out) as part:
            picture(job.digest).save(part)
        return self._answer("render_frame", FrameReport(out=job.out))

    def render_motion(self, job: MotionJob) -> Future[int]:
        with self.files.writing_tree(job.folder) as part:
            for number in (1, 2):
                picture(job.digest[number:]).save(part / f"{number:05d}.jpg")
        return self._answer("render_motion", 2)

    def compile_story(self, job: StoryJob) -> Future[str]:
        self.files.write(job.out, json.dumps(job.model_dump(mode="json", exclude={"changed", "former"})))
        return self._answer("compile_story", job.out)

    def _answer(self, tool: str, value: Result) -> Future[Result]:
        self.calls[tool] += 1
        future: Future[Result] = Future()
        future.set_result(value)
        return future


def picture(digest: str) -> Image.Image:
    return Image.new("RGB", (64, 48), (int(digest[:2], 16), int(digest[2:4], 16), int(digest[4:6], 16)))


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

    Attributes:
        folder: The project.
        engine: Of the last run.
    """

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.engine = folder, FileEngine(folder)
        self.told: list[str] = []
        monkeypatch.setattr("storyblender.studio.BlenderEngine", self._engine)
        plan(folder)

    def render(self, *shots: str, wide: int = 160) -> Counter[str]:
        """Render the project and return which tools were called how often."""
        self.told.clear()
        settings = SETTINGS.model_copy(update={"width": wide})
        with Project(self.folder) as project:
            form = ProjectFormat(fps=settings.fps, width=wide)
            project.commit(project.graph.model_copy(update={"format": form}), "user", "picture size")
        Studio(settings, self._hear).render(self.folder, shots, {})
        return self.engine.calls

    def content(self) -> dict[str, bytes]:
        """Return every file that is no record of runs, by name."""
        files = (path for path in self.folder.rglob("*") if path.is_file())
        names = {path.relative_to(self.folder).as_posix(): path for path in files}
        passed = (".lock", "outputs.jsonl", "trace.jsonl", "graph.json")
        return {
            name: path.read_bytes()
            for name, path in sorted(names.items())
            if name not in passed and not name.startswith("history/")
        }

    def _engine(self, root: Path, *_: Any, **__: Any) -> FileEngine:
        self.engine = FileEngine(root)
        return self.engine

    def _hear(self, event: Any) -> None:
        if event.kind == "warning":
            self.told.append(f"{event.role} {event.message}")
