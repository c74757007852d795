"""A shot's scene as the page shows it in 3D: its model, every camera as Blender will have it, people, things, lamps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Literal

from storyblender.agents.layout_artist.placed_by_hand import Stand, riders_of, stand_of
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.person import stature_of
from storyblender.catalog.motions import AIMED, MOTIONS
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.sets import plan_of
from storyblender.edits.posing import pose_choices
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film
from storyblender.geometry.paths import walk_through
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Layout, LayoutObject, SceneContext
from storyblender.memory.scene_decision import PersonMarks
from storyblender.memory.shot_context import Blocking, CameraState, Mark, ShotContext
from storyblender.web_studio.stage_values import (
    CameraKey,
    FloorPoint,
    LampOnStage,
    PersonOnStage,
    PlacedThing,
    PoseOnStage,
    Stage,
    StageCamera,
)

KEY_EVERY = 4
"""Frames between the keys of a camera that moves, as in story.blend."""


def stage_of(graph: ContinuityMemoryGraph, shot: ShotContext, model: str, frame: int) -> Stage:
    """Return the stage of a shot.

    Args:
        graph: The story.
        shot: One that is being set has no camera.
        model: Address of the moment in 3D.
        frame: Of that moment, from the start of the shot.
    """
    scene, aspect = graph.scene(shot.scene_id), graph.format.aspect
    names = {asset.asset_id: asset.name or asset.description for asset in graph.assets}
    return Stage(
        shot=shot_name(shot.scene_id, shot.shot_id),
        model=model,
        frame=frame,
        frames=shot.duration,
        fps=graph.format.fps,
        aspect=aspect,
        cameras=tuple(
            stage_camera(other, other.camera, Film(other.camera.sensor_width, aspect))
            for other in graph.shots_in_order(shot.scene_id)
            if other.camera is not None
        ),
        setting=tuple(
            shot_name(other.scene_id, other.shot_id)
            for other in graph.shots_in_order(shot.scene_id)
            if other.camera is None
        ),
        placed=_placed(graph, scene, names),
        people=_people(graph, scene, shot, names),
        lamps={
            lamp.name: LampOnStage(
                kind=lamp.kind, location=lamp.location, target=lamp.target, power=round(lamp.power, 2), color=lamp.color
            )
            for lamp in (scene.lighting.lights if scene.lighting is not None else ())
        },
        poses=pose_choices(graph, scene),
        locked=(*shot.locked, *scene.locked),
    )


def stage_camera(shot: ShotContext, state: CameraState, film: Film) -> StageCamera:
    """Return the camera of a shot with keys; one that rests has one.

    Args:
        shot: The shot.
        state: Its camera.
        film: Sensor and aspect of the project.
    """
    last = shot.duration - 1
    frames = sorted({*range(0, last, KEY_EVERY), last}) if len(state.poses) > 1 else [0]
    orbits = [(frame, camera_at(state, frame, film)) for frame in frames]
    return StageCamera(
        shot=shot_name(shot.scene_id, shot.shot_id),
        sensor_width=state.sensor_width,
        keys=tuple(
            CameraKey(frame=frame, world=tuple(orbit.world.ravel().tolist()), lens=orbit.lens, distance=orbit.distance)
            for frame, orbit in orbits
        ),
        hidden=state.hidden_node_ids,
        f_number=round(state.f_number, 2),
        focus=tuple(dict.fromkeys(key.node_id for key in (*state.focus[:1], *state.focus[-1:]))),
    )


def _placed(graph: ContinuityMemoryGraph, scene: SceneContext, names: Mapping[str, str]) -> dict[str, PlacedThing]:
    """Return what the layout of a scene places, people aside, by node id."""
    layout, environment = scene.layout, scene.environment
    if layout is None or environment is None:
        return {}
    stand, assets = stand_of(graph.assets, environment), {asset.asset_id: asset for asset in graph.assets}
    return {
        item.node_id: PlacedThing(
            name=names.get(item.asset_id, item.asset_id),
            location=item.location,
            rotation=item.rotation[2],
            rests=_rests(item, stand),
            carries=tuple(riders_of(layout, item.node_id, stand)),
            model=_model(assets.get(item.asset_id)),
        )
        for item in layout.objects
        if not stand.is_person(item)
    }


def _rests(item: LayoutObject, stand: Stand) -> Literal["floor", "surface", "hangs"]:
    """Return what a thing comes to stand on when it is moved, as the edit of its place has it."""
    kind, thing = stand.placements.get(item.asset_id), stand.thing(item)
    if kind in ("wall", "ceiling") or (thing is not None and thing.floats and not item.fixed):
        return "hangs"
    return "floor" if kind == "floor" else "surface"


def _model(asset: Asset | None) -> str:
    """Return the key of the prop that a thing is made from; empty if the library has none."""
    key = prop_of(asset) if asset is not None else None
    return key if key is not None and key in PROPS else ""


def _people(
    graph: ContinuityMemoryGraph, scene: SceneContext, shot: ShotContext, names: Mapping[str, str]
) -> dict[str, PersonOnStage]:
    """Return who is on stage in a shot, by id."""
    decided = shot.blocking_decision.people if shot.blocking_decision is not None else {}
    walks = {name: tuple(ways) for name, ways in _walks(graph, scene, shot)}
    return {
        blocking.start.asset_id: PersonOnStage(
            name=names.get(blocking.start.asset_id, blocking.start.asset_id),
            start=blocking.start.location,
            end=blocking.end.location,
            rotation=blocking.start.yaw,
            walks=walks.get(blocking.start.asset_id, ()),
            via=decided.get(blocking.start.asset_id, PersonMarks()).via or (),
            start_pose=_pose(blocking.start, decided, "start"),
            end_pose=_pose(blocking.end, decided, "end"),
        )
        for blocking in shot.blocking
    }


def _walks(
    graph: ContinuityMemoryGraph, scene: SceneContext, shot: ShotContext
) -> Iterator[tuple[str, list[tuple[FloorPoint, ...]]]]:
    """Yield everybody's id with the ways that they walk in a shot, around what stands in them."""
    layout: Layout | None = scene.layout
    if layout is None or scene.environment is None:
        return
    floor = Floor(layout, graph.assets_of(scene.scene_id), plan_of(scene.environment))
    for blocking in shot.blocking:
        scale = stature_of(graph.asset(blocking.start.asset_id)) / 1.7
        yield blocking.start.asset_id, [_way(floor, scale, stops) for stops in _stops(shot, blocking)]


