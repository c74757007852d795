"""Where people are when a scene begins: on their seats, at what they do, in groups that the audience can read."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.agents.layout_artist.layout_stage import Stage
from storyblender.agents.layout_artist.layout_things import PERSON, anchors_of, seat_box
from storyblender.agents.layout_artist.object_places import angles_of
from storyblender.catalog.set_plan import PlanMark
from storyblender.geometry.boxes import Box, facing, separation, wrapped
from storyblender.geometry.relations import BEARING, Thing
from storyblender.geometry.seating import seats_of
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.scene_context import Relation
from storyblender.memory.shot_context import BodyState

TALK = 1.15
"""Metres between people who talk."""
_SEAT_FOOT = 0.32
"""Metres: what begins higher lies on something, and nobody sits on it."""
_STANDING = 0.15
"""Metres from the middle of somebody who stands to the next thing, at least."""
_SHOULDERS = 0.8
"""Metres between people who stand side by side."""
_CHEAT = math.radians(16)
"""How far a talker turns towards the audience."""
_ALONE = 1.5
"""Metres between a person and a group they do not belong to."""
_OPPOSITE, _ACROSS = ("facing", "in_front_of"), 1.6
"""Relations of who sits opposite somebody, and how many metres ahead of them that is."""
_FORMATION = {2: (180.0, 0.0), 3: (195.0, 90.0, -15.0), 4: (200.0, 130.0, 50.0, -20.0)}
"""Degrees around the middle of a group, open to the audience."""


def place_people(stage: Stage) -> None:
    """Place everybody who is on stage at the start, then those whom a later shot finds at a place of their own."""
    states = {state.asset_id: state for state in stage.brief.states}
    everybody = {*states, *(state.asset_id for state in stage.brief.found)}
    stated = [relation for relation in reversed(stage.brief.setup.relations) if relation.asset_id in everybody]
    settled = {relation.asset_id: relation for relation in stated}
    relations = {each: relation for each, relation in settled.items() if each in states}
    for state in sorted(states.values(), key=lambda state: state.asset_id in relations):
        if state.posture in ("sit", "lie", "asleep"):
            _sit(stage, state, relations.get(state.asset_id))
    for state in states.values():
        relation = relations.get(state.asset_id)
        leaned_on = state.support_id if state.posture == "lean" else None
        carried = relation is not None and stage.brief.placements.get(leaned_on or "") == "surface"
        anchor = stage.find(None if carried else leaned_on)  # who leans on a stick by the boat is by the boat
        anchor = anchor or (stage.find(relation.anchor_asset_id) if relation is not None else None)
        if state.asset_id not in stage.things and anchor is not None and not anchor.walks:
            _stand_at(stage, state.asset_id, anchor, relation)
        elif state.asset_id not in stage.things:
            _stand_at_work(stage, state.asset_id, relation)
    company = {**stage.brief.company, **{each: relation.anchor_asset_id for each, relation in relations.items()}}
    for member in (each for each in states if each not in stage.things):
        other = stage.things.get(company.get(member, ""))
        if other is not None and other.walks:
            _accompany(stage, member, other)
    for members in _groups(stage, list(states)):
        _gather(stage, members)
    for state in stage.brief.found:
        _find(stage, state, settled.get(state.asset_id))
    _look_at_each_other(stage)


def _find(stage: Stage, state: BodyState, relation: Relation | None) -> None:
    """Place who is there already when a later shot shows them: on a seat, at what the script says, at their trade."""
    if state.posture in ("sit", "lie", "asleep"):
        _sit(stage, state, relation)
    if state.asset_id not in stage.things:
        _stand_at_work(stage, state.asset_id, relation)
    anchor = stage.find(relation.anchor_asset_id) if relation is not None else None
    if state.asset_id not in stage.things and anchor is not None and not anchor.walks:
        _stand_at(stage, state.asset_id, anchor, relation)


def _groups(stage: Stage, present: list[str]) -> list[list[str]]:
    """Return who stands together: talkers joined by their pairs, the rest one by one."""
    groups: list[list[str]] = []
    for pair in stage.brief.groups:
        here = [member for member in pair if member in present]
        if len(here) < 2:
            continue
        joined = next((group for group in groups if any(member in group for member in here)), None)
        if joined is None:
            groups.append(here)
        else:
            joined += [member for member in here if member not in joined]
    told = {member for group in groups for member in group}
    if not groups and len(present) == 2:
        return [list(present)]
    return groups + [[member] for member in present if member not in told]


def _sit(stage: Stage, state: BodyState, relation: Relation | None) -> None:
    """Take the free seat of the support nearest to the middle, another near it if that is full; without one, stand.

    Who sits opposite somebody takes the seat nearest to what that one looks at.
    """
    kinds = ("bed", "seat") if state.posture in ("lie", "asleep") else ("seat",)
    support = stage.find(state.support_id)
    named = [name for name in stage.things if state.support_id in (name, stage.assets[name])]
    asked = [name for name in named if stage.things[name].box.z < _SEAT_FOOT]
    support = support if asked or not named else None
    found = _free_seats(stage, asked, kinds, stage.middle, asked=True) if asked else []
    if not found:
        station = relation.anchor_asset_id if relation is not None and relation.kind not in _OPPOSITE else None
        own = _mark_of(stage, state.asset_id, state.support_id or station)
        near = own.location[:2] if own is not None else stage.middle
        near = (support.box.x, support.box.y) if support is not None else near
        other = stage.things.get(relation.anchor_asset_id) if relation is not None else None
        if other is not None and relation is not None and relation.kind in _OPPOSITE:
            near = other.box.to_world(0.0, -_ACROSS)
        found = _free_seats(stage, list(stage.things), kinds, near, asked=False)
    if not found:
        return
    _, name, anchor = min(found, key=lambda seat: seat[:2])
    base = stage.things[name].box
    x, y = base.to_world(*anchor.location[:2])
    dx, dy, _ = anchor.direction
    yaw = base.yaw + facing(dx, dy)
    box = seat_box(x, y, base.z + anchor.location[2], yaw)
    stage.add(Thing(state.asset_id, box, anchor=name, walks=True), state.asset_id)


def _free_seats(
    stage: Stage, names: list[str], kinds: tuple[str, ...], near: tuple[float, float], asked: bool
) -> list[tuple[float, str, Anchor]]:
    """Return the seats nobody and nothing is on, each with its distance in metres and its furniture."""
    seats: list[tuple[float, str, Anchor]] = []
    for name in names:
        thing = stage.things[name]
        for anchor in [each for kind in kinds if not thing.walks for each in _anchors(stage, name, kind, asked)]:
            x, y = thing.box.to_world(*anchor.location[:2])
            if all(math.dist((x, y), (other.box.x, other.box.y)) > 0.45 for other in _on_seats(stage, name)):
                seats.append((round(math.dist((x, y), near), 3), name, anchor))
    return seats


def _on_seats(stage: Stage, name: str) -> list[Thing]:
    """Return everybody, and the things that lie on a seat."""
    return [
        thing
        for thing in stage.things.values()
        if thing.walks or (thing.anchor == name and thing.relationship == "on_top_of")
    ]


def _anchors(stage: Stage, name: str, kind: str, asked: bool) -> list[Anchor]:
    """Return an asset's beds or seats, also the edge of what the script sits people on."""
    measure = stage.measure(stage.assets[name])
    return anchors_of(measure, kind) if kind == "bed" else seats_of(measure.anchors, measure.dimensions, asked=asked)


