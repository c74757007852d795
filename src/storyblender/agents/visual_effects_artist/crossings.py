"""Over things: where one leaps or climbs across a fence or a cart, and how one comes aboard a boat. Pure."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from storyblender.agents.visual_effects_artist.floor import BODY, Floor
from storyblender.agents.visual_effects_artist.placed_things import SeatPlace, Thing
from storyblender.geometry.paths import Vec2
from storyblender.memory.base import Vec3

HIGHEST = 1.45
"""Metres: what is higher is climbed up, not over."""
DEEPEST = 1.7
"""Metres of the thing under a leap."""
TAKE_OFF, LANDING = 0.40, 0.45
"""Metres before and behind the thing, times stature over 1.7."""
FROM_QUAY = 0.6
"""Metres, times the same, from a boat that lies a step off the quay to who comes aboard."""
GUNWALE = 0.30
"""Metres from a vessel's side to its seats; a bench's seats are at its edge."""


@dataclass(frozen=True)
class Crossing:
    """A way straight over a thing.

    Attributes:
        near: Where it begins.
        far: Where it ends.
    """

    near: Vec2
    far: Vec2

    @property
    def back(self) -> Crossing:
        """The same the other way."""
        return Crossing(self.far, self.near)


def across(floor: Floor, thing: Thing, place: Vec2, scale: float, others: Sequence[Vec2] = ()) -> Crossing | None:
    """Return the best way over a thing for somebody at ``place``; None for what nobody gets over."""
    if thing.location[2] + thing.size[2] > HIGHEST:
        return None
    found = [way for way in _ways_over(thing, place, scale) if _free(floor, way, scale, others)]
    found.sort(key=lambda way: math.dist(place, way.near) + 2 * math.dist(way.near, way.far))
    return next((way for way in found[:4] if floor.path(place, way.near, scale) is not None), None)


def _ways_over(thing: Thing, place: Vec2, scale: float) -> Iterator[Crossing]:
    """Over both extents, from the person's side, at the places along the thing that are near."""
    here = thing.local(place)
    for axis in (0, 1):
        half, length = thing.size[axis] / 2, max(0.0, thing.size[1 - axis] / 2 - 0.3)
        if 2 * half > DEEPEST:
            continue
        side = 1.0 if here[axis] >= 0 else -1.0
        for slide in (0.0, 0.5, -0.5, 1.0, -1.0):
            along = max(-length, min(length, here[1 - axis] + slide))
            ends = (side * (half + TAKE_OFF * scale), -side * (half + LANDING * scale))
            near, far = (thing.world((end, along, 0.0) if axis == 0 else (along, end, 0.0))[:2] for end in ends)
            yield Crossing(near, far)


def _free(floor: Floor, way: Crossing, scale: float, others: Sequence[Vec2]) -> bool:
    return all(
        floor.inside(spot)
        and floor.room_at(spot) > 0.8 * BODY * scale
        and all(math.dist(spot, p) > 0.5 for p in others)
        for spot in (way.near, way.far)
    )


def is_vessel(thing: Thing) -> bool:
    """Tell whether one steps into a thing to sit in it: its seats are well inside its low sides."""
    half = thing.size[0] / 2, thing.size[1] / 2
    seats = thing.of_kind("seat")
    inside = (abs(s.location[axis]) < half[axis] - GUNWALE for s in seats for axis in (0, 1))
    return bool(seats) and min(half) > 0.5 and thing.size[2] < HIGHEST and all(inside)


def vessel_at(floor: Floor, place: Vec2) -> Thing | None:
    """Return the boat a place is in."""
    for thing in floor.things.values():
        x, y = thing.local(place)
        if abs(x) < thing.size[0] / 2 and abs(y) < thing.size[1] / 2 and is_vessel(thing):
            return thing
    return None


def aboard(floor: Floor, vessel: Thing, inside: Vec2, outside: Vec2, scale: float) -> Crossing | None:
    """Return the way over a vessel's side to a place in it, on the side that is nearer to ``outside`` and free."""
    x, y = vessel.local(inside)
    sides: list[Vec3] = []
    for off in (TAKE_OFF * scale, FROM_QUAY * scale):
        sides += [(way * (vessel.size[0] / 2 + off), y, 0.0) for way in (1, -1)]
        sides += [(x, way * (vessel.size[1] / 2 + off), 0.0) for way in (1, -1)]
    ways = [Crossing(vessel.world(side)[:2], inside) for side in sides]
    ways = [way for way in ways if floor.room_at(way.near) > 0.8 * BODY * scale and floor.inside(way.near)]
    ways.sort(key=lambda way: math.dist(outside, way.near) + 2 * math.dist(way.near, way.far))
    return next((way for way in ways if floor.path(outside, way.near, scale) is not None), None)


def seat_aboard(floor: Floor, seat: SeatPlace) -> bool:
    """Tell whether a seat is in a vessel."""
    return is_vessel(floor.things[seat.node_id])
