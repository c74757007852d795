"""An engine without Blender that answers every tool at once: whole runs are tested, and profiled, in seconds."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from typing import TypeVar

import numpy as np
from PIL import Image

from storyblender.agents.layout_artist.camera_brief import orbit_of
from storyblender.catalog.props import PROPS
from storyblender.geometry.framing import Figure, Film, project
from storyblender.memory.jobs import (
    ASSETS,
    AssetJob,
    FrameJob,
    FrameReport,
    PackRef,
    SceneJob,
    StoryJob,
    asset_suffixes,
)
from storyblender.memory.measure import AssetMeasure, CameraView, SubjectView, ViewRequest
from storyblender.memory.scene_context import Light

Result = TypeVar("Result")
PERSON = (0.5, 0.4, 1.7)
HEAD = 0.23


class QuickEngine:
    """People stand on their marks and are seen wherever they stand; pictures are grey.

    Args:
        root: The project folder.

    Attributes:
        calls: Tool name to the number of its calls.
    """

    processes = 1

    def __init__(self, root: Path) -> None:
        self._root = root
        self._jobs: dict[str, SceneJob] = {}
        self.calls: Counter[str] = Counter()

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        """Measure a thing as the catalogue says it is."""
        asset = job.asset
        canonical = asset.canonical
        assert canonical is not None
        size = PROPS[canonical.key].size if canonical.key in PROPS else canonical.dimensions
        measure = AssetMeasure(
            asset_id=asset.asset_id,
            digest=job.digest,
            geometry_hash=job.digest,
            dimensions=PERSON if asset.asset_type == "character" else size,
        )
        for suffix in (*asset_suffixes(asset), ".json"):
            self._write(f"{ASSETS}/{job.digest}{suffix}", b"an asset")
        return self._answer("build_asset", measure)

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        """Keep the job: it is the scene."""
        self._jobs[job.out] = job
        starts, start = [], 1
        for shot in job.shots:
            starts.append((shot.shot_id, start))
            start += shot.duration
        self._write(job.out, b"a pack")
        reference = PackRef(scene_id=job.scene.scene_id, path=job.out, starts=tuple(starts))
        self._write(job.record, reference.model_dump_json().encode())
        return self._answer("pack_scene", reference)

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        """Return everybody who is seen in the shot of each frame."""
        return self._answer("read_figures", [self._figures(pack, frame) for frame in frames])

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[CameraView]]:
        """See everybody's head, past everything that may stand before it."""
        return self._answer("look", [self._view(pack, request, aspect) for request in requests])

    def render_frame(self, job: FrameJob) -> Future[FrameReport]:
        """Draw a grey picture; every shot has its own grey."""
        grey = int(job.digest[:2], 16)
        path = self._root / job.out
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.new("RGB", (32, 18), (grey, grey, grey)).save(path)
        key = Light(name="key", kind="AREA", location=(0, -2, 2), power=50.0)
        return self._answer("render_frame", FrameReport(out=job.out, lights=(key,)))

    def compile_story(self, job: StoryJob) -> Future[str]:
        """Write a file that is no story."""
        self._write(job.out, b"a story")
        return self._answer("compile_story", job.out)

    def _figures(self, pack: PackRef, frame: int) -> list[Figure]:
        job = self._jobs[pack.path]
        shot_id = max((shot_id for shot_id, start in pack.starts if start <= frame), default=pack.starts[0][0])
        shot = next(shot for shot in job.shots if shot.shot_id == shot_id)
        found: list[Figure] = []
        for blocking in shot.blocking:
            if blocking.visible:
                x, y, z = blocking.start.location
                yaw = math.radians(blocking.start.yaw)
                face, forward = (x, y, z + 0.935 * PERSON[2]), (math.sin(yaw), -math.cos(yaw), 0.0)
                found.append(Figure(blocking.start.asset_id, face, forward, HEAD, (x, y, z)))
        return found

    def _view(self, pack: PackRef, request: ViewRequest, aspect: float) -> CameraView:
        camera = orbit_of(request.pose, Film(request.sensor_width, aspect))
        figures = self._figures(pack, pack.start_of(request.shot_id) + request.frame)
        seen: list[SubjectView] = []
        for figure in figures:
            centre = np.asarray(figure.face)
            points = [centre + np.array((0, 0, up * figure.head)) for up in (0.0, 0.55, -0.5)]
            screen, depth = project(camera, points)
            way = camera.position - centre
            turned = float(np.dot(figure.forward, way) / np.linalg.norm(way))
            framed = bool(depth[0] > 0 and ((screen[0] > 0) & (screen[0] < 1)).all())
            seen.append(
                SubjectView(
                    node_id=figure.node_id,
                    visible_fraction=float(framed),
                    in_frame_fraction=float(framed),
                    box=(*screen[:2].min(0).clip(0, 1), *screen[:2].max(0).clip(0, 1)) if framed else None,
                    pixels=0.01 * framed,
                    face=(float(screen[0, 0]), float(screen[0, 1])) if depth[0] > 0 else None,
                    face_visible=1.0,
                    head_height=float(screen[2, 1] - screen[1, 1]),
                    head_top=float(screen[1, 1]),
                    face_angle=math.degrees(math.acos(max(-1.0, min(1.0, turned)))),
                )
            )
        return CameraView(subjects=tuple(seen), void=0.0)

    def _answer(self, tool: str, value: Result) -> Future[Result]:
        self.calls[tool] += 1
        future: Future[Result] = Future()
        future.set_result(value)
        return future

    def _write(self, name: str, content: bytes) -> None:
        path = self._root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
