"""Stations: positions and facing of a person at, behind, beside or in front of an anchor. Pure.

A relation to an anchor gives a few candidate places, each with a cost. The caller adds the costs that depend on the
room: clearance, other people, the path. The audience sits at -Y.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

from storyblender.geometry.boxes import Box, wrap_angle, yaw_along

Sort = Literal["thing", "person", "door", "window", "wall", "point"]
"""Type of the anchor. A point is a named place of the set or a corner; people stand on it."""

REACH = 0.28
"""Metres from the edge of an object to the centre of a person who works at it, times stature over 1.7."""
BEFORE = 0.75
"""Metres from the edge of an object to a person in front of it."""
ASIDE = 0.42
"""Metres from the edge of an object to a person beside it."""
WATCH = 1.1
"""Metres from the edge of an object to a person looking at it."""
TALK = 1.15
"""Metres between people who talk."""
SHOULDER = 0.62
"""Metres between people side by side."""
TAIL = 0.85
"""Metres between people behind one another."""
_SLOT = 0.75
"""Metres between neighbouring places along one side of an object."""
_CHEAT = math.radians(20)
"""Radians that a body cheats out: turns from its subject towards the audience so that the face is visible."""
_BACK_TO_US = 0.3
"""Cost, in metres, of standing with the back to the audience."""
_DOOR_STEP = 0.1
"""Metres from the face of the wall into the room for a person in a doorway."""
_AWAY_FROM_SIDE = 1.2
"""Cost, in metres, of the sides of an object where its user is not expected."""

TURNS = {
    "front": 0.0, "left": math.pi / 2, "right": -math.pi / 2, "back": math.pi,
    "driver": math.pi / 2, "passenger": -math.pi / 2, "rear": math.pi,
}  # fmt: skip
"""Radians from a thing's front to its sides, its own left and right; a driver sits on the left."""
_OTHER_HALF = 0.6
"""Cost, in metres, of the half of a side that was not asked for: behind the car, driver's side."""
_SIDES_OF_RELATION: dict[str, tuple[str, ...]] = {
    "in_front_of": ("front",),
    "facing": ("front",),
    "behind": ("back",),
    "next_to": ("left", "right", "front", "back"),
    "against": ("front", "left", "right", "back"),
    "at": ("front", "left", "right", "back"),
}


@dataclass(frozen=True)
class Station:
    """A candidate place for a person.

    Attributes:
        x: World x, metres.
        y: World y, metres.
        yaw: Radians, counter-clockwise; 0 faces -Y, the audience.
        dislike: Cost, as the metres of detour that are worth avoiding this place.
        z: Height of the feet above the floor, metres.
    """

    x: float
    y: float
    yaw: float
    dislike: float = 0.0
    z: float = 0.0


def stations(
    anchor: Box, sort: Sort, relation: str, side: str | None = None, distance: float | None = None, k: float = 1.0
) -> list[Station]:
    """Return the candidate places of a person in a relation to an anchor, the likeliest first.

    Args:
        anchor: Box of the anchor; its front is the side of its user.
        sort: Type of the anchor.
        relation: A ``RelationKind``.
        side: ``front``, ``back``, ``left``, ``right`` from the anchor's own point of view; ``driver``, ``passenger`` or
            ``rear`` of a vehicle.
        distance: Metres from the anchor's edge, or from the middle of a person; None chooses.
        k: Stature over 1.7.
    """
    if relation in ("on", "above"):
        return [Station(anchor.x, anchor.y, 0.0, z=max(anchor.top, 0.0) if sort != "point" else 0.0)]
    if relation in ("in", "inside", "aboard") and sort == "door":
        return [Station(*anchor.to_world(0.0, -_DOOR_STEP), anchor.yaw)]
    if sort == "point" or relation in ("in", "inside", "aboard", "under"):
        return [Station(anchor.x, anchor.y, anchor.yaw)]
    if sort == "person":
        return list(_by_person(anchor, relation, side, distance))
    if sort in ("door", "window"):
        return list(_by_opening(anchor, sort, relation, side, distance))
    if relation in ("left_of", "right_of"):
        angle = math.pi if relation == "left_of" else 0.0
        return list(_along(anchor, relation, angle, distance, k, 0.0))
    front = math.atan2(anchor.forward[1], anchor.forward[0])
    found: list[Station] = []
    names = _SIDES_OF_RELATION.get(relation, _SIDES_OF_RELATION["at"])
    lengthwise = relation in ("behind", "in_front_of") and side not in (None, "front", "back", "rear")
    names = (side,) if side in TURNS and not lengthwise else names
    aside = math.copysign(1.0, TURNS[side]) if lengthwise and side in TURNS else 0.0
    for order, name in enumerate(names):
        if sort == "wall" and name != "front":
            continue
        equal = relation == "next_to" and name in ("left", "right")
        dislike = 0.0 if order == 0 or equal else _AWAY_FROM_SIDE * (1.0 if name != "back" else 1.6)
        places = list(_along(anchor, relation, front + TURNS[name], distance, k, dislike, bool(aside)))
        found += [_on_half(anchor, place, aside) for place in places] if aside else places
    return found


def _on_half(anchor: Box, place: Station, aside: float) -> Station:
    """Return a station, with a cost if it is not on the given half of an object: ``aside`` 1 is its own left."""
    across = anchor.to_local(place.x, place.y)[0] * aside
    return replace(place, dislike=place.dislike + _OTHER_HALF * (across <= 0.1))


