"""Passes over a finished reading: the Director's words for motions, a copy of a shared thing for each user, scenes in
the order of their units.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby

from storyblender.agents.director.reading import Deed, Reading, SceneReading, Thing, Unit
from storyblender.catalog.motions import MOTIONS

Owners = dict[tuple[str, str], str]
"""Person and thing -> the copy that is theirs."""

_DIRECTED = {
    motion.key: motion.directs[0] for motion in MOTIONS.values() if motion.directs and motion.key not in motion.directs
}
"""Key of the catalogue -> the word for it that the Director's families of motions have: ``rise`` -> ``stand_up``."""


def use_directed_motions(reading: Reading) -> Reading:
    """Return the reading with the Director's words for motions; corrected readings and models name keys as well."""
    return replace(reading, units=[with_directed_motions(unit) for unit in reading.units])


def with_directed_motions(unit: Unit) -> Unit:
    """Return a unit with the Director's words for motions."""
    if _DIRECTED.keys().isdisjoint({*unit.activities.values(), *(deed.motion for deed in unit.deeds)}):
        return unit
    activities = {person: _DIRECTED.get(motion, motion) for person, motion in unit.activities.items()}
    deeds = [replace(deed, motion=_DIRECTED.get(deed.motion, deed.motion)) for deed in unit.deeds]
    return replace(unit, activities=activities, deeds=deeds)


def copy_shared_things(reading: Reading) -> Reading:
    """Return the reading with a copy of a plural thing for each person who uses it in one sentence.

    Groups must be people already.
    """
    copies: list[Thing] = []
    owners: Owners = {}
    taken = {each.id for each in (*reading.people, *reading.things)}
    shared = _shared_uses(reading.units)
    for thing in reading.things:
        sharing = [(unit, who) for unit, who in shared.get(thing.id, ()) if thing.kind == "prop"]
        users = list(dict.fromkeys(each for unit, who in sharing if _is_plural(thing, unit) for each in who))
        for number, who in enumerate(users[1:], 2):
            copy = replace(thing, id=f"{thing.id[:60]}_{number}")
            if copy.id not in taken:
                owners[who, thing.id] = copy.id
                copies.append(copy)
    if not copies:
        return reading
    return replace(
        reading, things=[*reading.things, *copies], units=[_with_copies(unit, owners) for unit in reading.units]
    )


def _shared_uses(units: Sequence[Unit]) -> dict[str, list[tuple[Unit, list[str]]]]:
    """Return the units in which several people use a thing, with those people, by thing."""
    found: dict[str, list[tuple[Unit, list[str]]]] = {}
    for unit in units:
        users: dict[str, list[str]] = {}
        for deed in unit.deeds:
            if deed.prop and deed.actor not in users.setdefault(deed.prop, []):
                users[deed.prop].append(deed.actor)
        for thing, who in users.items():
            if len(who) > 1:
                found.setdefault(thing, []).append((unit, who))
    return found


def _is_plural(thing: Thing, unit: Unit) -> bool:
    """Whether the words of a unit name a thing in the plural."""
    return re.search(rf"\b{re.escape(thing.name.split()[-1])}e?s\b", unit.text, re.IGNORECASE) is not None


def _with_copies(unit: Unit, owners: Owners) -> Unit:
    """Return a unit in which everybody uses their own copy."""

    def own(deed: Deed) -> Deed:
        prop, target = deed.prop or "", deed.target or ""
        return replace(
            deed,
            prop=owners.get((deed.actor, prop), deed.prop),
            target=owners.get((deed.actor, target), deed.target),
        )

    return replace(
        unit,
        deeds=[own(deed) for deed in unit.deeds],
        held={who: [owners.get((who, thing), thing) for thing in things] for who, things in unit.held.items()},
        grips={
            who: {owners.get((who, thing), thing): grip for thing, grip in grips.items()}
            for who, grips in unit.grips.items()
        },
    )


def order_scenes_by_units(reading: Reading) -> Reading:
    """Return the reading with scenes in the order of units; a scene that is cut away from is split.

    The parts keep the number that the script gives their scene, and share its set. Where any scene is split, scenes
    without units are left out.
    """
    runs = [list(run) for _, run in groupby(reading.units, key=lambda unit: unit.scene)]
    order = [run[0].scene for run in runs]
    if order == sorted(set(order)):
        return reading
    scenes: list[SceneReading] = []
    units: list[Unit] = []
    first: dict[int, int] = {}
    for index, run in enumerate(runs):
        scene = reading.scenes[run[0].scene]
        end = runs[index + 1][0].start if index + 1 < len(runs) else max(scene.end, run[-1].end)
        earlier = first.get(scene.id)
        reference = scenes[earlier].id if earlier is not None else _new_reference(scene.reference, first)
        first.setdefault(scene.id, index)
        scenes.append(replace(scene, id=index + 1, start=run[0].start, end=end, reference=reference))
        units += [replace(unit, scene=index) for unit in run]
    part = {run[0].scene: index for index, run in reversed([*enumerate(runs)])}
    relations = [(part[scene], relation) for scene, relation in reading.relations if scene in part]
    return replace(reading, scenes=scenes, units=units, relations=relations)


def _new_reference(reference: int | None, first: dict[int, int]) -> int | None:
    """Return the new id of the earlier scene in the same place."""
    return first[reference] + 1 if reference in first else None
