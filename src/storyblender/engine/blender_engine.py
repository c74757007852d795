"""The typed face of the engine: one method per tool, results as models, work spread over the pool."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from contextlib import suppress
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar

from pydantic import TypeAdapter

from storyblender.engine.pool import WorkerPool
from storyblender.engine.worker import LOG, Worker, blender_worker
from storyblender.folder import Folder
from storyblender.geometry.framing import Figure
from storyblender.memory.base import Frozen, Vec3, scene_name, shot_name
from storyblender.memory.blend_values import AdoptedObject, BlendReading
from storyblender.memory.jobs import (
    AssetJob,
    CutJob,
    ExportJob,
    FrameJob,
    FrameReport,
    MomentJob,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
)
from storyblender.memory.measure import AssetMeasure, CameraView, Collision, ViewRequest
from storyblender.memory.paint import Paint
from storyblender.memory.request import Picture
from storyblender.trace import Event, Listener, silent

Result = TypeVar("Result")

_FIGURES = TypeAdapter(list[list[Figure]])
_COLLISIONS = TypeAdapter(list[Collision])
_SIZE = TypeAdapter(Vec3)
_VIEWS = TypeAdapter(list[CameraView])
_PICTURES = TypeAdapter(list[Picture])


class BlenderEngine:
    """Blender, in as many processes as the settings allow. The port ``Engine`` says what the methods take.

    Args:
        root: The project folder; every path in a job is relative to it.
        models: The user's folders of models.
        jobs: Number of processes; 0 decides by the machine.
        build: Where names below ``build/`` lie instead.
        ahead: A worker of the same folders that comes up already.
        listener: Hears, on threads of the engine, how far jobs have come.

    Blender's words of this run, and of no earlier one, are in ``build/engine.log``.
    """

    def __init__(
        self,
        root: Path,
        models: Sequence[Path] = (),
        jobs: int = 0,
        *,
        build: Path | None = None,
        ahead: Worker | None = None,
        listener: Listener = silent,
    ) -> None:
        self._folders, self._listener = (root, models, build), listener
        self._front: BlenderEngine | None = None
        self._pool = WorkerPool(lambda: blender_worker(*self._folders, gives_way=self._front is not None), jobs, ahead)
        self._running: dict[str, Future[Any]] = {}
        """The last job for each output: a second request for the same output waits for it."""
        self._waits: dict[Future[Any], str] = {}
        """What callers wait for, and its output."""
        self._left: set[str] = set()
        """Outputs whose callers were cancelled while the job ran on; who asks next gets them."""
        self._starting = threading.RLock()

    def __enter__(self) -> BlenderEngine:
        root, _, build = self._folders
        Folder(root, build).empty(LOG)  # not deleted: a worker that is ahead has it open
        return self

    @property
    def front(self) -> BlenderEngine:
        """One more process, for what a person waits for; workers that start after it give way to it."""
        with self._starting:
            if self._front is None:
                root, models, build = self._folders
                self._front = BlenderEngine(root, models, 1, build=build, listener=self._listener)
            return self._front

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self._pool.close()
        if self._front is not None:
            self._front._pool.close()

    def warm(self) -> None:
        """Start Blender now, for a call that is sure to come."""
        self._pool.warm()

    def cancel_waiting(self) -> None:
        """Cancel the jobs that no process has begun; nobody waits any longer for pictures and packs under way."""
        self._pool.cancel_waiting()
        with self._starting:
            for wait, output in list(self._waits.items()):
                if wait.cancel() and output:
                    self._left.add(output)
        if self._front is not None:
            self._front.cancel_waiting()

    @property
    def processes(self) -> int:
        """How many Blender processes share the work."""
        return self._pool.size

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        """Build one canonical asset and measure it."""
        return self._once(job.digest, "build_asset", {"job": _plain(job)}, AssetMeasure.model_validate)

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        """Build one scene with the motion of all its shots."""
        scene_id, arguments = job.scene.scene_id, {"job": _plain(job)}
        subject = scene_name(scene_id)
        return self._once(job.out, "pack_scene", arguments, PackRef.model_validate, f"scene{scene_id}", subject)

    def rehearse(self, job: SceneJob, shot_ids: Sequence[int]) -> Future[PackRef]:
        """Have a scene be as its pack will be, in some of its shots, for the next calls on that pack."""
        affinity, arguments = f"scene{job.scene.scene_id}", {"job": _plain(job), "shot_ids": list(shot_ids)}
        # Never an earlier answer: another scene may have been rehearsed since.
        return self._awaited(self._submit("rehearse", arguments, PackRef.model_validate, affinity))

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        """Say where everybody's face is at frames of the scene's timeline."""
        arguments = {"pack": _plain(pack), "frames": list(frames)}
        return self._in_scene(pack.scene_id, "read_figures", arguments, _FIGURES.validate_python)

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[CameraView]]:
        """Look through the viewfinder."""
        return self._in_scene(pack.scene_id, "look", _looks(pack, requests, aspect), _VIEWS.validate_python)

    def preview(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[Picture]]:
        """Draw what the viewfinder shows."""
        return self._in_scene(pack.scene_id, "preview", _looks(pack, requests, aspect), _PICTURES.validate_python)

    def find_collisions(self, pack: PackRef) -> Future[list[Collision]]:
        """Find people inside furniture, in every shot of a pack."""
        return self._in_scene(pack.scene_id, "find_collisions", {"pack": _plain(pack)}, _COLLISIONS.validate_python)

    def measure_drift(self, pack: PackRef) -> Future[float]:
        """Measure the Spatial Drift Error of a scene's static things."""
        return self._in_scene(pack.scene_id, "measure_drift", {"pack": _plain(pack)}, float)

    def render_frame(self, job: FrameJob) -> Future[FrameReport]:
        """Render the board frame of one shot."""
        scene_id, arguments = job.pack.scene_id, {"job": _plain(job)}
        return self._once(job.out, "render_frame", arguments, FrameReport.model_validate, f"scene{scene_id}")

    def write_moment(self, job: MomentJob) -> Future[str]:
        """Write what a scene looks like at one moment as glTF."""
        return self._once(job.out, "write_moment", {"job": _plain(job)}, str, f"scene{job.pack.scene_id}")

    def render_motion(self, job: MotionJob) -> Future[int]:
        """Render the moving frames of one shot."""
        subject = shot_name(job.shot.scene_id, job.shot.shot_id)
        arguments = {"job": _plain(job)}
        return self._once(job.folder, "render_motion", arguments, int, f"scene{job.pack.scene_id}", subject)

    def compile_story(self, job: StoryJob) -> Future[str]:
        """Compile the .blend of a story or of one sequence."""
        return self._submit("compile_story", {"job": _plain(job)}, str, subject=job.out)

    def compile_cut(self, job: CutJob) -> Future[str]:
        """Compile the .blend of a long story, which links those of its sequences."""
        return self._submit("compile_cut", {"job": _plain(job)}, str, subject=job.out)

    def read_story(self, name: str) -> Future[BlendReading]:
        """Read back a .blend of the story, which a person may have changed."""
        return self._submit("read_story", {"name": name}, BlendReading.model_validate, subject=name)

    def adopt_object(self, name: str, scene: str, node: str, *, keep: bool) -> Future[AdoptedObject]:
        """Write an object of a .blend of the story as a model of its own."""
        arguments = {"name": name, "scene": scene, "node": node, "keep": keep}
        return self._submit("adopt_object", arguments, AdoptedObject.model_validate, subject=node)

    def export_scene(self, job: ExportJob) -> Future[str]:
        """Write one scene as glTF or USD."""
        return self._pool.submit("export_scene", {"job": _plain(job)}, str)

    def portrait(self, job: AssetJob, out: str, paints: Sequence[Paint] = ()) -> Future[str]:
        """Render a small picture of one asset."""
        arguments = {"job": _plain(job), "out": out, "paints": [_plain(each) for each in paints]}
        return self._once(out, "portrait", arguments, str)

    def write_asset(self, job: AssetJob, out: str, paints: Sequence[Paint] = ()) -> Future[str]:
        """Write one asset as glTF."""
        arguments = {"job": _plain(job), "out": out, "paints": [_plain(each) for each in paints]}
        return self._once(out, "write_asset", arguments, str)

    def draw_sides(self, job: AssetJob, folder: str) -> Future[Vec3]:
        """Render an object from its six sides and as a portrait."""
        return self._once(folder, "draw_sides", {"job": _plain(job), "folder": folder}, _SIZE.validate_python)

    def _once(
        self,
        output: str,
        tool: str,
        arguments: dict[str, Any],
        read: Callable[[Any], Result],
        affinity: str = "",
        subject: str = "",
    ) -> Future[Result]:
        """Call a tool, or wait for the call that makes the same output already: two would write one file at once.

        What is returned can be cancelled while the call runs on; outputs are named by what they show, so that who asks
        for the same one later gets it.
        """
        with self._starting:
            running = self._running.get(output)
            if running is None or (running.done() and not self._is_left(output, running)):
                running = self._running[output] = self._submit(tool, arguments, read, affinity, subject)
            self._left.discard(output)
            return self._awaited(running, output)

    def _awaited(self, running: Future[Result], output: str = "") -> Future[Result]:
        """Return a future of what comes of a call, which can be cancelled while the call runs on.

        Args:
            running: The call.
            output: Name of what it makes; who asks for it after a cancel gets it. Empty if it is for nobody else.
        """
        wait: Future[Result] = Future()
        with self._starting:
            self._waits[wait] = output
        wait.add_done_callback(self._forget)
        running.add_done_callback(partial(_hand_over, wait))
        return wait

    def _is_left(self, output: str, done: Future[Any]) -> bool:
        """Return whether a call was done, and its caller did not wait for it."""
        return output in self._left and not done.cancelled() and done.exception() is None

    def _forget(self, wait: Future[Any]) -> None:
        with self._starting:
            self._waits.pop(wait, None)

    def _submit(
        self,
        tool: str,
        arguments: dict[str, Any],
        read: Callable[[Any], Result],
        affinity: str = "",
        subject: str = "",
    ) -> Future[Result]:
        """Call a tool; each step that it reports is an event about the subject."""

        def report(step: int, total: int) -> None:
            with suppress(OSError):  # a listener whose pipe was closed must not look like a broken worker
                self._listener(Event(kind="job", role=tool, subject=subject, step=step, total=total))

        return self._pool.submit(tool, arguments, read, affinity=affinity, progress=report)

    def _in_scene(
        self, scene_id: int, tool: str, arguments: dict[str, Any], read: Callable[[Any], Result]
    ) -> Future[Result]:
        """Call a tool where the scene is open already, if that worker is free."""
        return self._pool.submit(tool, arguments, read, affinity=f"scene{scene_id}")


def _hand_over(wait: Future[Any], done: Future[Any]) -> None:
    """Give what came of a call to who waits for it, if they still do."""
    if done.cancelled():
        wait.cancel()
    elif wait.set_running_or_notify_cancel():
        if (error := done.exception()) is not None:
            wait.set_exception(error)
        else:
            wait.set_result(done.result())


def _looks(pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> dict[str, object]:
    """Return the arguments of looks through the viewfinder."""
    return {"pack": _plain(pack), "requests": [_plain(request) for request in requests], "aspect": aspect}


def _plain(model: Frozen) -> object:
    return model.model_dump(mode="json")
