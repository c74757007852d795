"""Wished places of the script's things: by their spots in the script, else by what they are."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import anchors_of, size_of, tops_of
from storyblender.agents.layout_artist.nested_places import (
    box_under,
    place_at_wall,
    place_high,
    place_in_hollow,
    place_outside,
)
from storyblender.agents.layout_artist.people_seats import is_seat_of_sitter_at
from storyblender.agents.layout_artist.wall_places import hang, stand_against
from storyblender.geometry.boxes import Box, footprint_gap, wrap_angle, yaw_along
from storyblender.geometry.relations import BEARING, LayoutThing, slide_to_gap
from storyblender.geometry.stations import TURNS
from storyblender.geometry.support import Perch, Taken, choose_perch
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import Spot

_SMALL = 0.6
"""Metres: smaller things stand on furniture rather than on the floor."""
_TABLE = (0.4, 1.15)
"""Heights in metres of surfaces that people use."""
_ROOMY = 0.34
"""Least metres across of a top that serves as a table."""
_ACTING = 1.6
"""Metres around the middle of the playing area that are left to people."""
_BESIDE = 0.12
"""Metres between things that are next to each other."""
_CAR, _PARKED = 1.1, 1.4
"""Metres from which two things count as vehicles, and their distance then, so that doors can open."""
_LUGGAGE = 0.42
"""Metres of height from which a carried thing stands on the floor, not on a table."""
_LONG_SEAT = 1.0
"""Metres: a wider seat has room for people and things."""
_SLEEPER = 0.66
"""Metres of a bed's width that a lying person takes."""
_HOT, _COOKED_IN = frozenset({"stove", "wood_stove", "fireplace"}), frozenset({"pot", "pan", "frying_pan", "kettle"})
_FLAT = 0.05
"""Metres of height up to which a thing lies under people's feet."""
_POINT = 0.1
"""Metres: a smaller part of the set is a mark, which is a point of the floor."""
_AT_HAND = 0.6
"""Metres from a person to a thing on the floor beside them."""


def place_objects(stage: LayoutStage, beside_people: bool = False) -> None:
    """Place every pending thing at its wished place; the anchors of others come first.

    Args:
        stage: The stage; changed.
        beside_people: Place only the things that depend on people, who stand already; else only all others.
    """
    told = _scripted_spots(stage)
    waiting = [asset_id for asset_id in stage.view.pending if stage.find(asset_id) is None]
    if not beside_people:
        waiting = [each for each in waiting if not _depends_on_people(stage, each, told)]
    waiting.sort(key=lambda asset_id: (_anchor_depth(asset_id, told), -_volume(stage, asset_id)))
    for asset_id in waiting:
        spot = told.get(asset_id)
        anchor = stage.find_anchor(spot.anchor_id) if spot is not None else None
        if spot is not None and spot.anchor_id is None and place_at_wall(stage, asset_id, spot, None):
            continue
        if spot is None or anchor is None:
            _place_without_spot(stage, asset_id)
        elif not _place_at_spot(stage, asset_id, spot, anchor):
            _place_without_spot(stage, asset_id, (anchor.box.x, anchor.box.y))


def _depends_on_people(stage: LayoutStage, asset_id: str, told: dict[str, Spot], depth: int = 0) -> bool:
    """Return whether a thing's spot depends on a person, directly or through another thing."""
    spot = told.get(asset_id)
    if spot is None or spot.anchor_id is None or depth > len(told):
        return _is_handled(stage, asset_id)
    people = {state.asset_id for state in stage.view.states}
    pending = spot.anchor_id in stage.view.pending
    return spot.anchor_id in people or (pending and _depends_on_people(stage, spot.anchor_id or "", told, depth + 1))


def _scripted_spots(stage: LayoutStage) -> dict[str, Spot]:
    """Return the spots of things in the script by asset id."""
    stated = reversed(stage.view.setup.relations)
    told = {each.asset_id: Spot(relation=each.kind, anchor_id=each.anchor_asset_id) for each in stated}
    told.update(stage.view.scripted_spots)
    return told


