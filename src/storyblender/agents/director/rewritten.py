"""Screens and sheets on which other words are read than before: a phone that shows one message, then another."""

from __future__ import annotations

from dataclasses import replace

from storyblender.agents.director.reading import Reading, StateChange, Unit
from storyblender.agents.director.written import writing_on
from storyblender.catalog.states import READS


def note_new_writing(reading: Reading) -> Reading:
    """Return a reading in which a change says so wherever other words are read on a thing than before.

    Args:
        reading: Left as it is.
    """
    text = reading.screenplay.text
    names = {thing.id: thing.name for thing in reading.things}
    written = {thing.id: thing.writing or writing_on(thing.name, thing.first, text) for thing in reading.things}
    units: list[Unit] = []
    for unit in reading.units:
        told = {change.subject: change.state for change in unit.changes if change.state.startswith(READS)}
        fresh: list[StateChange] = []
        for thing in unit.things if unit.kind == "action" else ():
            words = writing_on(names.get(thing, ""), unit.start, text[: unit.end])
            if thing in written and thing not in told and words not in ("", written[thing]):
                fresh.append(StateChange(thing, f"{READS}{words}", unit.start))
                written[thing] = words
        written |= {thing: state.removeprefix(READS) for thing, state in told.items()}
        units.append(replace(unit, changes=[*unit.changes, *fresh]) if fresh else unit)
    return replace(reading, units=units)
