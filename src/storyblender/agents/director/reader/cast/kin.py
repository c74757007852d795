"""Relatives: whether ``her uncle`` is one of the cast already, and which people are wife, son or uncle of which."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.agents.director.reader.language.person_nouns import PersonNoun
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_PARENTS_SIBLING = {"brother": "uncle", "sister": "aunt"}
"""``his brother`` may be what a child calls uncle."""
_ANCESTORS = frozenset({"grandfather", "grandmother"})
_COMING = frozenset({"came", "comes", "entered", "enters", "arrived", "arrives", "appeared", "appears", "burst"})


def is_known_relative(roster: Roster, phrase: PersonNoun, at: int, after: str, text: str) -> bool:
    """Whether a noun for kin that occurs once means a person who has a name.

    Args:
        roster: The cast so far; who is known by their relation answers to it from now on.
        phrase: The noun with ``his`` or ``her``.
        at: Its offset in the script.
        after: What follows it.
        text: The script.
    """
    noun = phrase.noun
    for person in roster.people:
        if person.role and person.role == _PARENTS_SIBLING.get(noun) and not phrase.plural:
            roster.add_alias(person, noun)
            return True
    often = len(re.findall(rf"\b{noun}\b", text)) > 1
    named = _possible_relatives(roster, phrase)
    following = re.match(r"\s+(?:\w+ly )?(\w+)", after)
    verb = following.group(1) if following else ""
    acts = form_kind(verb) in ("past", "3sg", "aux")
    if noun in _PARENTS_SIBLING:
        before = [person for person in named if person.first < at]
        if often or not acts or verb in _COMING or not before:
            return False
        roster.add_alias(before[-1], noun)
        return True
    if noun not in lexicon.CONVERSE_KIN | {"cousin": ()} or often or len(roster.people) < 2:
        return False
    return not acts or (bool(named) and noun not in _ANCESTORS)


def _possible_relatives(roster: Roster, phrase: PersonNoun) -> list[Person]:
    """Return the named people of that gender who are not the one called ``his`` or ``her``."""
    gender = lexicon.gender_of_word(phrase.noun)
    named = [p for p in roster.people if p.kind == "human" and not p.role and p.gender == gender]
    return named[:-1] if lexicon.PRONOUNS.get(phrase.determiner) == gender else named


_HUSBANDS, _WIVES = ("mr", "sir", "lord", "monsieur", "herr"), ("mrs", "lady", "madame", "frau")
_COUPLE = dict.fromkeys(_HUSBANDS, "husband") | dict.fromkeys(_WIVES, "wife")
_PARENT = dict.fromkeys(_HUSBANDS, "father") | dict.fromkeys(_WIVES, "mother")
_CHILD: dict[Gender, str] = {"male": "son", "female": "daughter"}
_SIBLING_NOUNS = {"brother": ("brother", "sister"), "sister": ("brother", "sister")}
_FAMILY = re.compile(r"\b(?:father|mother|son|daughter|parents)\b", re.IGNORECASE)


class Kinship(NamedTuple):
    """A kinship told by a phrase such as ``his wife, Anna``."""

    at: int
    determiner: str
    noun: str
    person: Person


def mentions_family(told: str) -> bool:
    """Whether a story speaks of parents and children, so that one surname may be several people's."""
    return _FAMILY.search(told) is not None


@rule("people.surname")
def link_surnames(roster: Roster) -> None:
    """Link people with one surname: Mr. White is the husband of Mrs. White, Herbert White their son."""
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
                roster.remove_aliases(person, _surname(head))
        if any(_title(person) in _COUPLE for person in family):
            roster.add_alias(head, _COUPLE[title])
        children = [person for person in family if not _title(person)]
        for child in children:
            roster.add_alias(child, _CHILD.get(child.gender, "child"))
        if children:
            roster.add_alias(head, _PARENT[title])


@rule("people.kin")
def link_kin(roster: Roster, kinships: Sequence[Kinship], names: Sequence[tuple[int, str]]) -> None:
    """Give kin a role: the person named last before ``his niece Clara`` is her uncle.

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
            for converse in _SIBLING_NOUNS.get(kinship.noun) or lexicon.CONVERSE_KIN.get(kinship.noun, ()):
                if lexicon.gender_of_word(converse) == owner.gender:
                    roster.add_alias(owner, converse)


def _title(person: Person) -> str:
    """Return the title in a person's name, or an empty string."""
    first = bare(person.name).split()[0].strip(".")
    return first if first in lexicon.TITLES else ""


def _surname(person: Person) -> str:
    """Return the surname of a person, or an empty string."""
    words = bare(person.name).split()
    return words[-1] if len(words) > 1 else ""