def _is_handled(stage: LayoutStage, asset_id: str) -> bool:
    """Return whether a person takes a small thing into their hands, so that it belongs within their reach."""
    return bool(stage.view.handlers.get(asset_id)) and stage.view.placements.get(asset_id) == "surface"


def _anchor_depth(asset_id: str, told: dict[str, Spot]) -> int:
    """Return how many things have to be placed before this one, itself included."""
    seen = [asset_id]
    while (spot := told.get(seen[-1])) is not None and spot.anchor_id is not None and spot.anchor_id not in seen:
        seen.append(spot.anchor_id)
    return len(seen)


def _volume(stage: LayoutStage, asset_id: str) -> float:
    """Return the volume of an asset in cubic metres."""
    width, depth, height = size_of(stage.measure(asset_id))
    return width * depth * height


def _place_at_spot(stage: LayoutStage, asset_id: str, spot: Spot, anchor: LayoutThing) -> bool:
    """Place a thing at its spot; return False if the anchor has no room for it."""
    kind = "in" if spot.relation == "inside" else "over" if spot.relation == "above" else spot.relation
    base, part = anchor.box, anchor.name not in stage.things
    if part and place_at_wall(stage, asset_id, spot, (base.x, base.y), anchor):
        return True
    if part and kind in ("at", "on", "in") and max(base.width, base.height) < _POINT:
        stage.place(asset_id, stage.box(asset_id, *stage.free_spot((base.x, base.y), _BESIDE), 0.0, base.yaw))
        return True
    flat = anchor.walks and kind in ("on", "under") and size_of(stage.measure(asset_id))[2] < _FLAT
    if flat:
        kind = "under"
    elif anchor.walks or part:
        kind = "next_to" if kind in ("on", "in", "under", "over", "around") else kind
    if kind == "behind" and place_outside(stage, asset_id, spot, anchor):
        return True
    if kind == "in" and place_in_hollow(stage, asset_id, anchor):
        return True
    if kind == "on" and spot.height is None and _place_on(stage, asset_id, anchor):
        return True
    if not part and place_high(stage, asset_id, spot, anchor):
        return True
    if kind in ("on", "in"):
        return _place_on(stage, asset_id, anchor)
    if kind in ("under", "around"):
        _place_under(stage, asset_id, spot.model_copy(update={"relation": kind}), anchor)
    elif kind == "over":
        box = stage.box(asset_id, base.x, base.y, 0.0, base.yaw)
        if not hang(stage, asset_id, near=(base.x, base.y), lowest=base.top + 0.1):
            box.z = base.top + 0.3 if spot.height is None else spot.height
            stage.place(asset_id, box, anchor=anchor.name)
    elif kind == "between" and (other := _second_anchor(stage, asset_id)) is not None:
        stage.place(asset_id, stage.box(asset_id, (base.x + other.box.x) / 2, (base.y + other.box.y) / 2))
    else:
        _place_beside(stage, asset_id, spot.model_copy(update={"relation": kind}), anchor)
    return True


def _place_under(stage: LayoutStage, asset_id: str, spot: Spot, anchor: LayoutThing) -> None:
    """Place a thing under or around another; what is too large to be under it is beside it, or beside its table."""
    under = spot.relation == "under"
    if anchor.walks or not under or _fits_under(stage, asset_id, anchor):
        stage.place(asset_id, box_under(stage, asset_id, anchor, peeps=under), anchor=anchor.name)
        return
    table = stage.find(anchor.anchor) if anchor.relationship == "on_top_of" else None
    _place_beside(stage, asset_id, spot.model_copy(update={"relation": "next_to"}), table or anchor)


def _fits_under(stage: LayoutStage, asset_id: str, anchor: LayoutThing) -> bool:
    """Return whether a thing can be under another: flat, smaller across, or lower than one that hangs."""
    base, (width, depth, height) = anchor.box, size_of(stage.measure(asset_id))
    return height < (base.z if anchor.floats else _FLAT) or (width < base.width and depth < base.depth)


