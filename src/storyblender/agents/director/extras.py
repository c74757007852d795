"""Groups become people: ``TWO GUARDS`` are two bodies on the set, though the script gives them one name."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from storyblender.agents.director import lexicon
from storyblender.agents.director.reading import Person, Reading, Unit
from storyblender.catalog.inflection import noun_key
from storyblender.memory.scene_context import Relation, Spot
from storyblender.memory.vocabulary import Gender

MAX_GROUP = 40
"""Most bodies for one group."""

_AGES = ("30s", "50s", "20s", "40s", "60s", "30s", "70s")
"""Ages given in turn to members of a group without a stated age."""
_MEN = lexicon.words("men")
"""Groups that are all men unless the script mentions women."""
_CROWD = 4
"""Number of members from which a group counts as a crowd."""
_NUMBER = 60
"""Characters before a group in which its number stands."""
_Value = TypeVar("_Value")


def expand_groups(reading: Reading) -> Reading:
    """Return the reading with each group replaced by its members; one member speaks and is spoken to."""
    people: list[Person] = []
    members: dict[str, list[str]] = {}
    for person in reading.people:
        count = min(MAX_GROUP, _count(person, reading.screenplay.text)) if person.kind != "animal" else 1
        if count < 2:
            people.append(person)
            continue
        singles = [_member(person, number) for number in range(1, count + 1)]
        members[person.id] = [single.id for single in singles]
        people += singles
    if not members:
        return reading
    return replace(
        reading,
        people=people,
        units=[_expand_unit(unit, members) for unit in reading.units],
        relations=[
            (scene, single) for scene, relation in reading.relations for single in _expand_relation(relation, members)
        ],
    )


def _count(group: Person, text: str) -> int:
    """Return the number before the group's first mention, else the reader's count."""
    before = text[max(0, group.first - _NUMBER) : group.first].split()[-1:]
    stated = lexicon.NUMBERS.get(before[0].lower(), 0) if before and group.count > 1 else 0
    return stated if stated > 1 else group.count


def _member(group: Person, number: int) -> Person:
    """Return one member of a group; without a description, women and men in turn, of several ages."""
    words = {noun_key(word) for word in f"{group.name} {group.role}".lower().split()}
    mixed: Gender = "male" if words & _MEN else ("female", "male")[number % 2]
    gender = group.gender if group.gender != "unknown" or group.count < _CROWD else mixed
    return replace(
        group, id=f"{group.id[:60]}_{number}", name=f"{group.name} {number}", kind="human", count=1,
        aliases=(*group.aliases, group.name), gender=gender, age=group.age or _AGES[number % len(_AGES)],
    )  # fmt: skip


def _expand_unit(unit: Unit, members: dict[str, list[str]]) -> Unit:
    """Return a unit with each group replaced by its members."""
    return replace(
        unit,
        deeds=[
            replace(deed, actor=actor, target=_expand_optional(deed.target, members))
            for deed in unit.deeds
            for actor in members.get(deed.actor, [deed.actor])
        ],
        on_stage=_expand_ids(unit.on_stage, members),
        entering=_expand_ids(unit.entering, members),
        leaving=_expand_ids(unit.leaving, members),
        people=_expand_ids(unit.people, members),
        posture=_expand_values(unit.posture, members),
        held={_first_member(person, members): things for person, things in unit.held.items()},
        expressions=_expand_values(unit.expressions, members),
        gaze=_expand_values({person: _first_member(where, members) for person, where in unit.gaze.items()}, members),
        grips={_first_member(person, members): grips for person, grips in unit.grips.items()},
        activities=_expand_values(unit.activities, members),
        spots=_expand_values({each: _expand_spot(spot, members) for each, spot in unit.spots.items()}, members),
        tethers=[
            tether.model_copy(
                update={"holder": _first_member(tether.holder, members), "held": _first_member(tether.held, members)}
            )
            for tether in unit.tethers
        ],
        speaker=_expand_optional(unit.speaker, members),
        to=_expand_optional(unit.to, members),
    )


def _expand_spot(spot: Spot, members: dict[str, list[str]]) -> Spot:
    """Return a spot with a group anchor replaced by its first member."""
    return spot.model_copy(
        update={
            "anchor_id": _expand_optional(spot.anchor_id, members),
            "facing": _expand_optional(spot.facing, members),
        }
    )


def _expand_relation(relation: Relation, members: dict[str, list[str]]) -> list[Relation]:
    """Return a relation once for each member of a group."""
    anchor = _first_member(relation.anchor_asset_id, members)
    return [
        relation.model_copy(update={"asset_id": member, "anchor_asset_id": anchor})
        for member in members.get(relation.asset_id, [relation.asset_id])
    ]


def _expand_ids(ids: list[str], members: dict[str, list[str]]) -> list[str]:
    """Return ids with each group replaced by its members."""
    return [member for id_ in ids for member in members.get(id_, [id_])]


def _expand_values(values: dict[str, _Value], members: dict[str, list[str]]) -> dict[str, _Value]:
    """Return a table by id with the value of a group given to each member."""
    return {member: value for person, value in values.items() for member in members.get(person, [person])}


def _first_member(id_: str, members: dict[str, list[str]]) -> str:
    """Return the first member of a group, or the id itself."""
    return members[id_][0] if id_ in members else id_


def _expand_optional(id_: str | None, members: dict[str, list[str]]) -> str | None:
    """Return the first member of a group, the id itself, or None."""
    return _first_member(id_, members) if id_ else None
