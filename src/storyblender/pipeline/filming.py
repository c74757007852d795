"""The Camera Operator at work: scenes side by side, the shots of a scene in order, because cuts must match."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from storyblender.agents.layout_artist.camera_continuity import CUT_KINDS, judge_cuts
from storyblender.agents.layout_artist.camera_operator_view import Moment
from storyblender.agents.layout_artist.camera_scene import camera_operator_view, measured_frames, shoot_scene
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.agents.layout_artist.story_moment import story_moment
from storyblender.catalog.sets import plan_of
from storyblender.errors import AnswerAwaited
from storyblender.geometry.framing import Figure
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.coverage import as_filmed
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.jobs import PackRef
from storyblender.memory.measure import CameraView, ViewRequest
from storyblender.memory.request import Picture
from storyblender.memory.shot_context import CameraState, Flaw, ShotContext
from storyblender.pipeline.run import Run
from storyblender.trace import Event

FIGURES = "build/figures"
_RECORD = TypeAdapter(dict[int, list[Figure]])


class PackViewfinder:
    """The viewfinder port over one packed scene.

    Args:
        run: Whose engine looks.
        pack: The scene.
        shots: All of its shots. Their faces are read at once when they are first wanted, and kept beside the packs: a
            changed camera asks for none.
    """

    def __init__(self, run: Run, pack: PackRef, shots: Sequence[ShotContext]) -> None:
        self._run, self._pack, self._shots = run, pack, shots

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        """Return one view per request, in order."""
        if not requests:
            return []
        return self._run.engine.look(self._pack, requests, self._run.graph.format.aspect).result()

    def preview(self, requests: Sequence[ViewRequest]) -> list[Picture]:
        """Return one picture per request, in order."""
        return self._run.engine.preview(self._pack, requests, self._run.graph.format.aspect).result()

    def moments(self, shot: ShotContext) -> list[Moment]:
        """Return everybody's faces at the telling frames of a shot."""
        start = self._pack.start_of(shot.shot_id)
        return [Moment(frame, tuple(self._figures[start + frame])) for frame in self._telling(shot)]

    def _telling(self, shot: ShotContext) -> tuple[int, ...]:
        return measured_frames(shot, self._pack.played(shot.shot_id))

    @cached_property
    def _figures(self) -> dict[int, list[Figure]]:
        """Everybody's faces, by frame of the scene's timeline."""
        outputs, record = self._run.outputs, figures_of(self._pack)
        known = outputs.read(record, _RECORD.validate_json) or {}
        wanted = [self._pack.start_of(shot.shot_id) + frame for shot in self._shots for frame in self._telling(shot)]
        missing = [frame for frame in wanted if frame not in known]
        if missing:
            figures = self._run.engine.read_figures(self._pack, missing).result()
            known |= dict(zip(missing, figures, strict=True))
            outputs.keep_only(f"{FIGURES}/{scene_name(self._pack.scene_id)}-", ())
            outputs.write(record, _RECORD.dump_json(known))
        return known


def figures_of(pack: PackRef) -> str:
    """Return the name of the record of everybody's faces in a pack."""
    return f"{FIGURES}/{Path(pack.path).stem}.json"


def cuts_made_wrong(run: Run, edited: Collection[ShotContext]) -> list[Flaw]:
    """Return the faults that the cuts to and from new cameras have, of these shots and of their neighbours.

    Args:
        run: With all cameras set.
        edited: The shots whose cameras are new.
    """
    keys = {(shot.scene_id, shot.shot_id) for shot in edited}
    committed = {(shot.scene_id, shot.shot_id): shot.camera for shot in run.graph.shots}
    found: list[Flaw] = []
    for shot in with_cuts_judged(run, {scene_id for scene_id, _ in keys}).shots:
        key, camera = (shot.scene_id, shot.shot_id), committed[shot.scene_id, shot.shot_id]
        if camera is not shot.camera and camera is not None and shot.camera is not None:
            known = {flaw.message for flaw in camera.residual} if key not in keys else set[str]()
            wrong = (flaw for flaw in shot.camera.residual if flaw.kind in CUT_KINDS and flaw.message not in known)
            found += [flaw.model_copy(update={"shot": shot_name(*key)}) for flaw in wrong]
    return found


