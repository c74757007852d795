"""Stands in for Blender: writes small files and gives plain answers, so that all around it can be tried."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from typing import Any, TypeVar

from storyblender.folder import Folder
from storyblender.geometry.framing import Figure
from storyblender.memory.jobs import (
    AssetJob,
    FrameJob,
    FrameReport,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
    asset_suffixes,
)
from storyblender.memory.measure import AssetMeasure, CameraView, Collision, ViewRequest

Result = TypeVar("Result")


def answered(value: Result) -> Future[Result]:
    future: Future[Result] = Future()
    future.set_result(value)
    return future


class FakeEngine:
    """As ``BlenderEngine``, for projects whose assets and packs are whole."""

    processes = 1

    def __init__(self, root: Path, *_: Any, **__: Any) -> None:
        self._files = Folder(root)

    def __enter__(self) -> FakeEngine:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def warm(self) -> None:
        pass

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        for suffix in (*asset_suffixes(job.asset), ".json"):
            self._write(f"assets/{job.digest}{suffix}")
        canonical = job.asset.canonical
        assert canonical is not None
        measure = AssetMeasure(
            asset_id=job.asset.asset_id,
            digest=job.digest,
            geometry_hash=canonical.geometry_hash or "0",
            dimensions=canonical.dimensions,
            anchors=canonical.anchors,
        )
        return answered(measure)

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        self._write(job.out)
        starts: list[tuple[int, int]] = []
        frame = 1
        for shot in job.shots:
            starts.append((shot.shot_id, frame))
            frame += shot.duration
        return answered(PackRef(scene_id=job.scene.scene_id, path=job.out, starts=tuple(starts)))

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        return answered([[] for _ in frames])

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[CameraView]]:
        return answered([CameraView(subjects=(), void=0) for _ in requests])

    def find_collisions(self, pack: PackRef) -> Future[list[Collision]]:
        return answered([])

    def measure_drift(self, pack: PackRef) -> Future[float]:
        return answered(0.0)

    def render_frame(self, job: FrameJob) -> Future[FrameReport]:
        self._write(job.out)
        return answered(FrameReport(out=job.out, lights=job.shot.lights))

    def render_motion(self, job: MotionJob) -> Future[int]:
        self._write(f"{job.folder}/0001.png")
        return answered(1)

    def compile_story(self, job: StoryJob) -> Future[str]:
        self._write(job.out)
        return answered(job.out)

    def _write(self, name: str) -> None:
        self._files.write(name, b"whatever")
