"""A shot's scene as the page shows it in 3D: its model, and every camera as Blender will have it."""

from __future__ import annotations

from typing import Literal

from storyblender.edits.posing import pose_choices
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film
from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraState, Mark, ShotContext
from storyblender.web_studio.messages import CameraKey, PersonOnStage, PlacedThing, PoseOnStage, Stage, StageCamera

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
    layout, aspect = graph.scene(shot.scene_id).layout, graph.format.aspect
    names = {asset.asset_id: asset.name or asset.description for asset in graph.assets}
    cast = {asset.asset_id for asset in graph.assets if asset.asset_type == "character"}
    placed = {
        item.node_id: PlacedThing(
            name=names.get(item.asset_id, item.asset_id), location=item.location, rotation=item.rotation[2]
        )
        for item in (layout.objects if layout is not None else ())
        if item.asset_id not in cast
    }
    people = {
        blocking.start.asset_id: PersonOnStage(
            name=names.get(blocking.start.asset_id, blocking.start.asset_id),
            start=blocking.start.location,
            end=blocking.end.location,
            rotation=blocking.start.yaw,
            start_pose=_pose(shot, blocking.start, "start"),
            end_pose=_pose(shot, blocking.end, "end"),
        )
        for blocking in shot.blocking
    }
    return Stage(
        shot=shot_name(shot.scene_id, shot.shot_id),
        model=model,
        frame=frame,
        frames=shot.duration,
        fps=graph.format.fps,
        aspect=aspect,
        cameras=tuple(
            _camera(other, other.camera, Film(other.camera.sensor_width, aspect))
            for other in graph.shots_in_order(shot.scene_id)
            if other.camera is not None
        ),
        placed=placed,
        people=people,
        poses=pose_choices(graph, graph.scene(shot.scene_id)),
    )


def _pose(shot: ShotContext, mark: Mark, when: Literal["start", "end"]) -> PoseOnStage:
    """Return how a person is at one end of a shot."""
    decided = shot.blocking_decision.people.get(mark.asset_id) if shot.blocking_decision is not None else None
    place = getattr(decided, when) if decided is not None else None
    return PoseOnStage(
        posture=mark.posture,
        on=mark.support_id or "",
        holding=tuple(prop for _, prop in mark.held),
        looking_at=(place.looking_at if place is not None else None) or "",
    )


def _camera(shot: ShotContext, state: CameraState, film: Film) -> StageCamera:
    """Return a camera with keys; one that rests has one."""
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
    )
