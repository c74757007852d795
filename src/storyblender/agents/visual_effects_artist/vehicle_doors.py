"""Doors of vehicles: a passenger gets in or out at the door of their seat, which is open meanwhile."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.agents.visual_effects_artist.floor import facing
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.placed_objects import PlacedObject
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.geometry.solids import transform
from storyblender.geometry.stations import Station
from storyblender.memory.asset_sheet import Anchor, Asset
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import AssetModification, BodyState, CharacterAction, Mark, ShotContext

_BESIDE, _BEHIND = 0.1, 0.34
"""Metres outward and to the rear from a door's middle to the passenger, clear of the open door."""
_DOOR_STATES = ("open", "closed")
_REACHES = 1.6
"""Metres from a door's middle to a person who opens it."""
_AT_DOOR = 0.75
"""Metres from a door's middle within which a person counts as at that door."""


def boarding_station(stage: StageState, person: StagedPerson, state: BodyState) -> Station | None:
    """Return where a passenger stands before getting in: at the door of their seat; None without a door or seat.

    Args:
        stage: The state of the scene.
        person: The passenger.
        state: Their state at the end of the shot, with the vehicle as support.
    """
    spot = state.spot
    thing = stage.floor.thing(state.support_id) or stage.floor.thing(spot.anchor_id if spot else None)
    if thing is None or not thing.anchors_of("door"):
        return None
    seat = stage.seats.choose(person, thing.node_id, side=spot.side if spot is not None else None)
    return None if seat is None or seat.node_id != thing.node_id else _station_at_door(thing, seat.anchor)


def leaving_station(
    stage: StageState, person: StagedPerson, action: CharacterAction
) -> tuple[PlacedObject, Station] | None:
    """Return the vehicle that a passenger gets out of, and where they then stand; None if it has no doors.

    Args:
        stage: The state of the scene.
        person: The passenger; they sit in it, or are first seen as they get out.
        action: Their action.
    """
    anchor, thing = person.anchor, stage.floor.things.get(person.support or "")
    if thing is None and action.gets_out and (thing := stage.floor.thing(action.target_id)) is not None:
        seat = stage.seats.choose(person, thing.node_id) if thing.anchors_of("door") else None
        anchor = seat.anchor if seat is not None else ""
    station = _station_at_door(thing, anchor) if thing is not None else None
    return (thing, station) if thing is not None and station is not None else None


def _station_at_door(thing: PlacedObject, name: str) -> Station | None:
    """Return the standing place at a vehicle's door with a name, else at its first door; None if it has none."""
    doors = thing.anchors_of("door")
    door = next((door for door in doors if door.name == name), doors[0] if doors else None)
    if door is None:
        return None
    x, y, _ = door.location
    wx, wy, _ = thing.to_world((x + math.copysign(_BESIDE, x), y + _BEHIND, 0.0))
    middle = thing.to_world((0.0, y, 0.0))
    return Station(wx, wy, facing((wx, wy), middle[:2]))


def add_open_doors(
    shots: Sequence[ShotContext], objects: Sequence[LayoutObject], assets: Sequence[Asset]
) -> tuple[ShotContext, ...]:
    """Return the shots with vehicle doors open while a passenger gets in or out, and while the script has them open.

    Args:
        shots: All shots of one scene, staged, in order.
        objects: The layout.
        assets: Assets of the scene, built.
    """
    made = {asset.asset_id: asset.canonical for asset in assets if asset.canonical is not None}
    vehicles = [item for item in objects if item.asset_id in made and _door_names(made[item.asset_id].anchors)]
    open_now: dict[str, list[str]] = {}
    told: dict[str, set[str]] = {}
    done: list[ShotContext] = []
    for index, shot in enumerate(shots):
        before, after = shots[index - 1] if index else None, shots[index + 1] if index + 1 < len(shots) else None
        changes: list[AssetModification] = []
        for item in vehicles:
            anchors = made[item.asset_id].anchors
            stated = _told_states(shot, item.asset_id)
            for state in stated:
                told[item.node_id] = {_door_told(shot, item, anchors)} if state == "open" else set()
            doors = sorted({*_doors_in_use(shot, before, after, item, anchors), *told.get(item.node_id, ())})
            if stated or doors != open_now.get(item.node_id, []):
                state = "open" if doors else "closed"
                change = AssetModification(
                    asset_id=item.asset_id, modification_type="transform", state=state, doors=tuple(doors)
                )
                changes.append(change)
                open_now[item.node_id] = doors
        kept = tuple(each for each in shot.asset_modifications if each.doors is None)
        fresh = (*kept, *changes)
        done.append(
            shot if fresh == shot.asset_modifications else shot.model_copy(update={"asset_modifications": fresh})
        )
    return tuple(done)


