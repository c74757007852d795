"""The Camera Operator at work: scenes side by side, the shots of a scene in order, because cuts must match."""

from __future__ import annotations

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

from storyblender.agents.layout_artist.camera_brief import Moment
from storyblender.agents.layout_artist.camera_scene import shoot_scene, telling_frames
from storyblender.agents.layout_artist.layout_brief import measures_of
from storyblender.catalog.sets import plan_of
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef
from storyblender.memory.measure import CameraView, ViewRequest
from storyblender.memory.shot_context import CameraState, ShotContext
from storyblender.memory.vocabulary import LENS_OF_SIZE, ShotSize
from storyblender.pipeline.run import Run
from storyblender.trace import Event


class PackViewfinder:
    """The viewfinder port over one packed scene."""

    def __init__(self, run: Run, pack: PackRef) -> None:
        self._run, self._pack = run, pack

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        """Return one view per request, in order."""
        if not requests:
            return []
        return self._run.engine.look(self._pack, requests, self._run.graph.format.aspect).result()

    def moments(self, shot: ShotContext) -> list[Moment]:
        """Return everybody's faces at the telling frames of a shot."""
        frames, start = telling_frames(shot), self._pack.start_of(shot.shot_id)
        figures = self._run.engine.read_figures(self._pack, [start + frame for frame in frames]).result()
        return [Moment(frame, tuple(faces)) for frame, faces in zip(frames, figures, strict=True)]


def film(run: Run) -> None:
    """Set every camera that is not set yet, and commit scene by scene."""
    graph = run.graph
    scenes = [scene.scene_id for scene in graph.scenes if any(s.camera is None for s in graph.shots_of(scene.scene_id))]
    total = sum(len(graph.shots_of(scene_id)) for scene_id in scenes)
    done = 0
    run.progress("camera", done, total)
    with ThreadPoolExecutor(max_workers=run.engine.processes) as threads:
        operators = {scene_id: threads.submit(film_scene, run, graph, scene_id) for scene_id in scenes}
        for scene_id, operator in operators.items():
            states, events = operator.result()
            for event in events:
                run.tell(event)
            fresh = [shot.model_copy(update={"camera": states[shot.shot_id]}) for shot in graph.shots_of(scene_id)]
            run.commit("camera_operator", f"cameras of scene {scene_id}", *fresh)
            done += len(fresh)
            run.progress("camera", done, total, f"scene {scene_id}")


def film_scene(run: Run, graph: ContinuityMemoryGraph, scene_id: int) -> tuple[dict[int, CameraState], list[Event]]:
    """Return the camera of every shot of a scene, keeping those that are set, and the trace."""
    environment = graph.scene(scene_id).environment
    assert environment is not None, "the set comes before the camera"
    viewfinder = PackViewfinder(run, run.packs[scene_id])
    events: list[Event] = []
    states = shoot_scene(
        graph,
        scene_id,
        plan_of(environment),
        measures_of(graph.assets),
        viewfinder.moments,
        viewfinder,
        lens_kit=lens_kit(run.settings.lens_kit),
        listener=events.append,
    )
    return states, events


def lens_kit(kit: tuple[float, ...]) -> dict[ShotSize, float]:
    """Return a lens for each size from the lenses at hand; any lens where the kit is empty."""
    if not kit:
        return dict(LENS_OF_SIZE)
    return {
        size: min(kit, key=lambda lens, wish=wish: abs(math.log(lens / wish))) for size, wish in LENS_OF_SIZE.items()
    }