def _second_anchor(stage: LayoutStage, asset_id: str) -> LayoutThing | None:
    """Return the second of the two things that a thing is between; None if there is none."""
    stated = (each for each in stage.view.setup.relations if each.asset_id == asset_id)
    return stage.find(next((each.second_anchor_asset_id for each in stated), None))


def _place_on(stage: LayoutStage, asset_id: str, anchor: LayoutThing, near: tuple[float, float] | None = None) -> bool:
    """Place a thing on top of an anchor, near a floor point; return False if there is no room."""
    chosen = find_perch(stage, asset_id, anchor, near)
    if chosen is None:
        return False
    x, y = anchor.box.to_world(chosen.x, chosen.y)
    yaw = anchor.box.yaw + (math.pi / 2 if chosen.turned else 0.0)
    box = stage.box(asset_id, x, y, anchor.box.z + chosen.surface.z, yaw)
    stage.place(
        asset_id, box, anchor=anchor.name, relationship="on_top_of", contact=True, surface=chosen.surface
    )  # fmt: skip
    return True


def find_perch(
    stage: LayoutStage, asset_id: str, anchor: LayoutThing, near: tuple[float, float] | None = None
) -> Perch | None:
    """Return where on an anchor there is room for an asset; None if there is none.

    On a long seat things go to its end, so that people can sit on the rest.

    Args:
        stage: The stage.
        asset_id: The thing.
        anchor: The furniture under it.
        near: Floor point of its user; None for the anchor's front.
    """
    taken = []
    for thing in stage.things.values():
        stands = thing.anchor == anchor.name and thing.relationship == "on_top_of"
        if stands or (thing is not anchor and thing.box.z > 0.2 and footprint_gap(thing.box, anchor.box)[0] < 0):
            u, v = anchor.box.to_local(thing.box.x, thing.box.y)
            turn = wrap_angle(thing.box.yaw - anchor.box.yaw)
            c, s = abs(math.cos(turn)), abs(math.sin(turn))
            width, depth = thing.box.width * c + thing.box.depth * s, thing.box.width * s + thing.box.depth * c
            taken.append(Taken(u, v, thing.box.z - anchor.box.z, width, depth))
    taken += _sleepers_on(stage, anchor)
    tops = tops_of(stage.measure(stage.assets[anchor.name]))
    size = size_of(stage.measure(asset_id))
    seats = anchors_of(stage.measure(stage.assets[anchor.name]), "seat")
    wish = (0.0, -anchor.box.depth / 4)
    if seats and anchor.box.width > _LONG_SEAT:
        wish = (anchor.box.width / 2, 0.0)
    elif near is not None:
        wish = anchor.box.to_local(*near)
    chosen = choose_perch(tops, size, wish, taken)
    if chosen is None and len(taken):
        smaller = (size[0] * 0.85, size[1] * 0.85, size[2])
        chosen = choose_perch(tops, smaller, wish, taken)
    return chosen


def _sleepers_on(stage: LayoutStage, anchor: LayoutThing) -> list[Taken]:
    """Return the space of a bed that a lying person takes, at the start of the scene or later."""
    names = (anchor.name, stage.assets[anchor.name])
    states = (*stage.view.states, *stage.view.found_later)
    if not any(state.posture in ("lie", "asleep") and state.support_id in names for state in states):
        return []
    beds = anchors_of(stage.measure(stage.assets[anchor.name]), "bed")
    return [Taken(*bed.location, _SLEEPER, bed.size[1]) for bed in beds]


def bearings_of(kind: str, anchor: Box, told: str | None = None) -> list[float]:
    """Return the bearings in radians that a relation allows around an anchor, the likeliest first.

    ``behind`` and ``in_front_of`` are the anchor's own back and front (behind the bar), left and right the picture's.

    Args:
        kind: The relation.
        anchor: Box of the anchor.
        told: Side of the anchor in the script, from its own point of view; None if not given.
    """
    front = math.atan2(anchor.forward[1], anchor.forward[0])
    if told in TURNS and kind not in ("left_of", "right_of"):
        return [front + TURNS[told]]
    if kind in ("in_front_of", "facing"):
        return [front]
    if kind == "behind":
        return [front + math.pi]
    if kind in ("left_of", "right_of"):
        return [math.pi if kind == "left_of" else 0.0]
    turns = (0.0, math.pi / 2, -math.pi / 2, math.pi)
    if kind != "next_to":
        return [front + turn for turn in turns]
    sides = sorted((front + math.pi / 2, front - math.pi / 2), key=lambda angle: round(math.sin(angle), 3))
    return [*sides, front, front + math.pi]


