"""Places for people who stand at, behind or beside something, chosen by the room around them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import anchors_of
from storyblender.catalog.workplaces import workplaces_of
from storyblender.geometry.boxes import Box, wrap_angle, yaw_along
from storyblender.geometry.relations import BEARING, BEARING_TOLERANCE, LayoutThing
from storyblender.geometry.stations import Sort, Station, stations, turn_towards_audience
from storyblender.memory.shot_context import BodyState

_STANDING = 0.15
"""Least metres from the middle of a standing person to the nearest thing."""
_ELBOW = 0.28
"""Metres of room for the elbows; more room gives no bonus."""
_AS_GOOD = 1.5
"""Penalty above that of the best station with which another staging may take it."""
_TIGHT = 8.0
"""Penalty in metres for each metre of room missing to ``_ELBOW``."""
_AFAR = 2.5
"""Metres from the playing area beyond which a thing is scenery."""
_ROOMY = 0.6
"""Metres kept free around a person who stands by a thing outside the playing area."""
_APART = 0.7
"""Metres between two people at the same thing."""
_FACES = ("at", "facing", "in_front_of", "behind")
"""Relations in which a person faces the anchor."""


@dataclass(frozen=True)
class WantedPlace:
    """The place that the script gives a person.

    Attributes:
        relation: A ``RelationKind``.
        anchor: Asset id of the thing they are at, or a part of the set.
        side: Side of the anchor, from its own point of view.
        distance: Metres from its edge, or from the middle of a person.
        facing: An id, ``away`` from the anchor, or ``camera``.
        sure: Whether it is this person's own place, not derived from a relation that others may share.
    """

    relation: str = "at"
    anchor: str | None = None
    side: str | None = None
    distance: float | None = None
    facing: str | None = None
    sure: bool = False


def wanted_places(stage: LayoutStage) -> dict[str, WantedPlace]:
    """Return each person's place in the script, at the start or when first seen, by asset id."""
    states = (*stage.view.states, *stage.view.found_later)
    people = {state.asset_id for state in states}
    stated = [relation for relation in reversed(stage.view.setup.relations) if relation.asset_id in people]
    wishes = {each.asset_id: WantedPlace(each.kind, each.anchor_asset_id) for each in stated}
    told = [(state.asset_id, state.spot) for state in reversed(states) if state.spot is not None]
    own = {name: WantedPlace(s.relation, s.anchor_id, s.side, s.distance, s.facing, sure=True) for name, s in told}
    return wishes | {name: wish for name, wish in own.items() if wish.anchor is not None or name not in wishes}


def find_workplace(stage: LayoutStage, state: BodyState) -> LayoutThing | None:
    """Return the thing at which a person does their first actions, if the script names none; None if there is none.

    Args:
        stage: What stands in the set; its view has each person's first actions.
        state: Its asset_id names the person.
    """
    for motion, prop in stage.view.first_actions.get(state.asset_id, ()):
        for wanted in workplaces_of(motion, prop):
            found = [t for name, t in stage.things.items() if stage.view.props.get(stage.assets[name]) == wanted]
            if found:
                return min(found, key=lambda thing: math.dist((thing.box.x, thing.box.y), stage.middle))
    return None


def sort_of(stage: LayoutStage, anchor: LayoutThing) -> Sort:
    """Return the sort of an anchor, as `geometry.stations` has them.

    Args:
        stage: What stands in the set; not changed.
        anchor: A person, a thing on the stage, or a part of the set as `LayoutStage.find_anchor` returns it.
    """
    if anchor.walks:
        return "person"
    if anchor.name in stage.things:
        return "thing"
    kind = next((each.kind for each in (stage.find_fixture(anchor.name),) if each is not None), "piece")
    sorts: dict[str, Sort] = {"door": "door", "window": "window", "wall": "wall", "corner": "point", "mark": "point"}
    return sorts.get(kind, "thing")