def _door_names(anchors: Sequence[Anchor]) -> bool:
    """Return whether any of the anchors is a door with a name."""
    return any(anchor.kind == "door" and anchor.name for anchor in anchors)


def _told_states(shot: ShotContext, asset_id: str) -> list[str]:
    """Return the states of a vehicle's door that a shot states, in order."""
    told = (each for each in shot.asset_modifications if each.asset_id == asset_id and each.doors is None)
    return [each.state for each in told if each.state in _DOOR_STATES]


def _door_told(shot: ShotContext, item: LayoutObject, anchors: Sequence[Anchor]) -> str:
    """Return the door that a shot has open: of the nearest person who acts on the vehicle, else the driver's."""
    world, names = transform(item.location, item.rotation, 1.0), (item.node_id, item.asset_id)
    acting = {each.asset_id for each in shot.character_actions if {each.target_id, each.prop_id} & {*names}}
    marks = [each.end for each in shot.blocking if each.end.asset_id in acting and each.end.support_id not in names]
    doors = [anchor for anchor in anchors if _door_names((anchor,))]
    near = min(((_distance_to_door(mark, world, door), door.name) for mark in marks for door in doors), default=None)
    if near is not None and near[0] < _REACHES:
        return near[1]
    return next((door.name for door in doors if door.name == "driver"), doors[0].name)


def _doors_in_use(
    shot: ShotContext,
    before: ShotContext | None,
    after: ShotContext | None,
    item: LayoutObject,
    anchors: Sequence[Anchor],
) -> Iterator[str]:
    """Yield the names of doors in use: a passenger gets in or out there, or opens it."""
    world = transform(item.location, item.rotation, 1.0)
    names = (item.node_id, item.asset_id)
    aboard = {
        state.asset_id
        for state in shot.end_states
        if state.posture == "sit" and {state.support_id, state.spot.anchor_id if state.spot else None} & {*names}
    }
    aboard |= {each.start.asset_id for each in (after.blocking if after else ()) if each.start.support_id in names}
    was = {each.end.asset_id for each in (before.blocking if before else ()) if each.end.support_id in names}
    was |= {state.asset_id for state in shot.states if state.posture == "sit" and state.support_id in names}
    was |= {each.asset_id for each in shot.character_actions if each.gets_out and each.target_id in names}
    opening = {
        action.asset_id
        for action in shot.character_actions
        if action.motion == "open" and {action.target_id, action.prop_id} & {*names}
    }
    for blocking in shot.blocking:
        mark = blocking.end
        if mark.support_id in names or mark.asset_id not in aboard | was | opening:
            continue
        near = [(_distance_to_door(mark, world, anchor), anchor.name) for anchor in anchors if _door_names((anchor,))]
        if near and min(near)[0] < _AT_DOOR:
            yield min(near)[1]


def _distance_to_door(mark: Mark, world: NDArray[np.float64], anchor: Anchor) -> float:
    """Return the metres on the floor between a mark and a door's anchor."""
    x, y, _ = world[:3, :3] @ np.asarray(anchor.location) + world[:3, 3]
    return math.dist(mark.location[:2], (float(x), float(y)))
