"""Wild walls: what is taken away for a shot because it stands between the camera and what it looks at."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from storyblender.catalog.set_plan import Piece, SetPlan, Wall
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.geometry.sight import find_hidden as hidden_from

_ON_WALL = 0.45
"""Metres from a taken wall within which a thing goes with it: its pictures, and the shelf before it."""
_HUNG, _FLUSH = 0.3, 0.1
"""Metres above the floor from which a thing at a wall hangs on it; metres from the wall within which a piece of the set
is built against it."""
_LIFTED = 0.06
"""Metres above the floor from which a thing stands on something; metres above a top that it may be."""
_AT_TARGET = 0.3
"""Metres before a target that are its own: what it leans at is not in the way."""
_CLOSE = 0.25
"""Metres from a wall at which the camera would scrape it."""
_SKIN, _HALF_HEAD = 0.01, 0.12
"""Metres before a wall that are the room's; metres that a head which bows at it reaches into it."""


def taken_away(
    plan: SetPlan, props: Mapping[str, Box], cameras: Iterable[Orbit], targets: Sequence[Floats]
) -> list[str]:
    """Return the node_ids to hide for cameras that look at targets (and at the corners of their own frames).

    Args:
        plan: Walls, ceilings and wild pieces.
        props: Boxes of the things that may go with a wall; leave out what the shot is about.
        cameras: All poses of the shot.
        targets: World points that have to be seen.
    """
    hidden: dict[str, None] = {}
    targets = [_on_set(plan, target) for target in targets]
    for camera in cameras:
        eye = camera.position
        sights = [*targets, *(point for point in _frame_points(camera) if _in_room(plan, point))]
        for wall in plan.walls:
            if wall.wild and _stands_between(wall, eye, sights):
                hidden[wall.node_id] = None
                hidden |= dict.fromkeys(node for node, box in props.items() if _goes_with(box, wall, eye, sights))
                hidden |= dict.fromkeys(piece.node_id for piece in plan.pieces if _built_on(piece, wall))
        for slab in plan.slabs:
            if slab.role == "ceiling" and eye[2] > slab.z - 0.15:
                hidden[slab.node_id] = None
        for piece in plan.pieces:
            if piece.wild and (box := _box_of(piece)) is not None and _crosses(box, eye, sights[: len(targets)]):
                hidden[piece.node_id] = None
    return list(hidden | _standing_on(plan, props, hidden))


def _standing_on(plan: SetPlan, props: Mapping[str, Box], hidden: Mapping[str, None]) -> dict[str, None]:
    """Return what stands on or in things and pieces of the set that are taken away: it would float without them."""
    gone = [box for node, box in props.items() if node in hidden]
    gone += [box for piece in plan.pieces if piece.node_id in hidden and (box := _box_of(piece)) is not None]
    stays = [box for node, box in props.items() if node not in hidden]
    return {
        node: None
        for node, box in props.items()
        if box.z > _LIFTED and any(_carries(base, box) for base in gone) and not any(_carries(b, box) for b in stays)
    }


def _carries(base: Box, box: Box) -> bool:
    """Return whether a thing is on another, or in it."""
    return base is not box and base.z < box.z < base.top + _LIFTED and distance_to_point(base, box.x, box.y) < 0


def _box_of(piece: Piece) -> Box | None:
    """Return the room that a piece of the set takes, up to above people's heads; None without an outline."""
    if piece.footprint is None:
        return None
    width, depth = (size * piece.scale for size in piece.footprint)
    return Box(*piece.location, width, depth, 4.0, math.radians(piece.yaw))


def _on_set(plan: SetPlan, target: Floats) -> Floats:
    """Return a target, or the spot before the wall that it reaches into: who bows at a wall does not open it."""
    if not plan.indoor:
        return target
    size = plan.size
    low, high = (size.x_negative + _SKIN, size.y_negative + _SKIN), (size.x - _SKIN, size.y - _SKIN)
    spot = np.array([*np.clip(target[:2], low, high), target[2]])
    return spot if math.dist(spot, target) < _HALF_HEAD else target


