"""Ways over things: a leap or climb across a fence or a cart, and boarding a boat."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from storyblender.agents.visual_effects_artist.floor import BODY, Floor
from storyblender.agents.visual_effects_artist.placed_objects import PlacedObject, SeatPlace
from storyblender.geometry.paths import Vec2
from storyblender.memory.base import Vec3

MAX_CROSSED_HEIGHT = 1.45
"""Metres of height above which a thing is not crossed."""
MAX_CROSSED_DEPTH = 1.7
"""Metres of depth above which a thing is not crossed."""
TAKE_OFF, LANDING = 0.40, 0.45
"""Metres in front of and behind the thing, times stature over 1.7."""
QUAY_GAP = 0.6
"""Metres from a boat to a person on the quay, times stature over 1.7, if the boat lies a step away."""
GUNWALE = 0.30
"""Least metres from a vessel's side to its seats; the seats of a bench are at its edge."""


@dataclass(frozen=True)
class Crossing:
    """A straight way over a thing.

    Attributes:
        near: Floor point where it begins.
        far: Floor point where it ends.
    """

    near: Vec2
    far: Vec2

    @property
    def back(self) -> Crossing:
        """The same way in the other direction."""
        return Crossing(self.far, self.near)


def find_crossing(
    floor: Floor, thing: PlacedObject, place: Vec2, scale: float, others: Sequence[Vec2] = ()
) -> Crossing | None:
    """Return the best way for a person over a thing; None if it is too large or no way is free.

    Args:
        floor: Everything on the floor.
        thing: The thing to cross.
        place: Floor point of the person.
        scale: Stature over 1.7 m.
        others: Floor points of other people.
    """
    if thing.location[2] + thing.size[2] > MAX_CROSSED_HEIGHT:
        return None
    found = [way for way in _list_crossings(thing, place, scale) if _is_crossing_free(floor, way, scale, others)]
    found.sort(key=lambda way: math.dist(place, way.near) + 2 * math.dist(way.near, way.far))
    return next((way for way in found[:4] if floor.path(place, way.near, scale) is not None), None)


def _list_crossings(thing: PlacedObject, place: Vec2, scale: float) -> Iterator[Crossing]:
    """Yield ways over the width and the depth of a thing, from the person's side and near them."""
    here = thing.to_local(place)
    for axis in (0, 1):
        half, length = thing.size[axis] / 2, max(0.0, thing.size[1 - axis] / 2 - 0.3)
        if 2 * half > MAX_CROSSED_DEPTH:
            continue
        side = 1.0 if here[axis] >= 0 else -1.0
        for slide in (0.0, 0.5, -0.5, 1.0, -1.0):
            along = max(-length, min(length, here[1 - axis] + slide))
            ends = (side * (half + TAKE_OFF * scale), -side * (half + LANDING * scale))
            near, far = (thing.to_world((end, along, 0.0) if axis == 0 else (along, end, 0.0))[:2] for end in ends)
            yield Crossing(near, far)


def _is_crossing_free(floor: Floor, way: Crossing, scale: float, others: Sequence[Vec2]) -> bool:
    """Tell whether both ends of a way are inside the playing area and clear of things and people."""
    return all(
        floor.inside(spot)
        and floor.room_at(spot) > 0.8 * BODY * scale
        and all(math.dist(spot, p) > 0.5 for p in others)
        for spot in (way.near, way.far)
    )


def is_vessel(thing: PlacedObject) -> bool:
    """Tell whether people step into a thing to sit in it: its seats are well inside its low sides."""
    half = thing.size[0] / 2, thing.size[1] / 2
    seats = thing.anchors_of("seat")
    inside = (abs(s.location[axis]) < half[axis] - GUNWALE for s in seats for axis in (0, 1))
    return bool(seats) and min(half) > 0.5 and thing.size[2] < MAX_CROSSED_HEIGHT and all(inside)


def vessel_at(floor: Floor, place: Vec2) -> PlacedObject | None:
    """Return the boat on a floor that contains a floor point (metres in the set); None if there is none."""
    for thing in floor.things.values():
        x, y = thing.to_local(place)
        if abs(x) < thing.size[0] / 2 and abs(y) < thing.size[1] / 2 and is_vessel(thing):
            return thing
    return None


def find_boarding_way(floor: Floor, vessel: PlacedObject, inside: Vec2, outside: Vec2, scale: float) -> Crossing | None:
    """Return the way over a vessel's side to a place in it; None if no side can be reached.

    Args:
        floor: Everything on the floor.
        vessel: The boat.
        inside: Floor point of the place in it.
        outside: Floor point of the person before boarding or after leaving.
        scale: Stature over 1.7 m.
    """
    x, y = vessel.to_local(inside)
    sides: list[Vec3] = []
    for off in (TAKE_OFF * scale, QUAY_GAP * scale):
        sides += [(way * (vessel.size[0] / 2 + off), y, 0.0) for way in (1, -1)]
        sides += [(x, way * (vessel.size[1] / 2 + off), 0.0) for way in (1, -1)]
    ways = [Crossing(vessel.to_world(side)[:2], inside) for side in sides]
    ways = [way for way in ways if floor.room_at(way.near) > 0.8 * BODY * scale and floor.inside(way.near)]
    ways.sort(key=lambda way: math.dist(outside, way.near) + 2 * math.dist(way.near, way.far))
    return next((way for way in ways if floor.path(outside, way.near, scale) is not None), None)


def is_seat_in_vessel(floor: Floor, seat: SeatPlace) -> bool:
    """Tell whether a seat of a thing on the floor is in a vessel."""
    return is_vessel(floor.things[seat.node_id])
