"""Props from scene to scene: lasting states and positions carry over, and a prop is hidden until it is brought."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.fixtures import is_fixture
from storyblender.agents.director.lighting import light_change
from storyblender.agents.director.reading import Reading, SceneReading, StateChange, Unit
from storyblender.memory.scene_context import Relation
from storyblender.memory.thing_states import THING_STATES, Condition, StateValues, state_values

_LASTING = frozenset({"broken", "torn", "gone"})
"""States that time does not undo."""
_LATER_DAY = re.compile(
    r"\b(next|following|morning after|days?|weeks?|months?|years?) (later|after|day|morning|night|evening|week)\b"
    r"|\b(next|following) \w+\b|\b(weeks|months|years|days)\b",
    re.IGNORECASE,
)
"""Words in a heading after which doors have been shut and lamps switched again."""
LIGHT = "light"
"""Subject of what happens to the light of a whole place."""


def inherited_states(reading: Reading) -> dict[int, dict[str, Condition]]:
    """Return, by scene id, the states in which earlier scenes left things and doors.

    A portable thing keeps its state everywhere; a part of a place, and what is gone from it, only there.
    """
    bound = {thing.id for thing in reading.things if thing.kind == "set_piece" or is_fixture(thing)} | {LIGHT}
    now: dict[tuple[int | None, str], Condition] = {}
    last: dict[int, SceneReading] = {}
    before: SceneReading | None = None
    found: dict[int, dict[str, Condition]] = {}
    for _, scene, root, units in _visits(reading):
        used = _things_in_action(units)
        for key in list(now):
            since = before if key[0] is None else last.get(root)
            if key[0] in (None, root) and since is not None and _time_passes(since, scene):
                now[key] = now[key].only(_LASTING)
            if key[0] == root and key[1] in used:
                now[key] = now[key].only({*THING_STATES} - {"gone"})
        here = {thing: condition for (place, thing), condition in now.items() if place in (None, root)}
        found[scene.id] = {thing: condition for thing, condition in here.items() if condition.states}
        for change in (change for unit in units for change in unit.changes):
            told = _state_values(change)
            key = root if change.subject in bound or told.state == "gone" else None, change.subject
            now[key] = now.get(key, Condition()).after(*told)
        last[root] = before = scene
    return found


def _state_values(change: StateChange) -> StateValues:
    """Return the state that a change leaves; of the light of a place ``on`` or ``off``, none if its lamps stay."""
    if change.subject != LIGHT:
        return state_values(change.state)
    light = light_change(change.state)
    return StateValues(light.lamps or "" if light is not None else "")


def _visits(reading: Reading) -> Iterator[tuple[int, SceneReading, int, list[Unit]]]:
    """Yield each scene with its index, the id of the first scene in its place, and its units."""
    roots: dict[int, int] = {}
    units_of: defaultdict[int, list[Unit]] = defaultdict(list)
    for unit in reading.units:
        units_of[unit.scene].append(unit)
    for index, scene in enumerate(reading.scenes):
        roots[scene.id] = roots.get(scene.reference or scene.id, scene.id)
        yield index, scene, roots[scene.id], units_of[index]


def _things_in_action(units: Iterable[Unit]) -> set[str]:
    """Return the things that the action of a scene shows or uses."""
    told = {thing for unit in units for thing in unit.things if unit.kind == "action" and thing not in unit.absent}
    used = {name for unit in units for deed in unit.deeds for name in (deed.prop, deed.target) if name}
    return told | used


def _time_passes(since: SceneReading, scene: SceneReading) -> bool:
    """Whether so much time passes between two scenes that doors are shut and lamps switched again."""
    words = f"{scene.heading} {scene.time_written}"
    return since.time != scene.time or _LATER_DAY.search(words) is not None


_RESTING_KINDS = ("on", "in", "under")


def inherited_positions(reading: Reading) -> dict[int, list[Relation]]:
    """Return, by scene id, where things are that an earlier scene in the same place put down."""
    props = {thing.id for thing in reading.things if thing.kind == "prop"}
    lying: dict[int, dict[str, Relation]] = {}
    found: dict[int, list[Relation]] = {}
    where: dict[str, set[int]] = {}
    stated_in: dict[int, list[Relation]] = {}
    for index, relation in reading.relations:
        stated_in.setdefault(index, []).append(relation)
    for index, scene, root, units in _visits(reading):
        here = lying.setdefault(root, {})
        found[scene.id] = list(here.values())
        for relation in stated_in.get(index, ()):
            if relation.asset_id in props and _update_positions(relation, here):
                where.setdefault(relation.asset_id, set()).add(root)
        last = {deed.prop: deed.motion for unit in units for deed in unit.deeds if deed.prop}
        for thing, motion in last.items():
            kept = where.get(thing, set()) & {root} if motion == "put_down" else set[int]()
            for other in where.get(thing, set()) - kept:
                del lying[other][thing]
            where[thing] = kept
    return found


def _update_positions(relation: Relation, here: dict[str, Relation]) -> bool:
    """Note where a thing is put; beside another it is where that is. Return whether it is on, in or under."""
    beside = here.get(relation.anchor_asset_id)
    if relation.kind in _RESTING_KINDS:
        here[relation.asset_id] = relation
    elif relation.kind == "next_to" and beside:
        here[relation.asset_id] = beside.model_copy(update={"asset_id": relation.asset_id})
    else:
        return False
    return True


_BRINGING_VERBS = lexicon.words("bringing_verbs")
"""Verbs of people who come in with a thing."""
_DELIVERY_VERBS = frozenset({"bring", "deliver", "fetch", "serve"})
"""Verbs that say by themselves that the thing was elsewhere."""
_TRAVEL_MOTIONS = frozenset({"drive", "ride"})
_CARRYING_MOTIONS = frozenset({"carry", "hold", "push", "pull"})


def absent_until_brought(units: Sequence[Unit], things: Collection[str]) -> dict[int, set[str]]:
    """Return, by the start of each unit of a scene, the things that arrive only later.

    A reading that tells itself when a thing is absent is kept, and so is a thing that was seen before.

    Args:
        units: Units of one scene, in order.
        things: Ids of what can arrive: props and vehicles.
    """
    told = {thing for unit in units for thing in unit.absent}
    known: set[str] = set()
    missing: dict[int, set[str]] = {}
    for index, unit in enumerate(units):
        for thing in sorted(_arriving_things(unit) & {*things} - known - told):
            for earlier in units[:index]:
                missing.setdefault(earlier.start, set()).add(thing)
        if unit.kind == "action":
            known |= {*unit.things} | {name for deed in unit.deeds for name in (deed.prop, deed.target) if name}
        known |= {*unit.spots} | {thing for held in unit.held.values() for thing in held}
    return missing


def _arriving_things(unit: Unit) -> set[str]:
    """Return the things that arrive in a unit."""
    found = {change.subject for change in unit.changes if change.state == "there"}
    for person in unit.entering:
        found |= {*unit.held.get(person, ())} | {*unit.grips.get(person, {})}
    for deed in unit.deeds:
        names = {name for name in (deed.prop, deed.target) if name}
        verb = deed.verb.split()[0] if deed.verb else ""
        comes_in = deed.actor in unit.entering
        if comes_in and deed.motion in _TRAVEL_MOTIONS:
            found |= names
        elif (comes_in and (deed.motion in _CARRYING_MOTIONS or verb in _BRINGING_VERBS)) or verb in _DELIVERY_VERBS:
            found |= {deed.prop} if deed.prop else names
    return found