def _in_room(plan: SetPlan, point: Floats) -> bool:
    """Return whether a point is on the set: nothing is taken away to look at what lies beyond it."""
    size = plan.size
    return not plan.indoor or (size.x_negative < point[0] < size.x and size.y_negative < point[1] < size.y)


def _frame_points(camera: Orbit) -> list[Floats]:
    """Return points of the picture at nine tenths of the way to the pivot: middle, and half-way to its corners."""
    axes, height = camera.axes, camera.frame_height
    middle = np.asarray(camera.pivot) + axes[:, 2] * camera.distance * 0.1
    spread = [(0.0, 0.0), (0.4, 0.3), (-0.4, 0.3), (0.4, -0.3), (-0.4, -0.3)]
    return [middle + axes[:, 0] * x * height * camera.aspect + axes[:, 1] * y * height for x, y in spread]


def _stands_between(wall: Wall, eye: Floats, sights: Sequence[Floats]) -> bool:
    start, end = np.asarray(wall.start), np.asarray(wall.end)
    along = end - start
    length = float(np.hypot(*along))
    along /= length
    inward = np.array([-along[1], along[0]])
    out = float((eye[:2] - start) @ inward)
    beside = float((eye[:2] - start) @ along)
    if abs(out) < _CLOSE and -_CLOSE < beside < length + _CLOSE:
        return True
    return any(_is_cut(wall, start, along, inward, length, eye, sight) for sight in sights)


def _is_cut(
    wall: Wall, start: Floats, along: Floats, inward: Floats, length: float, eye: Floats, sight: Floats
) -> bool:
    """Return whether the line of sight meets the wall, and not one of its openings."""
    before, after = float((eye[:2] - start) @ inward), float((sight[:2] - start) @ inward)
    if before * after >= 0:
        return False
    share = before / (before - after)
    point = eye + (sight - eye) * share
    x, z = float((point[:2] - start) @ along), float(point[2])
    if not (0 <= x <= length and wall.base <= z <= wall.base + wall.height):
        return False
    return not any(
        hole.x + 0.1 < x < hole.x + hole.width - 0.1
        and hole.sill < z < hole.sill + hole.height
        and (hole.kind in ("arch", "gap") or (hole.kind == "door" and hole.state == "open"))
        for hole in wall.openings
    )


def _goes_with(box: Box, wall: Wall, eye: Floats, sights: Sequence[Floats]) -> bool:
    """Return whether a thing hangs on a taken wall, or stands at it in the camera's way."""
    start, end = np.asarray(wall.start), np.asarray(wall.end)
    along = (end - start) / np.hypot(*(end - start))
    inward = np.array([-along[1], along[0]])
    centre = np.array([box.x, box.y])
    depth = abs(float((centre - start) @ inward)) - box.reach((float(inward[0]), float(inward[1])))
    x = float((centre - start) @ along)
    if depth > _ON_WALL or not -0.2 < x < float(np.hypot(*(end - start))) + 0.2:
        return False
    return box.z > _HUNG or _crosses(box, eye, sights)


def _built_on(piece: Piece, wall: Wall) -> bool:
    """Return whether a piece of the set is built against a wall, as a mirror or a fireplace is: it goes with it."""
    start, end = np.asarray(wall.start), np.asarray(wall.end)
    length = float(np.hypot(*(end - start)))
    along = (end - start) / length
    off = np.array(piece.location[:2]) - start
    away = abs(float(off @ np.array([-along[1], along[0]])))
    return away < _FLUSH and 0 < float(off @ along) < length


def _crosses(box: Box, eye: Floats, sights: Sequence[Floats]) -> bool:
    return bool(sights) and bool(hidden_from([box], eye, np.array(sights), _AT_TARGET).any())
