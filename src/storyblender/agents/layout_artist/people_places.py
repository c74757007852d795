"""Places people as a scene begins: on seats, at their actions, in groups that face the audience."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.layout_artist.crowd_places import crowds_of, place_crowd
from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.people_seats import SEATED, seat_person
from storyblender.agents.layout_artist.people_stations import (
    WantedPlace,
    find_workplace,
    is_reachable,
    stand_person_at,
    wanted_places,
)
from storyblender.catalog.set_plan import PlanMark
from storyblender.geometry.boxes import footprint_gap, yaw_along
from storyblender.geometry.relations import LayoutThing
from storyblender.geometry.stations import turn_towards_audience
from storyblender.memory.shot_context import BodyState

TALK = 1.15
"""Metres between people who talk."""
_CHEAT = math.radians(16)
"""Radians that a talker turns towards the audience."""
_BARE = 1.4
"""Largest penalty, in metres, for a place in front of a bare wall."""
_ALONE = 1.5
"""Metres between a person and a group they do not belong to."""
_FORMATION = {2: (180.0, 0.0), 3: (195.0, 90.0, -15.0), 4: (200.0, 130.0, 50.0, -20.0)}
"""Degrees around the middle of a group, open to the audience."""


def place_people(stage: LayoutStage) -> None:
    """Place the people who are on stage at the start, then the people who are first seen in a later shot."""
    states = {state.asset_id: state for state in stage.view.states}
    wishes = wanted_places(stage)
    for state in sorted(states.values(), key=lambda state: state.asset_id in wishes):
        if state.posture in SEATED:
            _seat_person(stage, state, wishes.get(state.asset_id))
    for state in (each for each in states.values() if each.asset_id not in stage.things):
        _place_standing_person(stage, state, wishes.get(state.asset_id))
    company = stage.view.companions
    for member in sorted((each for each in states if each not in stage.things), key=lambda each: each not in wishes):
        _place_beside_companion(stage, member, wishes.get(member), company.get(member, ""))
    crowds = crowds_of([*states, *(state.asset_id for state in stage.view.found_later)])
    many = {member for members in crowds for member in members if not (member in wishes and wishes[member].sure)}
    for members in _group_people(stage, [each for each in states if each not in many]):
        _place_group(stage, members)
    for state in (each for each in stage.view.found_later if each.asset_id not in many):
        _place_found_person(stage, state, wishes.get(state.asset_id))
    for members in crowds:
        place_crowd(stage, [member for member in members if member in many])
    _turn_to_looked_at(stage)


def _place_standing_person(stage: LayoutStage, state: BodyState, wanted: WantedPlace | None) -> None:
    """Stand a person at the thing or part of the set they belong to, at their work, or at the mark of their trade."""
    leaned_on = state.support_id if state.posture == "lean" else None
    carried = wanted is not None and stage.view.placements.get(leaned_on or "") == "surface"
    anchor = stage.find_anchor(
        None if carried else leaned_on
    )  # a person who leans on a stick by the boat is by the boat
    anchor = anchor or (stage.find_anchor(wanted.anchor) if wanted is not None else None)
    anchor = anchor or find_workplace(stage, state)
    if anchor is not None and not anchor.walks and is_reachable(stage, anchor):
        stand_person_at(stage, state.asset_id, anchor, wanted or WantedPlace())
    elif wanted is None or wanted.anchor not in stage.assets.values():
        _place_at_set_mark(stage, state.asset_id, wanted)


def _place_beside_companion(stage: LayoutStage, member: str, wanted: WantedPlace | None, companion: str) -> None:
    """Stand a person relative to another one as the script says, else next to their companion."""
    told = stage.things.get(wanted.anchor or "") if wanted is not None else None
    if wanted is not None and told is not None and told.walks:
        if member not in stage.things:
            stand_person_at(stage, member, told, wanted)
        return
    other = stage.things.get(companion)
    if other is not None and other.walks and member not in stage.things:
        _place_companion(stage, member, other)


def _place_found_person(stage: LayoutStage, state: BodyState, wanted: WantedPlace | None) -> None:
    """Place a person who is first seen in a later shot: on a seat, on a set mark, or at a thing in the script."""
    if state.posture in SEATED:
        _seat_person(stage, state, wanted)
    if state.asset_id not in stage.things and (wanted is None or not wanted.sure):
        _place_at_set_mark(stage, state.asset_id, wanted)
    anchor = stage.find_anchor(wanted.anchor) if wanted is not None else None
    if state.asset_id in stage.things or wanted is None or anchor is None or anchor.walks:
        return
    if is_reachable(stage, anchor):
        stand_person_at(stage, state.asset_id, anchor, wanted)


def _group_people(stage: LayoutStage, present: list[str]) -> list[list[str]]:
    """Return groups of asset ids: talkers whose pairs share a person stand together, others alone."""
    groups: list[list[str]] = []
    for pair in stage.view.groups:
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


def _seat_person(stage: LayoutStage, state: BodyState, wanted: WantedPlace | None) -> None:
    """Seat a person on the seat in the script, or near the mark of their trade; they stay unplaced if none is free."""
    told = wanted.anchor if wanted is not None and wanted.relation not in ("facing", "in_front_of") else None
    own = _find_set_mark(stage, state.asset_id, state.support_id or told)
    seat_person(stage, state, wanted, own.location[:2] if own is not None else None)


def _find_set_mark(stage: LayoutStage, person: str, place: str | None) -> PlanMark | None:
    """Return the mark of the set whose tags match a person's place best, then their station, then their trade.

    Args:
        stage: The set and the view.
        person: Asset id of the person; its words may name a trade.
        place: Asset id of the thing the person is in or at; None if the script names none.

    Returns:
        The mark, such as a dock or a driver's seat; None if no tag matches.
    """
    trade = {word for word in person.split("_") if not word.isdigit()}
    named = [
        {each, each.rsplit("_", 1)[-1]} if each else set[str]()
        for each in (place, stage.view.resting_places.get(person))
    ]

    def match_score(mark: PlanMark) -> int:
        tags = {*mark.tags}
        return 4 * bool(named[0] & tags) + 2 * bool(named[1] & tags) + bool(trade & tags)

    best = max(stage.view.plan.marks, key=match_score)
    return best if match_score(best) else None


def _place_at_set_mark(stage: LayoutStage, asset_id: str, wanted: WantedPlace | None) -> None:
    """Place a person on the mark of the set that belongs to their place in the script or to their trade.

    Nothing happens if the set has no such mark or another thing is within 0.1 m of it.

    Args:
        stage: Gets the person.
        asset_id: Asset id of the person; its words may name a trade, such as ``barman_2``.
        wanted: The place that the script gives the person; None if it gives none.
    """
    mark = _find_set_mark(stage, asset_id, wanted.anchor if wanted is not None else None)
    if mark is None:
        return
    x, y, _ = mark.location
    if float(stage.clearance(np.array([(x, y)]))[0]) > 0.1:
        box = stage.box(asset_id, x, y, 0.0, math.radians(mark.yaw))
        stage.add(LayoutThing(asset_id, box, walks=True), asset_id)


def _direction_to_audience(x: float, stage: LayoutStage) -> tuple[float, float]:
    """Return the floor direction from a place at ``x`` towards the audience, not normalised."""
    middle = (stage.room.x_min + stage.room.x_max) / 2
    return 0.3 * (middle - x), -1.0


def _place_group(stage: LayoutStage, members: list[str]) -> None:
    """Place a group of people: beside those who have a place already, else in a formation open to the audience."""
    placed = [stage.things[member] for member in members if member in stage.things]
    waiting = [member for member in members if member not in stage.things]
    if not waiting:
        return
    if placed:
        for member in waiting:
            _place_beside_group(stage, member, placed)
            placed.append(stage.things[member])
        return
    if len(members) == 1:
        others = [(thing.box.x, thing.box.y) for thing in stage.things.values() if thing.walks]
        x, y = stage.free_spot(
            stage.acting_place,
            0.5,
            lambda x, y: _crowding_penalty((x, y), others) + 0.5 * _bareness_penalty(stage, x, y),
        )
        box = stage.box(members[0], x, y, 0.0, 0.0)
        box.turn_to(yaw_along(*_direction_to_audience(x, stage)))
        stage.add(LayoutThing(members[0], box, walks=True), members[0])
        return
    radius = stage.view.distance_scale * (TALK / 2 if len(members) == 2 else max(0.8, 0.22 * len(members)))
    x, y = stage.free_spot(stage.acting_place, radius + 0.45, lambda x, y: _bareness_penalty(stage, x, y))
    if stage.view.staging % 2:  # the other way round
        members = members[::-1]
    angles = _FORMATION.get(len(members)) or tuple(np.linspace(200, -20, len(members)).tolist())
    for member, angle in zip(members, angles, strict=True):
        dx, dy = radius * math.cos(math.radians(angle)), radius * math.sin(math.radians(angle))
        box = stage.box(member, x + dx, y + dy, 0.0, turn_towards_audience(yaw_along(-dx, -dy), _CHEAT))
        stage.add(LayoutThing(member, box, walks=True), member)
    if len(members) == 2:
        left, right = (stage.things[member] for member in members)
        left.anchor, left.relationship, left.direction, left.contact = right.name, "on_the_left_of", "facing", False
        right.anchor, right.direction = left.name, "facing"


def _place_companion(stage: LayoutStage, member: str, other: LayoutThing) -> None:
    """Place a person beside another, shoulder to shoulder, looking the same way."""
    x, y = stage.free_spot((other.box.x, other.box.y), 0.42, lambda x, y: _companion_penalty(other, x, y))
    stage.add(LayoutThing(member, stage.box(member, x, y, 0.0, other.box.yaw), walks=True), member)


def _companion_penalty(other: LayoutThing, x: float, y: float) -> float:
    """Return the penalty in metres for a place in front of another person, or far behind them."""
    across, along = other.box.to_local(x, y)
    return max(-along - 0.1, 0.0) + 0.5 * max(along - 0.4, 0.0) + max(0.6 - abs(across), 0.0)


def _bareness_penalty(stage: LayoutStage, x: float, y: float) -> float:
    """Return the penalty in metres for a place with nothing of the set visible behind it."""
    return _BARE * (1.0 - stage.backdrop(x, y))


def _crowding_penalty(place: tuple[float, float], others: list[tuple[float, float]]) -> float:
    """Return the penalty in metres for a place in a group, in front of it, or in line with it."""
    cost = sum(3 * max(_ALONE - math.dist(place, other), 0.0) for other in others)
    if others:
        xs, ys = zip(*others, strict=True)
        inside = min(place[0] - min(xs), max(xs) - place[0]) + 0.4
        cost += 1.5 * max(sum(ys) / len(ys) + 0.3 - place[1], 0.0) + 2 * max(min(inside, 1.0), 0.0)
    return cost + sum(max(0.5 - abs(place[0] - other[0]), 0.0) for other in others)


def _place_beside_group(stage: LayoutStage, member: str, placed: list[LayoutThing]) -> None:
    """Place a person at talking distance from a group, beside it as the audience sees it and not in front of it."""
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
    box = stage.box(member, x, y, 0.0, turn_towards_audience(yaw_along(first.box.x - x, first.box.y - y), _CHEAT))
    stage.add(LayoutThing(member, box, anchor=first.name, direction="facing", walks=True), member)


def _turn_to_looked_at(stage: LayoutStage) -> None:
    """Turn every person who stands alone towards the person or thing they look at."""
    for state in stage.view.states:
        thing, target = stage.things.get(state.asset_id), stage.find(state.looking_at)
        free = thing is not None and thing.anchor is None and target is not None and target is not thing
        if free and thing is not None and target is not None and footprint_gap(thing.box, target.box)[0] > 0:
            thing.box.turn_to(
                turn_towards_audience(yaw_along(target.box.x - thing.box.x, target.box.y - thing.box.y), _CHEAT)
            )