def _place_beside(stage: LayoutStage, asset_id: str, spot: Spot, anchor: LayoutThing) -> None:
    """Place a thing on the roomiest of the allowed sides; touching for ``against``, a seat facing its table."""
    kind = "at" if spot.relation == "next_to" and is_seat_of_sitter_at(stage, asset_id, anchor) else spot.relation
    width, depth, _ = size_of(stage.measure(asset_id))
    usual = _PARKED if min(width, depth) > _CAR and min(anchor.box.width, anchor.box.depth) > _CAR else _BESIDE
    usual = {"against": 0.01, "facing": 0.9}.get(kind, usual)
    gap = usual if spot.distance is None else max(spot.distance, 0.01)
    angles = bearings_of(kind, anchor.box, spot.side)
    places = [_box_beside(stage, asset_id, anchor, angle, gap) for angle in angles]
    room = stage.clearance(np.array([(box.x, box.y) for box in places])) - [box.radius for box in places]
    x_min, x_max, y_min, y_max = stage.room
    room = [
        free if x_min < box.x < x_max and y_min < box.y < y_max else -box.radius
        for free, box in zip(room, places, strict=True)
    ]
    best = max(range(len(places)), key=lambda index: (round(float(min(room[index], 0.3)), 3), -index))
    box = places[best]
    seat = any(each.kind == "seat" for each in stage.measure(asset_id).anchors) and box.width < _LONG_SEAT
    looked_at = kind == "facing" or (seat and kind in ("behind", "in_front_of", "at") and not anchor.walks)
    if looked_at:
        box.turn_to(yaw_along(anchor.box.x - box.x, anchor.box.y - box.y))
    at_wall = stage.view.placements.get(asset_id) == "wall" and spot.height is None
    if at_wall and hang(stage, asset_id, near=(box.x, box.y)):
        return
    slab = _ceiling_height(stage) if stage.view.placements.get(asset_id) == "ceiling" else None
    if slab is not None or spot.height:
        box.z = spot.height if slab is None and spot.height else (slab or box.height) - box.height
        stage.place(asset_id, box, anchor=anchor.name if anchor.name in stage.things else None, floats=True)
        return
    if anchor.name not in stage.things:
        stage.place(asset_id, box)
        return
    bearing = math.atan2(box.y - anchor.box.y, box.x - anchor.box.x)
    side = min(BEARING, key=lambda name: abs(wrap_angle(bearing - BEARING[name])))
    contact = True if kind == "against" else None
    direction = "facing" if looked_at else None
    off_stage = not (x_min < anchor.box.x < x_max and y_min < anchor.box.y < y_max)
    stage.place(
        asset_id, box, anchor=anchor.name, relationship=side, contact=contact, direction=direction, fixed=off_stage
    )  # fmt: skip


def _box_beside(stage: LayoutStage, asset_id: str, anchor: LayoutThing, angle: float, gap: float) -> Box:
    """Return the box of a thing beside an anchor at a bearing in radians, ``gap`` metres away."""
    box = stage.box(asset_id, anchor.box.x + math.cos(angle), anchor.box.y + math.sin(angle), 0.0, anchor.box.yaw)
    box.x, box.y = slide_to_gap(box, anchor.box, gap, angle)
    return box


