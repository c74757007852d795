"""Props that arrive during a scene: a prop that is brought, delivered or driven up is hidden before that."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from storyblender.agents.director.reading import Unit

_BRINGING = frozenset({
    "bring", "deliver", "fetch", "wheel", "haul", "drag", "carry", "serve", "produce", "lug", "bear", "roll", "push",
})  # fmt: skip
"""Verbs of people who come in with a thing."""
_BROUGHT_AT_ONCE = frozenset({"bring", "deliver", "fetch", "serve"})
"""Verbs that say by themselves that the thing was elsewhere."""
_DRIVEN = frozenset({"drive", "ride"})
_WITH = frozenset({"carry", "hold", "push", "pull"})


def not_there_yet(units: Sequence[Unit], things: Collection[str]) -> dict[int, set[str]]:
    """Return, for each unit of a scene by its start, the things that come only later.

    A reading that says itself when a thing is absent is left alone, and so is a thing that was told before.

    Args:
        units: Of one scene, in order.
        things: Ids of what can come: props and vehicles.
    """
    told = {thing for unit in units for thing in unit.absent}
    known: set[str] = set()
    missing: dict[int, set[str]] = {}
    for index, unit in enumerate(units):
        for thing in sorted(_coming(unit) & {*things} - known - told):
            for earlier in units[:index]:
                missing.setdefault(earlier.start, set()).add(thing)
        if unit.kind == "action":
            known |= {*unit.things} | {name for deed in unit.deeds for name in (deed.prop, deed.target) if name}
        known |= {*unit.spots} | {thing for held in unit.held.values() for thing in held}
    return missing


def _coming(unit: Unit) -> set[str]:
    """Return what comes into the scene in a unit."""
    found = {change.subject for change in unit.changes if change.state == "there"}
    for person in unit.entering:
        found |= {*unit.held.get(person, ())} | {*unit.grips.get(person, {})}
    for deed in unit.deeds:
        names = {name for name in (deed.prop, deed.target) if name}
        verb = deed.verb.split()[0] if deed.verb else ""
        comes_in = deed.actor in unit.entering
        if comes_in and deed.motion in _DRIVEN:
            found |= names
        elif (comes_in and (deed.motion in _WITH or verb in _BRINGING)) or verb in _BROUGHT_AT_ONCE:
            found |= {deed.prop} if deed.prop else names
    return found
