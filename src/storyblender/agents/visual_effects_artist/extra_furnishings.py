"""Places for props that a set gets beyond its plan: on, beside and before furniture, at walls, never in the way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, Literal, NamedTuple

import numpy as np

from storyblender.catalog.footprints import piece_boxes, stage_box, wall_boxes
from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.belongings import SURFACES
from storyblender.geometry.boxes import Box, distance_to_point, penetration, yaw_along
from storyblender.memory.base import Vec2, Vec3

At = Literal["on", "next_to", "in_front_of", "behind", "against_wall", "on_wall", "on_floor"]
"""Where a prop is put: by another one, with its back to a wall, hung on a wall, or free on the floor."""
PictureSide = Literal["left", "right", "front", "back"]
"""A side of the set as the audience sees it."""

TOPS: Final = frozenset({*SURFACES, "bar_counter", "crate", "barrel"})
"""Props whose whole upper side bears small things."""
_BESIDE: Final[dict[str, tuple[Vec2, ...]]] = {
    "next_to": ((1.0, 0.0), (-1.0, 0.0)), "in_front_of": ((0.0, -1.0),), "behind": ((0.0, 1.0),),
}  # fmt: skip
"""Directions from a thing in its own frame; its front is at -y."""
_GAPS = (0.05, 0.25, 0.5)
"""Metres between a prop and what it stands beside, in order of preference."""
_EYE = 1.5
"""Metres from the floor to the middle of what hangs on a wall."""
_LANE, _MARK = 0.5, 0.55
"""Metres that stay free on each side of the ways from the entrances to the middle, and around marks."""
_GRID = 0.3
"""Metres between the places that are tried."""
_ASIDE, _OUTWARD = 0.15, 0.03
"""Cost of a metre away from the wanted side (places at the back are seen best), and of one away from the middle."""


class Standing(NamedTuple):
    """What is in a set already: its prop and its box."""

    prop: str
    box: Box


def find_place(
    plan: SetPlan, standing: dict[str, Standing], prop: str, at: At, anchor: str | None, side: PictureSide | None
) -> tuple[Vec3, float] | None:
    """Return the bottom centre in metres and the yaw in degrees of a prop that is added; None if there is no room.

    Args:
        plan: The set.
        standing: What is in it already, by node id.
        prop: Catalog key.
        at: Where it is put.
        anchor: Node id of what it is put by.
        side: Wanted side of the set.
    """
    size = PROPS[prop].size
    base = standing.get(anchor or "")
    if at == "on":
        places = _on_top(base, size) if base is not None and base.prop in TOPS else iter(())
    elif at in ("against_wall", "on_wall"):
        places = _along_walls(plan, size, hung=at == "on_wall")
    elif at == "on_floor" or base is None:
        places = _on_floor(plan, size)
    else:
        places = _beside(base.box, size, _BESIDE[at])
    blocked = [each.box for each in standing.values() if each.box.height > 0.05]
    free = [box for box in places if _is_free(box, plan, blocked, on_floor=at not in ("on", "on_wall"))]
    near = base.box if base is not None else None
    best = min(free, key=lambda box: round(_cost(box, near, side), 4), default=None)
    if best is None:
        return None
    location = (round(best.x, 3), round(best.y, 3), round(best.z, 3))
    return location, round(math.degrees(best.yaw), 1)


def _on_top(base: Standing, size: Vec3) -> Iterator[Box]:
    """Yield boxes on top of a thing, from its middle outwards, turned as it is."""
    under = base.box
    wide, deep = (under.width - size[0]) / 2, (under.depth - size[1]) / 2
    if wide < 0 or deep < 0:
        return
    for across in (0.0, -0.5, 0.5, -0.9, 0.9):
        for along in (0.0, 0.6, -0.6):
            x, y = under.to_world(across * wide, along * deep)
            yield Box(x, y, under.top, *size, under.yaw)


def _beside(anchor: Box, size: Vec3, directions: Sequence[Vec2]) -> Iterator[Box]:
    """Yield boxes on the floor beside a thing, turned as it is."""
    for gap in _GAPS:
        for dx, dy in directions:
            x = dx * ((anchor.width + size[0]) / 2 + gap)
            y = dy * ((anchor.depth + size[1]) / 2 + gap)
            yield Box(*anchor.to_world(x, y), 0.0, *size, anchor.yaw)


def _along_walls(plan: SetPlan, size: Vec3, *, hung: bool) -> Iterator[Box]:
    """Yield boxes with their backs to the walls, between openings; ``hung`` at the height of eyes."""
    low = max(0.0, _EYE - size[2] / 2) if hung else 0.0
    for wall in plan.walls:
        length = math.dist(wall.start, wall.end)
        if wall.missing or wall.base > 0.1 or low + size[2] > wall.height:
            continue
        along = np.subtract(wall.end, wall.start) / length
        inward = np.array([-along[1], along[0]])
        for at in np.arange(size[0] / 2 + 0.05, length - size[0] / 2, _GRID):
            reached = (hole for hole in wall.openings if hole.sill < low + size[2] and hole.sill + hole.height > low)
            margin = size[0] / 2 + 0.1
            if any(hole.x - margin < at < hole.x + hole.width + margin for hole in reached):
                continue
            x, y = np.array(wall.start) + along * at + inward * (size[1] / 2 + (0.005 if hung else 0.03))
            yield Box(float(x), float(y), low, *size, yaw_along(*inward))


def _on_floor(plan: SetPlan, size: Vec3) -> Iterator[Box]:
    """Yield boxes all over the playing area."""
    area = plan.size
    for x in np.arange(area.x_negative + size[0] / 2, area.x - size[0] / 2, _GRID):
        for y in np.arange(area.y_negative + size[1] / 2, area.y - size[1] / 2, _GRID):
            yield Box(float(x), float(y), 0.0, *size, 0.0)


def _is_free(box: Box, plan: SetPlan, blocked: Sequence[Box], *, on_floor: bool) -> bool:
    """Return whether nothing is in a box, and, if it is on the floor, nobody acts or walks there."""
    area = plan.size
    if not (area.x_negative <= box.x <= area.x and area.y_negative <= box.y <= area.y):
        return False
    if any(penetration(box, other, 0.02)[0] > 0.0 for other in blocked):
        return False
    if not on_floor:
        return True
    stage = stage_box(plan)
    fixed = [*(each for piece in plan.pieces for each in piece_boxes(piece)), stage]
    fixed += [each for wall in plan.walls for each in wall_boxes(wall)]
    if any(penetration(box, other, 0.02)[0] > 0.0 for other in fixed):
        return False
    if any(distance_to_point(box, *mark.location[:2]) < _MARK for mark in plan.marks):
        return False
    ways = (mark.location[:2] for mark in plan.marks if {"enter", "exit"} & {*mark.tags})
    return not any(_is_in_lane(box, start, (stage.x, stage.y)) for start in ways)


def _is_in_lane(box: Box, start: Vec2, end: Vec2) -> bool:
    """Return whether a box stands in the straight way between two floor points."""
    steps = np.linspace(start, end, max(2, math.ceil(math.dist(start, end) / 0.2)))
    return any(distance_to_point(box, float(x), float(y)) < _LANE for x, y in steps)


def _cost(box: Box, near: Box | None, side: PictureSide | None) -> float:
    """Return how far a place is from where it is wanted, in metres; of equal ones the middle is best."""
    toward = {"left": box.x, "right": -box.x, "front": box.y, "back": -box.y, None: -0.2 * box.y}[side]
    away = math.dist((box.x, box.y), (near.x, near.y)) if near is not None else _OUTWARD * math.hypot(box.x, box.y)
    return _ASIDE * toward + away
