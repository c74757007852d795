"""Characters that are not cast as people: animals that do not act like people, and robots, shown by catalog
props in the size and colour the script gives."""

from __future__ import annotations

import re
from typing import Final

from storyblender.agents.director.acting_animals import acts_like_a_person
from storyblender.agents.director.casting import introduction
from storyblender.agents.director.lexicon import MACHINES
from storyblender.agents.director.reading import Person, Reading, Thing
from storyblender.agents.director.wording import modifiers_of, one_line
from storyblender.catalog.props import PROPS

_LIKENED: Final = re.compile(
    r"\b(?:the size of|as (?:big|large|small|tall|high) as|no (?:bigger|larger|taller) than)"
    r" (?:an? |the |his |her )?((?:[a-z-]+ ?){1,3})",
    re.IGNORECASE,
)
_HEIGHTS: Final[dict[str, float]] = {
    word: entry.size[2] for entry in PROPS.values() for word in (*entry.tags, entry.name)
}
"""What the catalog builds -> metres."""
_BEFORE: Final = 30
"""Characters before a name in which its kind is told."""
_REACH: Final = 70
"""Characters after a thing's name in which its size is told."""


def is_creature(person: Person, reading: Reading) -> bool:
    """Return whether a character is an animal on its own feet or a machine, and not a figure on two legs.

    Args:
        person: One of ``reading.people``.
        reading: The reading of the script.
    """
    if person.kind == "group":
        return False
    if person.kind != "animal" and (person.outfit or person.role not in MACHINES):
        return False
    return not acts_like_a_person(person, reading)


def describe_creature(person: Person, reading: Reading) -> str:
    """Return the phrase for an animal or a robot, e.g. ``sleeping brown dog``, if it does nothing but lie and sleep.

    Args:
        person: One of ``reading.people``.
        reading: What the script says.
    """
    text, noun = reading.screenplay.text, person.role or person.name
    told = [unit.posture[person.id][0] for unit in reading.units if person.id in unit.posture]
    sleeping = "sleeping" if told and {*told} <= {"asleep", "lie"} else ""
    named = re.compile(rf"\b{re.escape(noun)}(?:e?s)?\b", re.IGNORECASE).search(text, max(0, person.first - _BEFORE))
    thing = Thing(person.id, noun, first=named.start() if named else person.first)
    words = f"{modifiers_of(thing, text)} {' '.join(person.build)}"
    looks = " ".join(dict.fromkeys(word for word in words.lower().split() if word not in (noun, "a", "an", "the")))
    return one_line(f"{likened_size(introduction(person, text))} {sleeping} {looks} {noun}")


def size_of(thing: Thing, text: str) -> str:
    """Return the size that a script gives a thing where it first names it, as in ``likened_size``.

    Args:
        thing: A prop or a set piece.
        text: The script.
    """
    after = text[thing.first : thing.first + _REACH]
    return likened_size(re.split(r"[.;:!?()\n]", after)[0])


def likened_size(words: str) -> str:
    """Return a height for ``the size of a goat``: ``110 cm tall``; empty where nothing the catalog has is named."""
    found = _LIKENED.search(words)
    likened = found[1].lower().split() if found else []
    for count in range(len(likened), 0, -1):
        height = _HEIGHTS.get(" ".join(likened[:count]))
        if height:
            return f"{100 * height:.0f} cm tall"
    return ""
