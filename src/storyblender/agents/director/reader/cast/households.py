"""Families of a story: who is whose wife, son or uncle, from a surname they share or from ``his wife, Anna,``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_HUSBANDS, _WIVES = ("mr", "sir", "lord", "monsieur", "herr"), ("mrs", "lady", "madame", "frau")
_COUPLE = dict.fromkeys(_HUSBANDS, "husband") | dict.fromkeys(_WIVES, "wife")
_PARENT = dict.fromkeys(_HUSBANDS, "father") | dict.fromkeys(_WIVES, "mother")
_CHILD: dict[Gender, str] = {"male": "son", "female": "daughter"}
_SIBLINGS = {"brother": ("brother", "sister"), "sister": ("brother", "sister")}
_FAMILY = re.compile(r"\b(?:father|mother|son|daughter|parents)\b", re.IGNORECASE)


class Kinship(NamedTuple):
    """``his wife, Anna``: somebody is somebody's kin."""

    at: int
    determiner: str
    noun: str
    person: Person


def is_family(told: str) -> bool:
    """Whether a story speaks of parents and children, so that one surname may be several people's."""
    return _FAMILY.search(told) is not None


@rule("people.surname")
def link_surnames(roster: Roster) -> None:
    """Mr. White is the husband of Mrs. White, Herbert White their son."""
    families: dict[str, list[Person]] = {}
    for person in roster.people:
        families.setdefault(_surname(person), []).append(person)
    for head in roster.people:
        title = _title(head)
        if title not in _COUPLE:
            continue
        family = [person for person in families[_surname(head)] if person is not head]
        if title in _HUSBANDS:
            for person in family:
                roster.call_no_longer(person, _surname(head))
        if any(_title(person) in _COUPLE for person in family):
            roster.call(head, _COUPLE[title])
        children = [person for person in family if not _title(person)]
        for child in children:
            roster.call(child, _CHILD.get(child.gender, "child"))
        if children:
            roster.call(head, _PARENT[title])


@rule("people.kin")
def link_kin(roster: Roster, kinships: Sequence[Kinship], names: Sequence[tuple[int, str]]) -> None:
    """Whoever was named last before ``his niece Clara`` is her uncle.

    Args:
        roster: The cast.
        kinships: Kin who were given a name, in reading order.
        names: Where names stand.
    """
    for kinship in kinships:
        gender = lexicon.PRONOUNS.get(kinship.determiner)
        owners = [person for at, name in names if at < kinship.at for person in roster.find(name)]
        owners = [person for person in owners if person is not kinship.person]
        if gender == "plural":
            owners = list({person.id: person for person in reversed(owners)}.values())[:2]
        else:
            owners = [person for person in owners if person.gender in (gender, "unknown")][-1:]
        for owner in owners:
            if owner.gender == "unknown" and gender in ("male", "female"):
                owner.gender = "male" if gender == "male" else "female"
            for converse in _SIBLINGS.get(kinship.noun) or lexicon.CONVERSE_KIN.get(kinship.noun, ()):
                if lexicon.gender_of_word(converse) == owner.gender:
                    roster.call(owner, converse)


def _title(person: Person) -> str:
    first = bare(person.name).split()[0].strip(".")
    return first if first in lexicon.TITLES else ""


def _surname(person: Person) -> str:
    words = bare(person.name).split()
    return words[-1] if len(words) > 1 else ""
