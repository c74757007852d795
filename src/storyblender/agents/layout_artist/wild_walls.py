"""Wild walls: parts of the set that are hidden for a shot because they stand between camera and subject."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from storyblender.agents.layout_artist.camera_room import wall_frame
from storyblender.catalog.set_plan import Piece, SetPlan, Wall
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.geometry.sight import find_hidden as hidden_from

_ON_WALL = 0.45
"""Metres from a hidden wall within which a thing is hidden with it: its pictures, and the shelf in front of it."""
_HUNG, _FLUSH = 0.3, 0.1
"""Metres above the floor from which a thing at a wall hangs on it; metres from what is built against a wall to it."""
_TALL = 1.0
"""Height in metres from which a thing with its back to a wall is never shown from behind: a bookcase, a fireplace."""
_LIFTED = 0.06
"""Metres above the floor from which a thing stands on something; most metres above that top."""
_AT_TARGET = 0.3
"""Metres in front of a target in which nothing is in the way."""
_CLOSE = 0.25
"""Metres from a wall within which the camera would touch it."""
_SKIN, _HALF_HEAD = 0.01, 0.12
"""Metres inside the walls that count as outside; metres that the head of a person at the wall reaches into it."""


def find_hidden_nodes(
    plan: SetPlan, props: Mapping[str, Box], cameras: Iterable[Orbit], targets: Sequence[Floats]
) -> list[str]:
    """Return the node_ids to hide, so that cameras see their targets and half-way to the corners of their frames.

    Args:
        plan: Walls, ceilings and wild pieces of the set.
        props: Boxes by node_id of the things that may be hidden with a wall; not what the shot is about.
        cameras: All poses of the shot.
        targets: (3,) world points that have to be visible.
    """
    hidden: dict[str, None] = {}
    targets = [_move_into_room(plan, target) for target in targets]
    for camera in cameras:
        eye = camera.position
        sights = [*targets, *(point for point in _frame_points(camera) if _is_in_room(plan, point))]
        for wall in plan.walls:
            if wall.wild and _stands_between(wall, eye, sights):
                hidden[wall.node_id] = None
                hidden |= dict.fromkeys(
                    node for node, box in props.items() if _is_hidden_with_wall(box, wall, eye, sights)
                )
                hidden |= dict.fromkeys(piece.node_id for piece in plan.pieces if _is_built_on(piece, wall))
        for slab in plan.slabs:
            if slab.role == "ceiling" and eye[2] > slab.z - 0.15:
                hidden[slab.node_id] = None
        for piece in plan.pieces:
            if piece.wild and (box := _box_of(piece)) is not None and _blocks_sight(box, eye, sights[: len(targets)]):
                hidden[piece.node_id] = None
    return list(hidden | _find_unsupported(plan, props, hidden))


def _find_unsupported(plan: SetPlan, props: Mapping[str, Box], hidden: Mapping[str, None]) -> dict[str, None]:
    """Return the things that stand on or in a hidden one, and would float without it."""
    gone = [box for node, box in props.items() if node in hidden]
    gone += [box for piece in plan.pieces if piece.node_id in hidden and (box := _box_of(piece)) is not None]
    stays = [box for node, box in props.items() if node not in hidden]
    return {
        node: None
        for node, box in props.items()
        if box.z > _LIFTED and any(_carries(base, box) for base in gone) and not any(_carries(b, box) for b in stays)
    }


def _carries(base: Box, box: Box) -> bool:
    """Return whether a box is on or in another."""
    return base is not box and base.z < box.z < base.top + _LIFTED and distance_to_point(base, box.x, box.y) < 0


def _box_of(piece: Piece) -> Box | None:
    """Return the box of a piece of the set up to 4 m; None if it has no outline."""
    if piece.footprint is None:
        return None
    width, depth = (size * piece.scale for size in piece.footprint)
    return Box(*piece.location, width, depth, 4.0, math.radians(piece.yaw))


def _move_into_room(plan: SetPlan, target: Floats) -> Floats:
    """Return a target that is just inside a wall, moved into the room: a head bowed at a wall does not open it."""
    if not plan.indoor:
        return target
    size = plan.size
    low, high = (size.x_negative + _SKIN, size.y_negative + _SKIN), (size.x - _SKIN, size.y - _SKIN)
    spot = np.array([*np.clip(target[:2], low, high), target[2]])
    return spot if math.dist(spot, target) < _HALF_HEAD else target


def _is_in_room(plan: SetPlan, point: Floats) -> bool:
    """Return whether a world point is on the set; always true outdoors."""
    size = plan.size
    return not plan.indoor or (size.x_negative < point[0] < size.x and size.y_negative < point[1] < size.y)


def _frame_points(camera: Orbit) -> list[Floats]:
    """Return (3,) points of the picture at nine tenths of the way to the pivot: middle, and half-way to its corners."""
    axes, height = camera.axes, camera.frame_height
    middle = np.asarray(camera.pivot) + axes[:, 2] * camera.distance * 0.1
    spread = [(0.0, 0.0), (0.4, 0.3), (-0.4, 0.3), (0.4, -0.3), (-0.4, -0.3)]
    return [middle + axes[:, 0] * x * height * camera.aspect + axes[:, 1] * y * height for x, y in spread]


def _stands_between(wall: Wall, eye: Floats, sights: Sequence[Floats]) -> bool:
    """Return whether a wall hides a sight from the eye, or the camera would touch it."""
    start, along, inward, length = wall_frame(wall)
    out = float((eye[:2] - start) @ inward)
    beside = float((eye[:2] - start) @ along)
    if abs(out) < _CLOSE and -_CLOSE < beside < length + _CLOSE:
        return True
    return any(_crosses_wall(wall, eye, sight) for sight in sights)


def _crosses_wall(wall: Wall, eye: Floats, sight: Floats) -> bool:
    """Return whether the line from the eye to a sight meets the wall, not one of its openings."""
    start, along, inward, length = wall_frame(wall)
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


def _is_hidden_with_wall(box: Box, wall: Wall, eye: Floats, sights: Sequence[Floats]) -> bool:
    """Return whether a thing hangs on a hidden wall, or stands at it and is tall or in the camera's way."""
    start, along, inward, length = wall_frame(wall)
    centre = np.array([box.x, box.y])
    depth = abs(float((centre - start) @ inward)) - box.reach((float(inward[0]), float(inward[1])))
    x = float((centre - start) @ along)
    if depth > _ON_WALL or not -0.2 < x < length + 0.2:
        return False
    return box.z > _HUNG or (depth < _FLUSH and box.top > _TALL) or _blocks_sight(box, eye, sights)


def _is_built_on(piece: Piece, wall: Wall) -> bool:
    """Return whether a piece of the set is built against a wall, such as a mirror or a fireplace."""
    start, along, inward, length = wall_frame(wall)
    off = np.array(piece.location[:2]) - start
    away = abs(float(off @ inward))
    return away < _FLUSH and 0 < float(off @ along) < length


def _blocks_sight(box: Box, eye: Floats, sights: Sequence[Floats]) -> bool:
    """Return whether a box hides any of the sights from the eye."""
    return bool(sights) and bool(hidden_from([box], eye, np.array(sights), _AT_TARGET).any())
