"""Words that can be read on a thing: ``a sign reads "CLOSED"``, and a phone that shows one message, then another."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from storyblender.agents.director.reading import Reading, StateChange, Unit

_READING_VERBS: Final = (
    r"(?:reads?|reading|says?|saying|marked|labell?ed|titled|entitled|bearing|spells?(?: out)?|spelling|written|printed"
    r"|scrawled|stencill?ed|lettered|inscribed|with the words?|the words?|stamped|embroidered|painted)"
)
_QUOTED: Final = r"[\"“‘'](?P<quoted>[^\"”\n]{1,90}?)[\"”’'](?![^\W\d_])"
_CAPITALS: Final = r"(?P<capitals>[A-Z0-9][A-Z0-9'’&!?-]*(?: [A-Z0-9'’&!?-]+){0,7})\b(?![a-z])"
_QUOTED_AFTER_COLON, _CAPITALS_AFTER_COLON = _QUOTED.replace("quoted", "said"), _CAPITALS.replace("capitals", "big")
_WRITTEN: Final = re.compile(
    rf"^[^.!?\n\"“”]{{0,60}}?\b{_READING_VERBS}\b[^.!?\n\"“”‘]{{0,24}}?[:,]?\s*(?:{_QUOTED}|{_CAPITALS})"
    rf"|^[^.!?\n\"“”,;]{{0,30}}?(?::|—|--)\s*(?:{_QUOTED_AFTER_COLON}|{_CAPITALS_AFTER_COLON})"
)
READS_PREFIX: Final = "reads "
"""Start of a change that gives a thing other words; they follow."""
_REACH: Final = 170
"""Characters after a thing's name that are searched for its writing."""


def writing_on(name: str, first: int, text: str) -> str:
    """Return the words that the script puts on a thing at its first mention, or an empty string.

    Args:
        name: The name of the thing, as written.
        first: Offset of its first mention.
        text: The script.
    """
    at = text.find(name.split()[-1], first) if name.split() else -1
    if at < 0 or at - first > _REACH:
        return ""
    found = _WRITTEN.match(text[at + len(name.split()[-1]) : at + _REACH].lstrip("s"))
    words = next((group for group in found.group("quoted", "capitals", "said", "big") if group), "") if found else ""
    return words.strip(" ,.") if len(words.strip(" ,.")) > 1 else ""


def add_writing_changes(reading: Reading) -> Reading:
    """Return a reading in which a change tells wherever new words are read on a thing."""
    text = reading.screenplay.text
    names = {thing.id: thing.name for thing in reading.things}
    written = {thing.id: thing.writing or writing_on(thing.name, thing.first, text) for thing in reading.things}
    units: list[Unit] = []
    for unit in reading.units:
        told = {change.subject: change.state for change in unit.changes if change.state.startswith(READS_PREFIX)}
        fresh: list[StateChange] = []
        for thing in unit.things if unit.kind == "action" else ():
            words = writing_on(names.get(thing, ""), unit.start, text[: unit.end])
            if thing in written and thing not in told and words not in ("", written[thing]):
                fresh.append(StateChange(thing, f"{READS_PREFIX}{words}", unit.start))
                written[thing] = words
        written |= {thing: state.removeprefix(READS_PREFIX) for thing, state in told.items()}
        units.append(replace(unit, changes=[*unit.changes, *fresh]) if fresh else unit)
    return replace(reading, units=units)
