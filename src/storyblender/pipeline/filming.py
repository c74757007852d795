"""The Camera Operator at work: scenes side by side, the shots of a scene in order, because cuts must match."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor

from storyblender.agents.layout_artist.camera_brief import CameraBrief, Cut, Moment
from storyblender.agents.layout_artist.camera_operator import operate, side_used
from storyblender.catalog.sets import plan_of
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Film
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef
from storyblender.memory.measure import CameraView, ViewRequest
from storyblender.memory.scene_context import LayoutObject
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


def film(run: Run) -> None:
    """Set every camera that is not set yet, and commit scene by scene."""
    graph = run.graph
    scenes = [scene.scene_id for scene in graph.scenes if any(s.camera is None for s in graph.shots_of(scene.scene_id))]
    total = sum(1 for shot in graph.shots if shot.scene_id in scenes)
    done = 0
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
    pack = run.packs[scene_id]
    viewfinder = PackViewfinder(run, pack)
    events: list[Event] = []
    states: dict[int, CameraState] = {}
    for brief in _briefs(run, graph, scene_id, states):
        kept = graph.shot(scene_id, brief.shot_id).camera
        states[brief.shot_id] = kept or operate(brief, viewfinder, listener=events.append)
    return states, events


def _briefs(
    run: Run, graph: ContinuityMemoryGraph, scene_id: int, states: dict[int, CameraState]
) -> Iterator[CameraBrief]:
    """Yield the brief of each shot in turn; ``states`` is read as it fills."""
    scene, pack = graph.scene(scene_id), run.packs[scene_id]
    assert scene.environment is not None, "the set comes before the camera"
    plan, props = plan_of(scene.environment), boxes_of(graph, scene_id)
    before: CameraBrief | None = None
    singles: dict[str, Cut] = {}
    sides: dict[frozenset[str], int] = {}
    for shot in graph.shots_of(scene_id):
        if before is not None:
            _remember(before, states[before.shot_id], singles, sides)
        instruction = shot.camera_instruction
        pair = frozenset(instruction.axis or ())
        partner = next((person for person in instruction.axis or () if person not in instruction.focus_on_ids), None)
        brief = CameraBrief(
            scene_id=scene_id,
            shot_id=shot.shot_id,
            instruction=instruction,
            duration=shot.duration,
            moments=_moments(run, pack, shot),
            plan=plan,
            props=props,
            in_frame=shot.in_frame,
            film=Film(graph.format.sensor_width, graph.format.aspect),
            lens_kit=lens_kit(run.settings.lens_kit),
            previous=Cut(before.instruction, states[before.shot_id]) if before is not None else None,
            reverse=singles.get(partner) if partner else None,
            side=_oriented(instruction.axis, pair, sides),
            nodes=node_of_asset(graph, scene_id),
        )
        yield brief
        before = brief


def _remember(
    brief: CameraBrief, state: CameraState, singles: dict[str, Cut], sides: dict[frozenset[str], int]
) -> None:
    instruction = brief.instruction
    if instruction.kind in ("single", "reaction", "ots") and instruction.focus_on_ids:
        singles[instruction.focus_on_ids[0]] = Cut(instruction, state)
    side = side_used(brief, state)
    if side and instruction.axis:
        first, second = instruction.axis
        sides.setdefault(frozenset(instruction.axis), side if first < second else -side)


def _oriented(axis: tuple[str, str] | None, pair: frozenset[str], sides: dict[frozenset[str], int]) -> int:
    """The side remembered for a pair, seen from its first to its second person as this shot names them."""
    if axis is None:
        return 0
    side = sides.get(pair, 0)
    return side if axis[0] < axis[1] else -side


def _moments(run: Run, pack: PackRef, shot: ShotContext) -> tuple[Moment, ...]:
    """Everybody's faces at the start, in the middle and at the end of a shot."""
    last = max(0, shot.duration - 1)
    frames = sorted({0, last // 2, last})
    start = pack.start_of(shot.shot_id)
    figures = run.engine.read_figures(pack, [start + frame for frame in frames]).result()
    return tuple(Moment(frame, tuple(faces)) for frame, faces in zip(frames, figures, strict=True))


def boxes_of(graph: ContinuityMemoryGraph, scene_id: int) -> dict[str, Box]:
    """Return the boxes of a scene's things by node_id."""
    layout = graph.scene(scene_id).layout
    assert layout is not None, "the layout comes before the camera"
    return {
        item.node_id: box_of(graph, item)
        for item in layout.objects
        if graph.asset(item.asset_id).asset_type == "object"
    }


def box_of(graph: ContinuityMemoryGraph, item: LayoutObject) -> Box:
    """Return the box of one placed thing."""
    canonical = graph.asset(item.asset_id).canonical
    assert canonical is not None, f"{item.asset_id} has not been built"
    width, depth, height = canonical.dimensions
    return Box(*item.location, width, depth, height, math.radians(item.rotation[2]))


def node_of_asset(graph: ContinuityMemoryGraph, scene_id: int) -> dict[str, str]:
    """Return the first node that shows each asset."""
    layout = graph.scene(scene_id).layout
    nodes: dict[str, str] = {}
    for item in layout.objects if layout else ():
        nodes.setdefault(item.asset_id, item.node_id)
    return nodes


def lens_kit(kit: tuple[float, ...]) -> dict[ShotSize, float]:
    """Return a lens for each size from the lenses at hand; any lens where the kit is empty."""
    if not kit:
        return dict(LENS_OF_SIZE)
    return {
        size: min(kit, key=lambda lens, wish=wish: abs(math.log(lens / wish))) for size, wish in LENS_OF_SIZE.items()
    }
