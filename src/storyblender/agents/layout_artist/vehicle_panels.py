"""Panels of vehicles: roof, doors, posts, seats that are hidden for a shot, as a film stage takes a car apart."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView
from storyblender.agents.layout_artist.camera_solids import is_anyone_aboard
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import Figure
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.geometry.sight import find_hidden as hidden_from
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3, shot_number
from storyblender.memory.shot_context import ShotContext

_FAR = 4.2
"""Metres from the camera to what it shows beyond which a vehicle stays whole."""
_AT_TARGET = 0.06
"""Metres in front of a target in which nothing is in the way."""
_ABOUT = 0.11
"""Metres around a target that have to be seen with it: the half of a face."""
_STAYS = ("_steering_wheel", "_lever", "_pedals", "_mat")
"""Parts that people handle: they are small, and hands are on them."""
_AJAR = math.radians(62.0)
"""Angle of an open door, as ``blender.props.automobiles`` builds it."""
_MIDDLE = 0.02
"""Metres from the middle of a vehicle at which a target is the vehicle itself, which stays whole."""
_ON_SEAT = 0.25
"""Metres on the floor from a seat to the face of who sits on it."""
_TOUCHES = 0.12
"""Metres from the camera to a panel within which it fills the picture."""


def open_doors(shots: Sequence[ShotContext], shot_id: int, asset_id: str) -> frozenset[str]:
    """Return the names of a vehicle's doors that are open at the end of a shot.

    Args:
        shots: Of the scene, staged, in order.
        shot_id: The shot.
        asset_id: The vehicle.
    """
    now: tuple[str, ...] = ()
    for shot in shots:
        for change in shot.asset_modifications if shot_number(shot.shot_id) <= shot_number(shot_id) else ():
            if change.asset_id == asset_id and change.doors is not None:
                now = change.doors
    return frozenset(now)


def panel_boxes(
    node_id: str, location: Vec3, yaw: float, anchors: Sequence[Anchor], doors: Collection[str] = ()
) -> dict[str, Box]:
    """Return the boxes in the world of the panels and the parts of a placed thing, by the id that hides each.

    Args:
        node_id: Of the thing.
        location: Its bottom centre, world metres.
        yaw: Degrees.
        anchors: In its own frame.
        doors: Names of its open doors.
    """
    base = Box(*location, 0.0, 0.0, 0.0, math.radians(yaw))
    found: dict[str, Box] = {}
    for anchor in anchors:
        if anchor.kind in ("panel", "part"):
            (x, y, z), turn = anchor.location, 0.0
            if anchor.name.removeprefix("door_") in doors:  # it swings out about its front edge
                turn, half = math.copysign(_AJAR, x), anchor.size[1] / 2
                x, y = x + math.sin(turn) * half, y - half + math.cos(turn) * half
            x, y = base.to_world(x, y)
            size = (*anchor.size, anchor.clearance or 0.1)
            found[f"{node_id}_{anchor.name}"] = Box(x, y, location[2] + z, *size, base.yaw - turn)
    return found


def hidden_panels(view: CameraOperatorView, cameras: Iterable[Orbit], targets: Sequence[Floats]) -> list[str]:
    """Return the panels of vehicles that are hidden for a shot: those in the way to what it shows inside.

    Args:
        view: The shot.
        cameras: All poses of the shot.
        targets: (3,) world points that have to be visible.
    """
    if view.instruction.kind == "establishing" or not view.panels:
        return []
    cabins = {node: box for node, box in view.props.items() if f"{node}_dashboard" in view.panels}
    wholes = [(box.x, box.y) for node, box in cabins.items() if node in view.focus]
    inside = [
        each
        for each in targets
        if any(_is_in(box, each) for box in cabins.values())
        and not any(math.dist(middle, each[:2]) < _MIDDLE for middle in wholes)
    ]
    figures = view.story_moment.figures if view.instruction.kind != "insert" else ()
    wild = {
        id_: box
        for id_, box in view.panels.items()
        if not id_.endswith(_STAYS) and not ("_seat_" in id_ and any(_sits_on(box, each) for each in figures))
    }
    return find_hidden_panels(wild, dict.fromkeys(cameras), inside, view.things)


def aboard(view: CameraOperatorView) -> set[str]:
    """Return the node_ids of the people in vehicles that can be taken apart: these are never empty for a picture.

    Args:
        view: The shot.
    """
    boxes = [view.props[node] for node in wild_vehicles(view)]
    return {each.node_id for each in view.story_moment.figures if is_anyone_aboard(boxes, [each])}


def _sits_on(seat: Box, figure: Figure) -> bool:
    """Return whether a person is on a seat, given its box."""
    return distance_to_point(seat, figure.face[0], figure.face[1]) < _ON_SEAT and figure.face[2] > seat.z


def wild_vehicles(view: CameraOperatorView) -> tuple[str, ...]:
    """Return the node_ids of the vehicles with people in them whose panels a shot can hide: they are in nobody's way.

    Args:
        view: The shot.
    """
    figures = view.story_moment.figures
    opened = {node: box for node, box in view.props.items() if f"{node}_dashboard" in view.panels}
    return tuple(node for node, box in opened.items() if is_anyone_aboard([box], figures))


def find_hidden_panels(
    panels: Mapping[str, Box], cameras: Iterable[Orbit], targets: Sequence[Floats], subjects: Sequence[Box]
) -> list[str]:
    """Return the ids of the panels to hide, so that near cameras see what is in a vehicle.

    Args:
        panels: Boxes by id.
        cameras: All poses of the shot.
        targets: (3,) world points that have to be visible.
        subjects: Boxes of the things that the shot is about: a panel that is one of them stays.
    """
    kept = {id_ for id_, box in panels.items() if any(_is_same(box, other) for other in subjects)}
    hidden: dict[str, None] = {}
    for camera in cameras:
        eye = camera.position
        near = [target for target in targets if math.dist(eye, target) < _FAR]
        points = [target + off for target in near for off in _around(eye, target)]
        for id_, box in panels.items():
            if id_ not in kept and (_is_at(box, eye) or _blocks(box, eye, points)):
                hidden[id_] = None
    return list(hidden)


def _is_in(box: Box, point: Floats) -> bool:
    """Return whether a world point is over the floor of a box, below its top."""
    return distance_to_point(box, point[0], point[1]) < 0 and box.z - 0.1 < point[2] < box.top + 0.1


def _around(eye: Floats, target: Floats) -> list[Floats]:
    """Return the offsets (3,) from a target to the points around it that the eye has to see."""
    way = np.asarray(target) - eye
    across = np.array([way[1], -way[0], 0.0])
    across /= max(float(np.linalg.norm(across)), 1e-6)
    return [np.zeros(3), _ABOUT * across, -_ABOUT * across, np.array([0.0, 0.0, _ABOUT])]


def _blocks(box: Box, eye: Floats, points: Sequence[Floats]) -> bool:
    return bool(points) and bool(hidden_from([box], eye, np.array(points), _AT_TARGET).any())


def _is_at(box: Box, eye: Floats) -> bool:
    return distance_to_point(box, eye[0], eye[1]) < _TOUCHES and box.z - _TOUCHES < eye[2] < box.top + _TOUCHES


def _is_same(box: Box, other: Box) -> bool:
    """Return whether two boxes are in one place: a part of the story is the panel."""
    return math.dist((box.x, box.y, box.z), (other.x, other.y, other.z)) < 0.15
