"""Places a crowd: on free seats if the set has them, else in small groups around the principals."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.people_seats import free_seats, put_on_seat
from storyblender.catalog.props.prop_families import family_of
from storyblender.geometry.boxes import yaw_along
from storyblender.geometry.relations import LayoutThing
from storyblender.geometry.stations import turn_towards_audience
from storyblender.memory.base import Vec2

CROWD = 4
"""Number of members from which a group is a crowd."""
_SIZES = (3, 2, 4, 2, 3)
"""Sizes of the small groups, in turn."""
_RADIUS = {1: 0.0, 2: 0.5, 3: 0.6, 4: 0.75}
"""Metres from the middle of a small group to its members, by group size."""
_NEAR, _FAR = 1.9, 5.5
"""Metres from the principals: least distance, and distance from which a crowd is hardly visible."""
_LANE = 1.1
"""Metres that a crowd leaves open on either side of the line from a principal to the audience."""
_SITTING = 0.6
"""Share of a crowd that sits if there are seats."""
_GRID = 0.35
_SEATS = family_of("chair") | family_of("bench") | family_of("sofa") | family_of("armchair") | {"bar_stool"}
"""Props that any member of a crowd may sit on."""


def crowds_of(people: Sequence[str]) -> list[list[str]]:
    """Return the groups of at least ``CROWD`` asset ids that differ in a number only: ``guest_1`` to ``guest_12``."""
    stems: dict[str, list[str]] = {}
    for person in people:
        stem, _, number = person.rpartition("_")
        if stem and number.isdigit():
            stems.setdefault(stem, []).append(person)
    return [members for members in stems.values() if len(members) >= CROWD]


def place_crowd(stage: LayoutStage, members: Sequence[str]) -> None:
    """Place the members of a crowd who have no place of their own.

    Args:
        stage: The stage with the principals in their places; changed.
        members: Asset ids of the crowd, in order.
    """
    waiting = [member for member in members if member not in stage.things]
    principals = [thing for thing in stage.things.values() if thing.walks]
    spots = [(thing.box.x, thing.box.y) for thing in principals] or [stage.middle]
    seats = [
        seat
        for seat in free_seats(stage)
        if _leaves_view_free(stage.things[seat[0]].box.to_world(*seat[1].location[:2]), spots)
    ]
    seats.sort(key=lambda seat: round(min(math.dist(stage.things[seat[0]].box.to_world(*seat[1].location[:2]), s)
                                          for s in spots), 2))  # fmt: skip
    for member, seat in zip(waiting[: round(_SITTING * len(waiting))], seats, strict=False):
        put_on_seat(stage, member, seat)
    waiting = [member for member in waiting if member not in stage.things]
    turn = 0
    while waiting:
        count = min(_SIZES[turn % len(_SIZES)], len(waiting))
        group, waiting = waiting[:count], waiting[count:]
        _place_ring(stage, group, spots, turn)
        turn += 1


def is_public_seat(stage: LayoutStage, name: str) -> bool:
    """Return whether a placed thing is a seat for anyone: not a throne or a place of work.

    Args:
        stage: What stands in the set; not changed.
        name: node_id of a thing on the stage.
    """
    return stage.view.props.get(stage.assets[name]) in _SEATS


def _leaves_view_free(point: Vec2, principals: Sequence[Vec2]) -> bool:
    """Return whether a floor point leaves the audience's view of the principals free."""
    return all(abs(point[0] - x) > _LANE or point[1] > y - 0.3 for x, y in principals)


def _place_ring(stage: LayoutStage, group: Sequence[str], principals: Sequence[Vec2], turn: int) -> None:
    """Place a small group in a ring: near the principals, but not among them or in front of them."""
    radius = _RADIUS[len(group)]
    x0, y0, x1, y1 = stage.room.x_min, stage.room.y_min, stage.room.x_max, stage.room.y_max
    xs, ys = np.arange(x0 + 0.4, x1 - 0.4, _GRID), np.arange(y0 + 0.4, y1 - 0.4, _GRID)
    points = np.array([(x, y) for x in xs for y in ys])
    free = stage.clearance(points)
    away = np.min([np.hypot(points[:, 0] - x, points[:, 1] - y) for x, y in principals], axis=0)
    cost = 6 * np.maximum(radius + 0.35 - free, 0) + 3 * np.maximum(_NEAR + radius - away, 0)
    cost += 0.5 * np.maximum(away - _FAR, 0) + 0.08 * away
    for x, y in principals:
        before = (np.abs(points[:, 0] - x) < _LANE + radius) & (points[:, 1] < y - 0.2)
        cost += 2.5 * before
    cost += 0.3 * np.abs(np.sin(1.7 * turn + 2.1 * points[:, 0]))  # spreads the groups
    x, y = (float(value) for value in points[int(np.argmin(np.round(cost, 4)))])
    first = 0.9 * turn
    for index, member in enumerate(group):
        angle = first + 2 * math.pi * index / len(group)
        px, py = x + radius * math.cos(angle), y + radius * math.sin(angle)
        yaw = (
            turn_towards_audience(yaw_along(x - px, y - py))
            if len(group) > 1
            else yaw_along(principals[0][0] - px, principals[0][1] - py)
        )
        stage.add(LayoutThing(member, stage.box(member, px, py, 0.0, yaw), walks=True), member)
