"""Who is no person: animals that do not act like people, and robots, stand on the set as the
catalog's, in the size and colour the script gives."""

from __future__ import annotations

import re
from typing import Final

from storyblender.agents.director.casting import introduction
from storyblender.agents.director.lexicon import MACHINES
from storyblender.agents.director.motion_families import HANDS
from storyblender.agents.director.reading import Person, Reading, Thing
from storyblender.agents.director.wording import modifiers_of, one_line
from storyblender.catalog.props import PROPS
from storyblender.catalog.species import species_of

_LIKENED: Final = re.compile(
    r"\b(?:the size of|as (?:big|large|small|tall|high) as|no (?:bigger|larger|taller) than)"
    r" (?:an? |the |his |her )?((?:[a-z-]+ ?){1,3})",
    re.IGNORECASE,
)
_HEIGHTS: Final[dict[str, float]] = {
    word: entry.size[2] for entry in PROPS.values() for word in (*entry.tags, entry.name)
}
"""What the catalog builds -> metres."""
_BY_MOUTH: Final = frozenset(
    {"take", "pick_up", "hold", "catch", "drop", "give", "put_down", "touch", "search", "open"}
)
"""What of the work of hands a beak or a claw does."""
_PARROTS: Final = frozenset({"parrot", "macaw", "cockatoo", "parakeet", "budgie", "budgerigar"})
_BEFORE: Final = 30
"""Characters before a name in which its kind is told."""
_REACH: Final = 70
"""Characters after a thing's name in which its size is told."""


def is_creature(person: Person, reading: Reading) -> bool:
    """Whether somebody is an animal on its own feet, or a machine that looks like one, and no character on two legs.

    An animal that is dressed, uses its hands or speaks acts like a person, and is cast as one with the head of its
    kind; one whose kind nobody knows, too, if it does more than speak. Only a parrot speaks and stays what it is.

    Args:
        person: One of ``reading.people``.
        reading: What the script says.
    """
    if person.outfit or person.kind == "group":
        return False
    if person.kind != "animal":
        return person.role in MACHINES
    known = species_of(person.role or person.name) is not None and not _PARROTS & {
        *person.role.split(),
        *person.name.split(),
    }
    deeds = (deed for unit in reading.units for deed in unit.deeds if deed.actor == person.id)
    handles = any(deed.prop and deed.motion in HANDS - _BY_MOUTH for deed in deeds)
    return not (person.speaks and (known or handles))


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