def _stops(shot: ShotContext, blocking: Blocking) -> Iterator[tuple[FloorPoint, ...]]:
    """Yield, for each walk of a person in a shot, where it begins, the points it goes through, and where it ends."""
    here = blocking.start.location[:2]
    for cue in shot.cues:
        if cue.asset_id != blocking.start.asset_id or cue.mark is None or cue.mark.asset_id != cue.asset_id:
            continue
        there = cue.mark.location[:2]
        if MOTIONS[cue.clip].speed and cue.clip not in AIMED:
            yield (here, *cue.via, there)
        here = there


def _way(floor: Floor, scale: float, stops: tuple[FloorPoint, ...]) -> tuple[FloorPoint, ...]:
    """Return the way from one stop to the next; straight on where there is none."""

    def leg(start: FloorPoint, end: FloorPoint) -> list[FloorPoint]:
        return floor.path(start, end, scale) or [start, end]

    way = walk_through(leg, stops) or stops
    return tuple((round(x, 3), round(y, 3)) for x, y in way)


def _pose(mark: Mark, decided: Mapping[str, PersonMarks], when: Literal["start", "end"]) -> PoseOnStage:
    """Return how a person is at one end of a shot."""
    place = getattr(decided.get(mark.asset_id, PersonMarks()), when)
    return PoseOnStage(
        posture=mark.posture,
        on=mark.support_id or "",
        holding=tuple(prop for _, prop in mark.held),
        looking_at=(place.looking_at if place is not None else None) or "",
    )