def with_cuts_judged(run: Run, scenes: Collection[int] | None = None) -> ContinuityMemoryGraph:
    """Return the graph with the faults that its cuts have now, for reports.

    A changed camera changes the cuts of its neighbours too. Scenes whose faces were not measured keep the faults that
    their cameras were left with.

    Args:
        run: With packs and cameras.
        scenes: Ids of the scenes to judge; None judges all.
    """
    graph, fresh = as_filmed(run.graph), list[ShotContext]()
    for scene_id, pack in run.packs.items():
        if scenes is not None and scene_id not in scenes:
            continue
        environment = graph.scene(scene_id).environment
        shots = [shot for shot in graph.shots_in_order(scene_id) if not shot.omitted]
        if environment is None or len(shots) < 2 or not run.outputs.whole(figures_of(pack)):
            continue
        faces, plan, measures = (
            PackViewfinder(run, pack, graph.shots_of(scene_id)),
            plan_of(environment),
            measures_of(graph.assets),
        )
        states = judge_cuts([(s, camera_operator_view(graph, s, plan, measures, faces.moments(s))) for s in shots])
        fresh += [shot.model_copy(update={"camera": states.get(shot.shot_id, shot.camera)}) for shot in shots]
    return replace(graph, *fresh)


def film(run: Run) -> None:
    """Set every camera that is not set yet, and commit scene by scene; stopped, it keeps the scenes that are done.

    Raises:
        AnswerAwaited: Answers have to come from outside first; the cameras of every scene are asked for before.
    """
    graph = with_frames(run)
    unset = Counter(shot.scene_id for shot in graph.shots if shot.camera is None)
    scenes, total = [scene.scene_id for scene in graph.scenes if unset[scene.scene_id]], unset.total()
    done = 0
    run.progress("camera", done, total)
    threads = ThreadPoolExecutor(max_workers=run.engine.processes)
    operators = {scene_id: threads.submit(film_scene, run, graph, scene_id) for scene_id in scenes}
    awaited: list[AnswerAwaited] = []
    try:
        for scene_id in scenes:
            try:
                states, events = operators.pop(scene_id).result()
            except AnswerAwaited as error:
                awaited.append(error)
                continue
            done += _commit_scene(run, graph, scene_id, states, events)
            run.progress("camera", done, total, scene_name(scene_id))
        if awaited:
            raise AnswerAwaited.of(awaited)
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        for scene_id, operator in operators.items():
            if operator.done() and not operator.cancelled() and operator.exception() is None:
                _commit_scene(run, graph, scene_id, *operator.result())


def with_frames(run: Run) -> ContinuityMemoryGraph:
    """Return the graph as the film shows it, with the board's frame of every shot whose camera is to be set."""
    graph = as_filmed(run.graph)
    fresh = [
        shot.model_copy(update={"frame": story_moment(shot, run.packs[shot.scene_id].played(shot.shot_id))})
        for shot in graph.shots
        if shot.camera is None
    ]
    return replace(graph, *fresh)


def _commit_scene(
    run: Run, graph: ContinuityMemoryGraph, scene_id: int, states: Mapping[int, CameraState], events: Sequence[Event]
) -> int:
    for event in events:
        run.tell(event)
    fresh = [
        _with_camera(run.graph.shot(scene_id, shot.shot_id), states[shot.shot_id], shot.frame)
        for shot in graph.shots_of(scene_id)
        if shot.camera is None
    ]
    run.commit("camera_operator", f"cameras of {scene_name(scene_id)}", *fresh)
    return len(fresh)


def _with_camera(shot: ShotContext, state: CameraState, frame: int | None) -> ShotContext:
    """Return a shot with its camera; one other than before its scene was staged again has not been taken again yet."""
    former = shot.former_camera
    update: dict[str, Any] = {"camera": state, "frame": frame, "former_camera": None}
    update |= {} if former is None or state.poses == former.poses else {"camera_retake": None}
    return shot.model_copy(update=update)


def film_scene(run: Run, graph: ContinuityMemoryGraph, scene_id: int) -> tuple[dict[int, CameraState], list[Event]]:
    """Return the camera of every shot of a scene by shot_id, keeping those that are set, and the trace.

    Args:
        run: With the packs.
        graph: The story, ``with_frames``.
        scene_id: A scene with its set.

    Raises:
        EngineError: Blender failed for good.
        AnswerAwaited: An answer has to come from outside first.
    """
    environment = graph.scene(scene_id).environment
    assert environment is not None, "the set comes before the camera"
    viewfinder = PackViewfinder(run, run.packs[scene_id], graph.shots_of(scene_id))
    events: list[Event] = []
    states = shoot_scene(
        graph,
        scene_id,
        plan_of(environment),
        measures_of(graph.assets),
        viewfinder.moments,
        viewfinder,
        operator=run.crew.camera_operator,
        kit=run.settings.lens_kit,
        listener=events.append,
    )
    return states, events
