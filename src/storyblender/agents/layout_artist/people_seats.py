"""Seats people as a scene begins: on the seat the script names, at the table, or on any free seat nearby."""

from __future__ import annotations

import math
from collections.abc import Iterable

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import anchors_of, seat_box
from storyblender.agents.layout_artist.people_stations import WantedPlace
from storyblender.geometry.boxes import distance_to_point, yaw_along
from storyblender.geometry.relations import LayoutThing
from storyblender.geometry.seating import NEAR_TABLE, TABLE_GAP, list_seats, select_seats
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec2
from storyblender.memory.shot_context import BodyState

SEATED = ("sit", "lie", "asleep")
"""Postures on a seat or a bed, if there is one."""
_SEAT_FOOT = 0.32
"""Metres: a seat with a higher lower edge lies on something else, and is not for sitting."""
_OPPOSITE, _ACROSS = ("facing", "in_front_of"), 1.6
"""Relations of a person who sits opposite another one, and the distance ahead of that one in metres."""
_TAKEN = 0.45
"""Metres from a seat's edge within which a person occupies it."""
_NEAR_SEATS = 3
"""Seats among which another staging chooses, the nearest first."""

Seat = tuple[str, Anchor]
"""Name of the furniture, and the seat on it."""


def seat_person(stage: LayoutStage, state: BodyState, wanted: WantedPlace | None, near: Vec2 | None) -> bool:
    """Seat a person on the free seat that the script names, else on the nearest one; return False if none is free.

    Args:
        stage: The stage; changed.
        state: Posture and support of the person.
        wanted: The place that the script gives them; None if it gives none.
        near: Floor point of their work; None if they have none.
    """
    kinds = ("bed", "seat") if state.posture in ("lie", "asleep") else ("seat",)
    support = stage.find(state.support_id) or (None if near else stage.find_anchor(state.support_id))
    other = stage.find_anchor(wanted.anchor) if wanted is not None else None
    if support is None and other is not None and not other.walks and wanted and wanted.relation not in _OPPOSITE:
        support = other
    wish = near or stage.acting_place
    if support is not None:
        wish = (support.box.x, support.box.y)
    if other is not None and wanted is not None and wanted.relation in _OPPOSITE:
        wish = other.box.to_world(0.0, -_ACROSS)
    elif other is not None and other.walks:
        wish = (other.box.x, other.box.y)
    seats: list[Seat] = []
    if support is not None and support.name in stage.things and support.box.z < _SEAT_FOOT:
        on_it = wanted is not None and wanted.relation == "on" and wanted.anchor == state.support_id
        seats = [] if on_it else _free_among(stage, _seats_at_table(stage, support))
        seats = seats or _free_among(stage, _list_seats(stage, [support.name], kinds, asked=True))
        if wanted is not None and wanted.side is not None:
            seats = select_seats(seats, wanted.side, lambda seat: (seat[1].location[0], -seat[1].location[1]))
    seats = seats or _free_among(stage, _list_seats(stage, list(stage.things), kinds, asked=False))
    if not seats:
        return False
    seats = sorted(seats, key=lambda seat: (round(math.dist(_seat_point(stage, seat), wish), 3), seat[0]))
    told = wanted is not None and wanted.side is not None
    put_on_seat(stage, state.asset_id, seats[0 if told else stage.pick(state.asset_id, min(len(seats), _NEAR_SEATS))])
    return True


def free_seats(stage: LayoutStage) -> list[Seat]:
    """Return every seat of the set that is free of people and things."""
    return _free_among(stage, _list_seats(stage, list(stage.things), ("seat",), asked=False))


def is_seat_of_sitter_at(stage: LayoutStage, asset_id: str, table: LayoutThing) -> bool:
    """Return whether a thing is a single seat beside a table that a character sits at, so that it faces the table.

    Args:
        stage: What stands in the set; not changed.
        asset_id: The thing.
        table: What it is beside.
    """
    if table.name not in stage.assets or table.walks:
        return False
    seat, base = stage.measure(asset_id), stage.measure(stage.assets[table.name])
    spots = (each.spot for each in (*stage.view.states, *stage.view.found_later) if each.posture == "sit")
    return (
        len(anchors_of(seat, "seat")) == 1
        and bool(anchors_of(base, "top"))
        and not anchors_of(base, "seat")
        and any(spot is not None and spot.anchor_id == table.name for spot in spots)
    )


def put_on_seat(stage: LayoutStage, person: str, seat: Seat) -> None:
    """Place a person on a seat.

    Args:
        stage: What stands in the set; changed.
        person: asset_id.
        seat: node_id of furniture on the stage, and one of its seats.
    """
    name, anchor = seat
    base = stage.things[name].box
    x, y = base.to_world(*anchor.location[:2])
    dx, dy, _ = anchor.direction
    box = seat_box(x, y, base.z + anchor.location[2], base.yaw + yaw_along(dx, dy))
    stage.add(LayoutThing(person, box, anchor=name, walks=True), person)


def _list_seats(stage: LayoutStage, names: Iterable[str], kinds: tuple[str, ...], asked: bool) -> list[Seat]:
    """Return the seats or beds of things, and edges of a thing that the script has people sit on (``asked``)."""
    found: list[Seat] = []
    for name in (name for name in names if not stage.things[name].walks):
        measure = stage.measure(stage.assets[name])
        for kind in kinds:
            beds = kind == "bed"
            anchors = (
                anchors_of(measure, kind) if beds else list_seats(measure.anchors, measure.dimensions, asked=asked)
            )
            found += [(name, anchor) for anchor in anchors]
    return found


def _free_among(stage: LayoutStage, seats: Iterable[Seat]) -> list[Seat]:
    """Return those of the seats that are free of people and things."""
    return [
        seat
        for seat in seats
        if all(
            math.dist(_seat_point(stage, seat), (thing.box.x, thing.box.y)) > _TAKEN
            for thing in stage.things.values()
            if thing.walks or (thing.anchor == seat[0] and thing.relationship == "on_top_of")
        )
    ]


def _seat_point(stage: LayoutStage, seat: Seat) -> Vec2:
    """Return the floor point of a seat's front edge."""
    return stage.things[seat[0]].box.to_world(*seat[1].location[:2])


def _seats_at_table(stage: LayoutStage, table: LayoutThing) -> list[Seat]:
    """Return the seats drawn up to a table without a seat of its own, else those near it."""
    own = stage.measure(stage.assets[table.name])
    if any(anchor.kind in ("seat", "bed") for anchor in own.anchors) or not anchors_of(own, "top"):
        return []
    found: list[Seat] = []
    near: list[Seat] = []
    for seat in _list_seats(stage, [name for name in stage.things if name != table.name], ("seat",), asked=False):
        base = stage.things[seat[0]].box
        x, y = _seat_point(stage, seat)
        ahead = base.to_world(*(seat[1].location[i] + 0.3 * seat[1].direction[i] for i in (0, 1)))
        away = distance_to_point(table.box, x, y)
        if away < TABLE_GAP and distance_to_point(table.box, *ahead) < away:
            found.append(seat)
        elif away < NEAR_TABLE:
            near.append(seat)
    return found or near