def _stand_at(stage: Stage, asset_id: str, anchor: Thing, relation: Relation | None) -> None:
    """Stand at, behind, before or beside something, on the side that has room; beside it, turned to the audience."""
    kind = relation.kind if relation is not None else "at"
    angles = angles_of(kind, anchor.box)
    if kind == "at" and _has_its_own_seat(stage, anchor):
        angles = [*angles[1:3], angles[0], angles[3]]
    room, box = _roomiest(stage, asset_id, anchor, angles)
    if len(angles) == 1 and room < _STANDING:  # nobody stands behind what is against a wall
        room, box = _roomiest(stage, asset_id, anchor, angles_of("at", anchor.box))
    bearing = math.atan2(box.y - anchor.box.y, box.x - anchor.box.x)
    side = min(BEARING, key=lambda name: abs(wrapped(bearing - BEARING[name])))
    if kind in ("next_to", "left_of", "right_of", "against"):
        box.turn_to(facing(*_towards_audience(box.x, box.y, stage)))
    looks = "facing" if kind in ("at", "facing", "in_front_of", "behind") else None
    stage.add(Thing(asset_id, box, anchor=anchor.name, relationship=side, direction=looks, walks=True), asset_id)


def _roomiest(stage: Stage, asset_id: str, anchor: Thing, angles: Sequence[float]) -> tuple[float, Box]:
    """Return the place before some sides of a thing that has enough room, else most; and how much, negative outside."""
    places = [box for angle in angles for box in _along_side(stage, asset_id, anchor.box, angle)]
    room = stage.clearance(np.array([(box.x, box.y) for box in places]))
    x_min, x_max, y_min, y_max = stage.room
    inside = [x_min < box.x < x_max and y_min < box.y < y_max for box in places]
    free = [min(round(float(each), 2), 0.25) if within else -1.0 for each, within in zip(room, inside, strict=True)]
    best = max(range(len(places)), key=lambda index: (free[index], -index))
    return free[best], places[best]


