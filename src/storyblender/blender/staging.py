"""Converts a scene job to the motion solver's stage plans: people, props and obstacles of every shot."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from storyblender.blender.motion.plan import Obstacle, StageFurniture, StagePerson, StagePlan, StageProp, box_of
from storyblender.blender.people.body import RiggedBody
from storyblender.catalog.footprints import piece_boxes, wall_boxes
from storyblender.catalog.garments import worn_open
from storyblender.catalog.openings import OpeningPlace, openings_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.mocap import MocapPoses
from storyblender.geometry.solids import transform
from storyblender.memory.asset_sheet import Anchor, Asset
from storyblender.memory.base import content_hash
from storyblender.memory.jobs import SceneJob
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import Cue, PropState, ShotContext

LOW_TOP = 0.12
"""Metres; lower objects (rugs, kerbs) are stepped over."""
OVERHEAD = 2.0
"""Metres: what begins higher is walked under (lamps)."""


class StagePlanner:
    """Makes the stage plans of a scene's shots.

    Args:
        job: The scene.
        plan: Its set.
        bodies: Measured body by asset id of the person.
        mocap: Returns a recorded motion by its digest; None for one that cannot be read.
    """

    def __init__(
        self,
        job: SceneJob,
        plan: SetPlan,
        bodies: dict[str, RiggedBody],
        mocap: Callable[[str], MocapPoses | None] = lambda digest: None,
    ) -> None:
        assert job.scene.layout is not None, "a scene is laid out before it is packed"
        self._job, self._bodies, self._mocap = job, bodies, mocap
        self._assets = {asset.asset_id: asset for asset in job.assets}
        self._objects = [
            item for item in job.scene.layout.objects if self._assets[item.asset_id].asset_type == "object"
        ]
        self._movable = moved_assets(job)
        self._furniture = {
            item.node_id: _furniture(item, self._assets[item.asset_id])
            for item in self._objects
            if item.asset_id not in self._movable
        }
        self._openings = {place.opening.name: _opening(place) for wall in plan.walls for place in openings_of(wall)}
        size = job.scene.layout.scene_size
        self._bounds = (size.x_negative, size.y_negative, size.x, size.y)
        self._obstacles = (*self._solid_furniture(), *_solid_set(plan))

    def plan(self, shot: ShotContext) -> StagePlan:
        """Return the stage plan of one shot."""
        people = {
            blocking.start.asset_id: StagePerson(
                self._bodies[blocking.start.asset_id], blocking, self._wears_jacket(blocking.start.asset_id)
            )
            for blocking in shot.blocking
            if blocking.start.asset_id in self._bodies
        }
        named = {cue.mocap: self._mocap(cue.mocap) for cue in shot.cues if cue.mocap is not None}
        return StagePlan(
            people=people,
            frames=shot.duration,
            cues=tuple(self._of_whole(cue) for cue in shot.cues),
            props=self._props(shot),
            furniture={**self._openings, **self._furniture},
            obstacles=self._obstacles,
            bounds=self._bounds,
            seed=int(content_hash(shot.scene_id, shot.shot_id)[:8], 16),
            mocap={digest: poses for digest, poses in named.items() if poses is not None},
        )

    def _of_whole(self, cue: Cue) -> Cue:
        """Return a cue in which a part of a vehicle is not picked up but reached for where it is."""
        prop = self._assets.get(cue.prop_id or "")
        if prop is None or not prop.fitted_part:
            return cue
        return cue.model_copy(update={"prop_id": None, "target_id": cue.target_id or cue.prop_id})

    def _wears_jacket(self, asset_id: str) -> bool:
        """Return whether a person wears something open with breast pockets."""
        look = self._assets[asset_id].look
        return look is not None and any(worn_open(garment.key) for garment in look.garments)

    def _props(self, shot: ShotContext) -> dict[str, StageProp]:
        """Return the movable props of a shot."""
        states = {state.asset_id: state for state in shot.prop_states}
        props: dict[str, StageProp] = {}
        for asset_id in self._movable:
            asset = self._assets[asset_id]
            item = next((item for item in self._objects if item.asset_id == asset_id), None)
            if asset.canonical is None:
                continue
            state = states.get(asset_id)
            props[asset_id] = StageProp(
                world=_prop_world(item, state),
                dimensions=asset.canonical.dimensions,
                anchors=asset.canonical.anchors,
                state=state,
                node_id=item.node_id if item else asset_id,
            )
        return props

    def _solid_furniture(self) -> list[Obstacle]:
        """Return the furniture that people walk around, as boxes."""
        return [
            box_of(node_id, furniture)
            for node_id, furniture in self._furniture.items()
            if furniture.world[2, 3] < OVERHEAD and furniture.world[2, 3] + furniture.dimensions[2] > LOW_TOP
        ]


def moved_assets(job: SceneJob) -> list[str]:
    """Return the ids of objects that people touch or that change place in any shot, in order of appearance."""
    objects = {asset.asset_id for asset in job.assets if asset.asset_type == "object" and not asset.fitted_part}
    moved: dict[str, None] = {}
    for shot in job.shots:
        for cue in shot.cues:
            if cue.prop_id in objects:
                moved[str(cue.prop_id)] = None
        for state in shot.prop_states:
            if state.asset_id in objects:
                moved[state.asset_id] = None
        for blocking in shot.blocking:
            for _, asset_id in (*blocking.start.held, *blocking.end.held):
                if asset_id in objects:
                    moved[asset_id] = None
    return list(moved)


def _furniture(item: LayoutObject, asset: Asset) -> StageFurniture:
    """Return a layout object as furniture of the stage."""
    assert asset.canonical is not None, f"{asset.asset_id} has not been built"
    world = transform(item.location, item.rotation, 1.0)
    return StageFurniture(world, asset.canonical.dimensions, asset.canonical.anchors, asset.asset_id)


def _opening(place: OpeningPlace) -> StageFurniture:
    """Return a door or window as furniture that people look at and operate but do not walk around."""
    handles = (Anchor(kind="handle", location=place.handle),) if place.opening.kind == "door" else ()
    world = transform(place.location, (0.0, 0.0, math.degrees(place.yaw)), 1.0)
    return StageFurniture(world, place.size, handles, place.opening.kind)


def _prop_world(item: LayoutObject | None, state: PropState | None) -> np.ndarray:
    """Return the world matrix (4, 4) of a prop at the start of a shot; below the floor if it has no place."""
    if state is not None and state.location is not None:
        return transform(state.location, state.rotation, 1.0)
    if item is not None:
        return transform(item.location, item.rotation, 1.0)
    return transform((0.0, 0.0, -5.0), (0.0, 0.0, 0.0), 1.0)


def _solid_set(plan: SetPlan) -> list[Obstacle]:
    """Return walls, with gaps for doors and arches, and solid pieces of the set as boxes."""
    boxes = [(wall.node_id, box) for wall in plan.walls for box in wall_boxes(wall)]
    boxes += [(piece.node_id, box) for piece in plan.pieces for box in piece_boxes(piece)]
    return [
        Obstacle(name, (box.x, box.y, box.z + box.height / 2), (box.width, box.depth, box.height), box.yaw)
        for name, box in boxes
    ]