def turn_towards_audience(yaw: float, most: float = _CHEAT) -> float:
    """Return a yaw (radians, 0 faces the audience at -Y) turned towards the audience by at most ``most`` radians."""
    yaw = wrap_angle(yaw)
    return yaw - max(-most, min(most, yaw))


def back_to_audience(yaw: float) -> float:
    """Return the share of the back that the audience sees: 0 from front to profile, 1 from behind; yaw in radians."""
    return max(0.0, -math.cos(yaw))


def _along(
    anchor: Box,
    relation: str,
    angle: float,
    distance: float | None,
    k: float,
    dislike: float,
    halves: bool = False,
) -> Iterator[Station]:
    """Yield places for a person along one side of an object, its middle first.

    Args:
        anchor: Box of the object.
        relation: Of the person to the object, such as ``next_to``.
        angle: Direction of the side from the object's centre, radians, 0 at +X.
        distance: Metres between person and object; None for the usual distance of the relation.
        k: Stature of the person over 1.7 m; the usual distances are multiplied by it.
        dislike: Cost that every place of this side starts with.
        halves: Whether places near the middle, left and right of it, come before the ends.
    """
    out, along = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    gap = {"next_to": ASIDE, "left_of": ASIDE, "right_of": ASIDE, "in_front_of": BEFORE, "facing": WATCH}
    usual = gap.get(relation, REACH) * k
    off = anchor.reach(out) + (usual if distance is None else max(distance, REACH * k))
    half = max(anchor.reach(along) - 0.3, 0.0)
    slots = [0.0, *((0.45, -0.45) if halves else ())]
    for step in range(1, int(half / _SLOT) + 1):
        slots += [step * _SLOT, -step * _SLOT]
    inward = yaw_along(-out[0], -out[1])
    for slot in slots:
        x, y = anchor.x + out[0] * off + along[0] * slot, anchor.y + out[1] * off + along[1] * slot
        yaw = inward
        if relation in ("next_to", "left_of", "right_of"):
            yaw = turn_towards_audience(yaw_along(0.0 - 0.25 * out[0], -1.0))
        elif relation == "against":
            yaw = inward + math.pi
        yield Station(x, y, yaw, dislike + 0.15 * abs(slot) + _BACK_TO_US * back_to_audience(yaw))


def _by_person(other: Box, relation: str, side: str | None, distance: float | None) -> Iterator[Station]:
    """Yield places near a person: facing them to talk, at their shoulder, behind their back."""
    turn = TURNS.get(side or "")
    ahead = math.atan2(other.forward[1], other.forward[0])
    if relation in ("left_of", "right_of"):
        reach = distance or SHOULDER
        step = -reach if relation == "left_of" else reach
        yield Station(other.x + step, other.y, other.yaw)
        return
    if relation == "behind":
        reach, spread, middle, look = distance or TAIL, (0, 20, -20, 40, -40), ahead + math.pi, "same"
    elif relation in ("next_to", "against"):
        reach, spread, look = distance or SHOULDER, (0, 15, -15, 30, -30), "same"
        middle = ahead + (turn if turn is not None else math.pi / 2)
    else:
        reach, middle, look = distance or TALK, ahead, "at"
        spread = (0, 20, -20, 40, -40, 60, -60, 80, -80, 110, -110)
    if turn is not None:
        middle = ahead + turn
    both = relation == "next_to" and turn is None
    for flip in (0.0, math.pi) if both else (0.0,):
        for degrees in spread:
            angle = middle + flip + math.radians(degrees)
            x, y = other.x + reach * math.cos(angle), other.y + reach * math.sin(angle)
            yaw = other.yaw if look == "same" else turn_towards_audience(yaw_along(other.x - x, other.y - y))
            in_line = max(0.0, abs(math.sin(angle)) - 0.5)  # one person would hide the other
            yield Station(x, y, yaw, abs(degrees) / 120 + in_line + _BACK_TO_US * back_to_audience(yaw))


def _by_opening(opening: Box, sort: Sort, relation: str, side: str | None, distance: float | None) -> Iterator[Station]:
    """Yield places at a door or window: beside it, to keep the view free, or in front of it if asked for."""
    off = distance if distance is not None else 0.45
    half = opening.width / 2
    if relation in ("in_front_of", "facing", "behind"):
        out = -max(off, 0.4) if relation == "behind" else max(off, 0.55)
        for aside in {"left": (0.6, 0.9), "right": (-0.6, -0.9)}.get(side or "", (0.0, 0.35, -0.35, 0.7, -0.7)):
            x, y = opening.to_world(aside, -out)
            look = opening.to_world(aside * 0.3, 0.0)
            yield Station(
                x, y, turn_towards_audience(yaw_along(look[0] - x, look[1] - y)), 0.4 * abs(aside) * (side is None)
            )
        return
    for aside in (0.55 * half, -0.55 * half, half + 0.2, -half - 0.2, 0.0):
        x, y = opening.to_world(aside, -off - (0.15 if sort == "door" else 0.0))
        look = opening.to_world(-aside * 0.5, 0.4)
        yaw = yaw_along(look[0] - x, look[1] - y)
        yield Station(x, y, turn_towards_audience(yaw, math.radians(45)), 0.3 * (abs(aside) > half))