def _mark_of(stage: Stage, person: str, place: str | None) -> PlanMark | None:
    """Return the set's mark for what somebody is in or at, else for their trade: the dock, the driver's seat.

    A mark that is meant by the place and by the trade goes before one that only the place means.
    """
    trade = {word for word in person.split("_") if not word.isdigit()}
    named = [
        {each, each.rsplit("_", 1)[-1]} if each else set[str]() for each in (place, stage.brief.stations.get(person))
    ]

    def meant(mark: PlanMark) -> int:
        tags = {*mark.tags}
        return 4 * bool(named[0] & tags) + 2 * bool(named[1] & tags) + bool(trade & tags)

    best = max(stage.brief.plan.marks, key=meant)
    return best if meant(best) else None


def _stand_at_work(stage: Stage, asset_id: str, relation: Relation | None) -> None:
    """Stand at one's mark, if the set has it and there is room."""
    mark = _mark_of(stage, asset_id, relation.anchor_asset_id if relation is not None else None)
    if mark is None:
        return
    x, y, _ = mark.location
    if float(stage.clearance(np.array([(x, y)]))[0]) > 0.1:
        box = stage.box(asset_id, x, y, 0.0, math.radians(mark.yaw))
        stage.add(Thing(asset_id, box, walks=True), asset_id)


def _has_its_own_seat(stage: Stage, anchor: Thing) -> bool:
    """Return whether a seat before a thing faces it, as a piano's stool does: who does not play stands at its ends."""
    seats = anchors_of(stage.measure(stage.assets[anchor.name]), "seat")
    return any(seat.direction[1] > 0.5 for seat in seats)


def _along_side(stage: Stage, asset_id: str, base: Box, angle: float) -> list[Box]:
    """Return places before one side of something, its middle first: several people stand side by side at a bar."""
    out, along = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    spare = max(base.reach(along) - PERSON[0] / 2, 0.0)
    steps = [0.0, *(side * step for step in np.arange(_SHOULDERS, spare + 1e-6, _SHOULDERS) for side in (1, -1))]
    yaw, off = facing(-out[0], -out[1]), base.reach(out) + 0.25 + PERSON[1] / 2
    return [
        stage.box(asset_id, base.x + out[0] * off + along[0] * step, base.y + out[1] * off + along[1] * step, 0.0, yaw)
        for step in steps
    ]


def _towards_audience(x: float, y: float, stage: Stage) -> tuple[float, float]:
    middle = (stage.room.x_min + stage.room.x_max) / 2
    return 0.3 * (middle - x), -1.0


