"""Walkways that must stay open: from the door to a mark, from mark to mark, wide enough for a person."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from storyblender.geometry.boxes import Box, yaw_along
from storyblender.geometry.paths import Footprint, Vec2, find_path
from storyblender.geometry.relations import LayoutThing, PlayingArea, may_overlap_anchor

WALKWAY_WIDTH = 0.7
"""Metres that a walking person needs between things."""
_LANE_MARGIN = 0.06
"""Metres that a lane is wider: the solver may leave two hundredths of a thing on either side."""
_STEP_HEIGHT = 0.05
"""Things lower than this are walked on."""
_HEAD_ROOM = 1.9
"""Things that hang higher than this are walked under."""
_OPEN_ENDS = 0.45
"""Metres at both ends of a walkway where a person may squeeze in, between chair and table."""


def find_walkway(
    start: Vec2,
    goal: Vec2,
    things: Sequence[LayoutThing],
    room: PlayingArea,
    *,
    width: float = WALKWAY_WIDTH,
    around_fixed_only: bool = False,
) -> list[Vec2] | None:
    """Return the way points of a walk between two floor points, or None if it is blocked.

    Args:
        start: World x and y, metres.
        goal: World x and y, metres.
        things: The layout; people are walked past, not around.
        room: The playing area.
        width: Metres between things that it needs.
        around_fixed_only: Walk through what the solver may move: the way that should be opened.
    """
    obstacles = [
        Footprint((thing.box.x, thing.box.y), (thing.box.width, thing.box.depth), thing.box.yaw, name=thing.name)
        for thing in things
        if blocks_walkers(thing) and (thing.fixed or not around_fixed_only)
    ]
    bounds = (room.x_min, room.y_min, room.x_max, room.y_max)
    return find_path(start, goal, obstacles, bounds, width / 2)


def blocks_walkers(thing: LayoutThing) -> bool:
    """Return whether people have to walk around a thing."""
    box = thing.box
    return not thing.walks and not may_overlap_anchor(thing) and box.top > _STEP_HEIGHT and box.z < _HEAD_ROOM


def lane_boxes(points: Sequence[Vec2]) -> list[Box]:
    """Return the boxes of air that keep a walk open, without its two ends; ``points`` are world x and y in metres."""
    volumes: list[Box] = []
    along, total = 0.0, sum(math.dist(a, b) for a, b in itertools.pairwise(points))
    for a, b in itertools.pairwise(points):
        length = math.dist(a, b)
        first = max(_OPEN_ENDS - along, 0.0)
        last = min(total - _OPEN_ENDS - along, length)
        along += length
        if last - first < 1e-3:
            continue
        dx, dy = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        middle = (first + last) / 2
        x, y = a[0] + dx * middle, a[1] + dy * middle
        volumes.append(
            Box(
                x,
                y,
                _STEP_HEIGHT,
                WALKWAY_WIDTH + _LANE_MARGIN,
                last - first,
                _HEAD_ROOM - _STEP_HEIGHT,
                yaw_along(dx, dy),
            )
        )
    return volumes