def stand_person_at(stage: LayoutStage, asset_id: str, anchor: LayoutThing, wanted: WantedPlace) -> None:
    """Place a person at, behind, in front of or beside something, on the side that has room.

    Args:
        stage: The stage; changed.
        asset_id: The person.
        anchor: The thing, the person or the part of the set.
        wanted: Their relation to the anchor.
    """
    sort, relation = sort_of(stage, anchor), wanted.relation
    options = stations(anchor.box, sort, relation, wanted.side, wanted.distance)
    if relation == "at" and wanted.side is None and sort == "thing" and _has_its_own_seat(stage, anchor):
        options = [*stations(anchor.box, sort, relation, "left"), *stations(anchor.box, sort, relation, "right")]
    best, room = _best_station(stage, asset_id, options)
    if room < _STANDING and sort == "thing":  # no room behind a thing that stands against a wall
        best, room = _best_station(
            stage, asset_id, [*options, *stations(anchor.box, sort, "at"), *stations(anchor.box, sort, "next_to")]
        )
    if room < 0 and sort == "thing":
        best = _nearest_in_room(stage, anchor.box, best)
    box = stage.box(asset_id, best.x, best.y, 0.0, best.yaw)
    turn_person(stage, box, wanted.facing, anchor.box)
    thing = LayoutThing(asset_id, box, walks=True)
    if anchor.name in stage.things:
        bearing = math.atan2(box.y - anchor.box.y, box.x - anchor.box.x)
        name = min(BEARING, key=lambda each: abs(wrap_angle(bearing - BEARING[each])))
        if abs(wrap_angle(bearing - BEARING[name])) < BEARING_TOLERANCE:
            thing.anchor, thing.relationship = anchor.name, name
            thing.direction = "facing" if relation in _FACES and _looks_at(box, anchor.box) else None
    stage.add(thing, asset_id)


def is_reachable(stage: LayoutStage, anchor: LayoutThing) -> bool:
    """Return whether people can walk to a thing; not to distant scenery such as a plane in the sky.

    Args:
        stage: Its playing area is where people walk.
        anchor: Its box is in world metres.
    """
    room, box = stage.room, anchor.box
    dx = max(room.x_min - box.x, box.x - room.x_max, 0.0) - box.reach((1.0, 0.0))
    dy = max(room.y_min - box.y, box.y - room.y_max, 0.0) - box.reach((0.0, 1.0))
    return max(dx, dy) < _AFAR


def _looks_at(box: Box, other: Box) -> bool:
    """Return whether a box faces another within 44 degrees."""
    return abs(wrap_angle(yaw_along(other.x - box.x, other.y - box.y) - box.yaw)) < math.radians(44)


def _best_station(stage: LayoutStage, person: str, options: list[Station]) -> tuple[Station, float]:
    """Return the station with the lowest penalty, and its room in metres, -1 outside the playing area."""
    points = np.array([(each.x, each.y) for each in options])
    x_min, x_max, y_min, y_max = stage.room
    inside = (points > (x_min, y_min)).all(axis=1) & (points < (x_max, y_max)).all(axis=1)
    room = np.where(inside, stage.clearance(points), -1.0)
    people = [(thing.box.x, thing.box.y) for thing in stage.things.values() if thing.walks]

    def cost(index: int) -> float:
        each = options[index]
        tight = _TIGHT * max(0.0, _ELBOW - float(room[index]))
        crowded = sum(max(0.0, _APART - math.dist((each.x, each.y), other)) for other in people)
        return round(each.dislike + tight + 3 * crowded, 3)

    order = sorted(range(len(options)), key=lambda index: (cost(index), index))
    good = [
        index
        for index in order
        if cost(index) < cost(order[0]) + _AS_GOOD and room[index] >= min(_ELBOW, room[order[0]])
    ]
    best = good[stage.pick(person, len(good))]
    return options[best], float(room[best])


def _nearest_in_room(stage: LayoutStage, anchor: Box, wish: Station) -> Station:
    """Return the place in the playing area nearest to a thing outside it, such as by a plane on the runway."""
    across, along = anchor.to_local(*stage.middle)
    half = anchor.width / 2, anchor.depth / 2
    edge = anchor.to_world(max(-half[0], min(half[0], across)), max(-half[1], min(half[1], along)))
    x, y = stage.free_spot(edge, _ROOMY)
    return Station(x, y, wish.yaw)


def _has_its_own_seat(stage: LayoutStage, anchor: LayoutThing) -> bool:
    """Return whether a thing has a seat that faces it, such as a piano's stool: others stand at its ends."""
    if anchor.name not in stage.assets:  # a part of the set
        return False
    seats = anchors_of(stage.measure(stage.assets[anchor.name]), "seat")
    return any(seat.direction[1] > 0.5 for seat in seats)


def turn_person(stage: LayoutStage, box: Box, wanted: str | None, anchor: Box | None) -> None:
    """Turn a person's box to what the script has them face.

    Args:
        stage: The stage.
        box: The person; changed.
        wanted: An id, ``away`` from the anchor, ``camera``, or None to stay.
        anchor: The anchor; None if there is none.
    """
    if wanted == "camera":
        box.turn_to(0.0)
    elif wanted == "away" and anchor is not None:
        box.turn_to(yaw_along(box.x - anchor.x, box.y - anchor.y))
    elif wanted is not None and (thing := stage.find_anchor(wanted)) is not None:
        box.turn_to(turn_towards_audience(yaw_along(thing.box.x - box.x, thing.box.y - box.y)))
