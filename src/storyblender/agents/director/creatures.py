"""Animals and robots: which are cast as upright characters with hands, and which are shown by catalog props.

A prop has the size and colour that the script gives the animal or robot.
"""

from __future__ import annotations

import re
from typing import Final

from storyblender.agents.director import lexicon
from storyblender.agents.director.casting import animal_species, garments_in, introduction_words
from storyblender.agents.director.lexicon import MACHINES
from storyblender.agents.director.motion_families import HANDS
from storyblender.agents.director.reading import Person, Reading, Thing
from storyblender.agents.director.wording import modifiers_of, one_line
from storyblender.catalog.props import PROPS

_COMPARED_SIZE: Final = re.compile(
    r"\b(?:the size of|as (?:big|large|small|tall|high) as|no (?:bigger|larger|taller) than)"
    r" (?:an? |the |his |her )?((?:[a-z-]+ ?){1,3})",
    re.IGNORECASE,
)
_CATALOG_HEIGHTS: Final[dict[str, float]] = {
    word: entry.size[2] for entry in PROPS.values() for word in (*entry.tags, entry.name)
}
"""What the catalog builds -> metres."""
_BEFORE: Final = 30
"""Characters before a name searched for the words that state its kind."""
_REACH: Final = 70
"""Characters after a thing's name searched for the words that state its size."""


def is_creature(person: Person, reading: Reading) -> bool:
    """Whether a character is an animal on its own feet or a machine, and not a figure on two legs.

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
    """Return a phrase for an animal or a robot, e.g. ``sleeping brown dog`` if it only sleeps.

    Args:
        person: One of ``reading.people``.
        reading: The reading of the script.
    """
    text, noun = reading.screenplay.text, person.role or person.name
    told = [unit.posture[person.id][0] for unit in reading.units if person.id in unit.posture]
    sleeping = "sleeping" if told and {*told} <= {"asleep", "lie"} else ""
    named = re.compile(rf"\b{re.escape(noun)}(?:e?s)?\b", re.IGNORECASE).search(text, max(0, person.first - _BEFORE))
    thing = Thing(person.id, noun, first=named.start() if named else person.first)
    words = f"{modifiers_of(thing, text)} {' '.join(person.build)}"
    looks = " ".join(dict.fromkeys(word for word in words.lower().split() if word not in (noun, "a", "an", "the")))
    return one_line(f"{compared_size(introduction_words(person, text))} {sleeping} {looks} {noun}")


def size_in_script(thing: Thing, text: str) -> str:
    """Return the size that the script gives a thing at its first mention, as in ``compared_size``.

    Args:
        thing: A prop or a set piece.
        text: The script.
    """
    after = text[thing.first : thing.first + _REACH]
    return compared_size(re.split(r"[.;:!?()\n]", after)[0])


def compared_size(words: str) -> str:
    """Return the height in ``the size of a goat`` as ``110 cm tall``; empty if the catalog has no such thing."""
    found = _COMPARED_SIZE.search(words)
    likened = found[1].lower().split() if found else []
    for count in range(len(likened), 0, -1):
        height = _CATALOG_HEIGHTS.get(" ".join(likened[:count]))
        if height:
            return f"{100 * height:.0f} cm tall"
    return ""


_MOUTH_MOTIONS: Final = lexicon.words("mouth_motions")
"""Verbs of handling that a beak or a claw can do as well."""
_PARROTS: Final = frozenset({"parrot", "macaw", "cockatoo", "parakeet", "budgie", "budgerigar"})
_PETS: Final = frozenset({"cat", "dog", "bird", "parrot", "owl", "crow", "hen", "rabbit", "mouse", "squirrel"})
"""Animals that lie on beds and perch on chairs as plain animals."""
_TACK: Final = lexicon.words("tack")
"""Things that people put on animals."""
_HAND_GRIPS: Final = frozenset({"right", "left", "both", "under_arm", "shoulder"})
_RESTING_POSTURES: Final = frozenset({"sit", "lie", "asleep", "lean"})


def acts_like_a_person(person: Person, reading: Reading) -> bool:
    """Whether an animal or a robot speaks, wears clothes, uses hands or lives among furniture.

    In a story whose animals talk to each other, every animal that acts is cast. A ridden or led animal stays an
    animal, unless it speaks; so does a parrot that only speaks.

    Args:
        person: An animal or a robot.
        reading: The reading of the script.
    """
    handles = _uses_hands(person, reading)
    species = animal_species(person)
    if person.speaks:
        words = {*person.role.lower().split(), *person.name.lower().split()}
        return handles or _is_dressed(person) or (species is not None and not _PARROTS & words)
    if _is_ridden_or_led(person, reading):
        return False
    if _is_dressed(person) or handles:
        return True
    if species is None:
        return False
    if species.words[0] not in _PETS and _sits_on_furniture(person, reading):
        return True
    fellows = [
        each for each in reading.people if each.kind == "animal" and each.speaks and animal_species(each) is not None
    ]
    return len(fellows) > 1 and any(deed.actor == person.id for unit in reading.units for deed in unit.deeds)


def _is_dressed(person: Person) -> bool:
    """Whether the description of an animal names clothes besides a coat of fur or tack."""
    worn = [words for words in person.outfit if not _TACK & {*words.lower().split()}]
    return bool(garments_in(", ".join(worn)))


def _uses_hands(person: Person, reading: Reading) -> bool:
    """Whether an animal does what no mouth or paw can do, carries in a hand, or puts a thing on."""
    names = {thing.id: thing.name for thing in reading.things}
    for unit in reading.units:
        for deed in unit.deeds:
            if deed.actor == person.id and deed.prop and deed.motion in HANDS - _MOUTH_MOTIONS:
                return True
        for thing, grip in unit.grips.get(person.id, {}).items():
            tack = _TACK & {*names.get(thing, thing).lower().split()}
            if grip in _HAND_GRIPS or (grip == "worn" and not tack):
                return True
    return False


def _is_ridden_or_led(person: Person, reading: Reading) -> bool:
    """Whether another character rides the animal, or leads it on a leash."""
    ridden = any(place == ("ride", person.id) for unit in reading.units for place in map(tuple, unit.posture.values()))
    ridden = ridden or any(
        deed.motion == "ride" and person.id in (deed.target, deed.prop) for unit in reading.units for deed in unit.deeds
    )
    return ridden or any(tether.held == person.id for unit in reading.units for tether in unit.tethers)


def _sits_on_furniture(person: Person, reading: Reading) -> bool:
    """Whether the animal sits or lies on or in a thing, as people do."""
    things = {thing.id for thing in reading.things}
    places = [unit.posture[person.id] for unit in reading.units if person.id in unit.posture]
    return any(posture in _RESTING_POSTURES and support in things for posture, support in places)