def _place_without_spot(stage: LayoutStage, asset_id: str, near: Vec2 | None = None) -> None:
    """Place a thing without a spot: on the wall, at hand, on a table, along the walls, or on the free floor.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        near: Wished floor point, if its anchor had no room; else None.
    """
    width, depth, height = size_of(stage.measure(asset_id))
    placement = stage.view.placements.get(asset_id)
    if placement == "wall" and hang(stage, asset_id):
        return
    if placement == "ceiling" and (slab := _ceiling_height(stage)) is not None:
        x, y = stage.middle
        stage.place(asset_id, stage.box(asset_id, x, y, slab - height), floats=True, fixed=True)
        return
    handlers = stage.view.handlers.get(asset_id, ())
    user = next((user for each in handlers if (user := stage.things.get(each))), None)
    luggage = bool(handlers) and placement == "surface" and height > _LUGGAGE
    if luggage and user is not None:
        _place_at_hand(stage, asset_id, user)
        return
    small = placement == "surface" or (placement is None and max(width, depth, height) < _SMALL)
    if small and not luggage and _place_on_nearest_table(stage, asset_id, user, near):
        return
    used_from_behind = any(s.relation == "behind" and s.anchor_id == asset_id for s in _all_spots(stage))
    walled = stage.view.plan.indoor and (luggage or max(width, height) > 0.9) and not used_from_behind
    if walled and stand_against(stage, asset_id, near=near):
        return
    if user is not None:
        _place_at_hand(stage, asset_id, user)
        return
    middle = stage.middle
    wish = near or (middle[0] + 0.9, middle[1] + 1.5)
    x, y = stage.free_spot(
        wish, min(width, depth) / 2 + 0.35, lambda x, y: max(_ACTING - math.dist((x, y), middle), 0.0)
    )
    along = math.pi / 2 if depth > max(1.5 * width, 1.8) else 0.0
    stage.place(asset_id, stage.box(asset_id, x, y, 0.0, along))


def _all_spots(stage: LayoutStage) -> list[Spot]:
    """Return all spots of people and things in the script."""
    states = (*stage.view.states, *stage.view.found_later)
    return [*_scripted_spots(stage).values(), *(state.spot for state in states if state.spot is not None)]


def _place_at_hand(stage: LayoutStage, asset_id: str, user: LayoutThing) -> None:
    """Place a thing on the floor beside its user, out of the way of their feet."""
    width, depth, _ = size_of(stage.measure(asset_id))
    aside = _AT_HAND + width / 2
    sides = [user.box.to_world(turn * aside, -0.1) for turn in (1, -1)]
    room = stage.clearance(np.array(sides))
    x, y = stage.free_spot(
        sides[int(np.argmax(np.round(np.minimum(room, width / 2), 3)))], max(width, depth) / 2 + 0.05
    )
    stage.place(asset_id, stage.box(asset_id, x, y, 0.0, user.box.yaw))


def _ceiling_height(stage: LayoutStage) -> float | None:
    """Return the height of the ceiling in metres; None outdoors."""
    return next((slab.z for slab in stage.view.plan.slabs if slab.role == "ceiling"), None)


def _place_on_nearest_table(stage: LayoutStage, asset_id: str, user: LayoutThing | None, told: Vec2 | None) -> bool:
    """Place a small thing on the table nearest to its user, else to the middle; return False if none has room.

    On a long seat it goes beside the sitter; only pots and pans are put on a stove.
    """
    near = told or ((user.box.x, user.box.y) if user is not None else stage.middle)
    cooks = stage.view.props.get(asset_id) in _COOKED_IN
    tables = []
    for name, thing in stage.things.items():
        measure = stage.measure(stage.assets[name])
        seat = any(anchor.kind in ("seat", "bed") for anchor in measure.anchors)
        own = user is not None and user.anchor == name and thing.box.width > _LONG_SEAT
        roomy = [top for top in anchors_of(measure, "top") if own or min(top.size) > _ROOMY]
        table = any(_TABLE[0] <= top.location[2] <= _TABLE[1] for top in roomy)
        hot = stage.view.props.get(stage.assets[name]) in _HOT and not cooks
        if table and not hot and (own or not seat) and not thing.walks and thing.box.z < 0.1:
            tables.append((round(math.dist((thing.box.x, thing.box.y), near), 3), name))
    return any(_place_on(stage, asset_id, stage.things[name], near) for _, name in sorted(tables))