def _gather(stage: Stage, members: list[str]) -> None:
    """Stand a group: around whoever sits or works already, else in a formation open to the audience."""
    placed = [stage.things[member] for member in members if member in stage.things]
    waiting = [member for member in members if member not in stage.things]
    if not waiting:
        return
    if placed:
        for member in waiting:
            _join(stage, member, placed)
            placed.append(stage.things[member])
        return
    if len(members) == 1:
        others = [(thing.box.x, thing.box.y) for thing in stage.things.values() if thing.walks]
        x, y = stage.free_spot(stage.middle, 0.5, lambda x, y: _crowding((x, y), others))
        box = stage.box(members[0], x, y, 0.0, 0.0)
        box.turn_to(facing(*_towards_audience(x, y, stage)))
        stage.add(Thing(members[0], box, walks=True), members[0])
        return
    radius = TALK / 2 if len(members) == 2 else max(0.8, 0.22 * len(members))
    x, y = stage.free_spot(stage.middle, radius + 0.45)
    angles = _FORMATION.get(len(members)) or tuple(np.linspace(200, -20, len(members)).tolist())
    for member, angle in zip(members, angles, strict=True):
        dx, dy = radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle))
        box = stage.box(member, x + dx, y + dy, 0.0, cheated(facing(-dx, -dy)))
        stage.add(Thing(member, box, walks=True), member)
    if len(members) == 2:
        left, right = (stage.things[member] for member in members)
        left.anchor, left.relationship, left.direction, left.contact = right.name, "on_the_left_of", "facing", False
        right.anchor, right.direction = left.name, "facing"


def _accompany(stage: Stage, member: str, other: Thing) -> None:
    """Stand beside somebody, at the shoulder, looking the same way."""
    x, y = stage.free_spot((other.box.x, other.box.y), 0.42, lambda x, y: _shoulder(other, x, y))
    stage.add(Thing(member, stage.box(member, x, y, 0.0, other.box.yaw), walks=True), member)


def _shoulder(other: Thing, x: float, y: float) -> float:
    """Dislike being before somebody, or far behind."""
    across, along = other.box.to_local(x, y)
    return max(-along - 0.1, 0.0) + 0.5 * max(along - 0.4, 0.0) + max(0.6 - abs(across), 0.0)


def _crowding(place: tuple[float, float], others: list[tuple[float, float]]) -> float:
    """Dislike being in a group one does not belong to, between it and the audience, or in line with it."""
    cost = sum(3 * max(_ALONE - math.dist(place, other), 0.0) for other in others)
    if others:
        xs, ys = zip(*others, strict=True)
        inside = min(place[0] - min(xs), max(xs) - place[0]) + 0.4
        cost += 1.5 * max(sum(ys) / len(ys) + 0.3 - place[1], 0.0) + 2 * max(min(inside, 1.0), 0.0)
    return cost + sum(max(0.5 - abs(place[0] - other[0]), 0.0) for other in others)


def _join(stage: Stage, member: str, placed: list[Thing]) -> None:
    """Stand at talking distance before those who are placed, seen beside them and not in front of them."""
    first = placed[0]
    ahead = math.atan2(first.box.forward[1], first.box.forward[0])
    best: tuple[float, float, float] | None = None
    for turn in range(-120, 121, 10):
        for more in (0.0, 0.2, 0.45, 0.8):
            angle, reach = ahead + math.radians(turn), TALK + more
            x, y = first.box.x + reach * math.cos(angle), first.box.y + reach * math.sin(angle)
            free = float(stage.clearance(np.array([(x, y)]))[0])
            room = stage.room
            inside = room.x_min + 0.3 < x < room.x_max - 0.3 and room.y_min + 0.3 < y < room.y_max - 0.3
            cost = abs(turn) / 90 + more + 8 * max(0.42 - free, 0) + 5 * (not inside)
            cost += sum(max(0.45 - abs(x - other.box.x), 0.0) * 2 for other in placed)
            if best is None or cost < best[0] - 1e-9:
                best = (cost, x, y)
    assert best is not None
    _, x, y = best
    box = stage.box(member, x, y, 0.0, cheated(facing(first.box.x - x, first.box.y - y)))
    stage.add(Thing(member, box, anchor=first.name, direction="facing", walks=True), member)


def cheated(yaw: float) -> float:
    """Return a yaw turned a little towards the audience (yaw 0)."""
    yaw = wrapped(yaw)
    return yaw - max(-_CHEAT, min(_CHEAT, yaw))


def _look_at_each_other(stage: Stage) -> None:
    """Turn whoever stands alone to whom they look at."""
    for state in stage.brief.states:
        thing, target = stage.things.get(state.asset_id), stage.find(state.looking_at)
        free = thing is not None and thing.anchor is None and target is not None and target is not thing
        if free and thing is not None and target is not None and separation(thing.box, target.box)[0] > 0:
            thing.box.turn_to(cheated(facing(target.box.x - thing.box.x, target.box.y - thing.box.y)))
