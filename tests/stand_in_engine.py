"""An engine without Blender: it writes the files that workers write, and people are seen wherever they stand."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar, get_args

import numpy as np
from PIL import Image

from storyblender.errors import EngineError
from storyblender.folder import Folder
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.framing import Figure, Film, project
from storyblender.look.viewfinder_picture import as_png
from storyblender.memory.asset_sheet import ModelSide
from storyblender.memory.base import Vec3, content_hash, shot_name
from storyblender.memory.blend_values import AdoptedObject, BlendReading, BlendValues
from storyblender.memory.jobs import (
    ASSETS,
    AssetJob,
    CutJob,
    FrameJob,
    FrameReport,
    MomentJob,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
    asset_suffixes,
)
from storyblender.memory.measure import AssetMeasure, AssetRecord, CameraView, Collision, SubjectView, ViewRequest
from storyblender.memory.paint import Paint
from storyblender.memory.request import Picture
from storyblender.memory.scene_context import Light
from storyblender.outputs import digest_of
from storyblender.trace import Event, Listener, silent

Result = TypeVar("Result")
STATURE, HEAD = 1.7, 0.23
"""Metres."""
KEY = Light(name="key", kind="AREA", location=(0, -2, 2), power=50.0)


class StandInEngine:
    """As ``BlenderEngine``, in this process: every answer and every file depends only on the request.

    Args:
        root: The project folder.
        build: Where names below ``build/`` lie instead.

        listener: Hears of each moving frame from inside its job.

    Attributes:
        calls: Tool name to the number of its calls.
    """

    processes = 1

    def __init__(self, root: Path, *_: Any, build: Path | None = None, listener: Listener = silent, **__: Any) -> None:
        self.files, self._listener = Folder(root, build), listener
        self.calls: Counter[str] = Counter()
        self._scenes: dict[str, SceneJob] = {}

    def __enter__(self) -> StandInEngine:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        """Nothing runs."""

    @property
    def front(self) -> StandInEngine:
        """It is never busy."""
        return self

    def warm(self) -> None:
        """Nothing to start."""

    def cancel_waiting(self) -> None:
        """Nothing waits."""

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        """An asset measures what the Concept Artist expects of it."""
        canonical = job.asset.canonical
        assert canonical is not None
        digests: dict[str, str] = {}
        for suffix in asset_suffixes(job.asset):
            path = self.files.write(f"{ASSETS}/{job.digest}{suffix}", f"{suffix} of {job.digest}")
            digests[suffix] = digest_of(path)
        measure = AssetMeasure(
            asset_id=job.asset.asset_id,
            digest=job.digest,
            geometry_hash=canonical.geometry_hash or job.digest,
            dimensions=canonical.dimensions,
            anchors=canonical.anchors,
        )
        record = AssetRecord(measure=measure, files=digests)
        self.files.write(f"{ASSETS}/{job.digest}.json", record.model_dump_json())
        return self._answer("build_asset", measure)

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        self.files.write(job.out, f"pack {job.digest}")
        return self._answer("pack_scene", self._packed(job))

    def rehearse(self, job: SceneJob, shot_ids: Sequence[int]) -> Future[PackRef]:
        return self._answer("rehearse", self._packed(job))

    def _packed(self, job: SceneJob) -> PackRef:
        self._scenes[job.out] = job
        starts, start = [], 1
        for shot in job.shots:
            starts.append((shot.shot_id, start))
            start += shot.duration
        return PackRef(scene_id=job.scene.scene_id, path=job.out, starts=tuple(starts))

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        return self._answer("read_figures", [self._figures(pack, frame) for frame in frames])

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[CameraView]]:
        return self._answer("look", [self._view(pack, request, aspect) for request in requests])

    def preview(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[Picture]]:
        """The colour of a picture depends on all that it is drawn from."""
        digests = [content_hash(pack.path, request, aspect) for request in requests]
        pictures = [Picture(name="preview", png=as_png(picture(each)), drawn_from=each) for each in digests]
        return self._answer("preview", pictures)

    def find_collisions(self, pack: PackRef) -> Future[list[Collision]]:
        return self._answer("find_collisions", [])

    def measure_drift(self, pack: PackRef) -> Future[float]:
        return self._answer("measure_drift", 0.0)

    def render_frame(self, job: FrameJob) -> Future[FrameReport]:
        with self.files.writing(job.out) as part:
            picture(job.digest).save(part)
        return self._answer("render_frame", FrameReport(out=job.out, lights=job.shot.lights or (KEY,)))

    def write_moment(self, job: MomentJob) -> Future[str]:
        self.files.write(job.out, f"moment {job.frame}")
        return self._answer("write_moment", job.out)

    def render_motion(self, job: MotionJob) -> Future[int]:
        with self.files.writing_tree(job.folder) as part:
            for number in (1, 2):
                subject = shot_name(job.shot.scene_id, job.shot.shot_id)
                self._listener(Event(kind="job", role="render_motion", subject=subject, step=number - 1, total=2))
                picture(job.digest[number:]).save(part / f"{number:05d}.jpg")
        return self._answer("render_motion", 2)

    def compile_story(self, job: StoryJob) -> Future[str]:
        self.files.write(job.out, json.dumps(job.model_dump(mode="json", exclude={"changed", "former", "version"})))
        return self._answer("compile_story", job.out)

    def compile_cut(self, job: CutJob) -> Future[str]:
        self.files.write(job.out, json.dumps(job.model_dump(mode="json", exclude={"former"})))
        return self._answer("compile_cut", job.out)

    def read_story(self, name: str) -> Future[BlendReading]:
        """A file of the stand-in says nothing of what it was compiled as."""
        return self._answer("read_story", BlendReading(compiled=None, saved=BlendValues(version="", scenes=())))

    def portrait(self, job: AssetJob, out: str, paints: Sequence[Paint] = ()) -> Future[str]:
        with self.files.writing(out) as part:
            picture(job.digest).save(part)
        return self._answer("portrait", out)

    def write_asset(self, job: AssetJob, out: str, paints: Sequence[Paint] = ()) -> Future[str]:
        self.files.write(out, f"model {job.digest}")
        return self._answer("write_asset", out)

    def adopt_object(self, name: str, scene: str, node: str, *, keep: bool) -> Future[AdoptedObject]:
        """A file of the stand-in has no objects."""
        refused: Future[AdoptedObject] = Future()
        refused.set_exception(EngineError(f"{name} has no object {node}"))
        return refused

    def draw_sides(self, job: AssetJob, folder: str) -> Future[Vec3]:
        """Every side of a thing has a colour of its own."""
        canonical = job.asset.canonical
        assert canonical is not None
        with self.files.writing_tree(folder) as part:
            for number, name in enumerate((*get_args(ModelSide), "portrait")):
                picture(f"{job.digest[:4]}{30 * number:02x}").save(part / f"{name}.png")
        return self._answer("draw_sides", canonical.dimensions)

    def _figures(self, pack: PackRef, frame: int) -> list[Figure]:
        """Return the people of a frame on their first marks; none for a pack that an earlier engine made."""
        scene = self._scenes.get(pack.path)
        if scene is None:
            return []
        shot_id = max((shot_id for shot_id, start in pack.starts if start <= frame), default=pack.starts[0][0])
        shot = next(shot for shot in scene.shots if shot.shot_id == shot_id)
        found: list[Figure] = []
        for blocking in shot.blocking:
            if blocking.visible:
                x, y, z = blocking.start.location
                yaw = math.radians(blocking.start.yaw)
                face, forward = (x, y, z + 0.935 * STATURE), (math.sin(yaw), -math.cos(yaw), 0.0)
                found.append(Figure(blocking.start.asset_id, face, forward, HEAD, (x, y, z)))
        return found

    def _view(self, pack: PackRef, request: ViewRequest, aspect: float) -> CameraView:
        """Return what a camera sees if nothing stands before anybody's head."""
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


def picture(digest: str) -> Image.Image:
    """Return a picture whose colour is told by the first six hex digits."""
    return Image.new("RGB", (64, 48), (int(digest[:2], 16), int(digest[2:4], 16), int(digest[4:6], 16)))
