"""Whether ``her uncle`` or ``his sister`` is one of the cast already."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.agents.director.reader.language.person_nouns import PersonNoun
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import Person

_SIBLINGS = {"brother": "uncle", "sister": "aunt"}
"""``his brother`` may be what a child calls uncle."""
_ANCESTORS = frozenset({"grandfather", "grandmother"})
_COMING = frozenset({"came", "comes", "entered", "enters", "arrived", "arrives", "appeared", "appears", "burst"})


def is_known_relative(roster: Roster, phrase: PersonNoun, at: int, after: str, text: str) -> bool:
    """Whether a noun for kin that comes up once means somebody who has a name.

    Args:
        roster: The cast so far; who is known by their relation answers to it from now on.
        phrase: The noun with ``his`` or ``her``.
        at: Its offset in the script.
        after: What follows it.
        text: The script.
    """
    noun = phrase.noun
    for person in roster.people:
        if person.role and person.role == _SIBLINGS.get(noun) and not phrase.plural:
            roster.call(person, noun)
            return True
    often = len(re.findall(rf"\b{noun}\b", text)) > 1
    named = _who_may_be(roster, phrase)
    following = re.match(r"\s+(?:\w+ly )?(\w+)", after)
    verb = following.group(1) if following else ""
    acts = form_kind(verb) in ("past", "3sg", "aux")
    if noun in _SIBLINGS:
        before = [person for person in named if person.first < at]
        if often or not acts or verb in _COMING or not before:
            return False
        roster.call(before[-1], noun)
        return True
    if noun not in lexicon.CONVERSE_KIN | {"cousin": ()} or often or len(roster.people) < 2:
        return False
    return not acts or (bool(named) and noun not in _ANCESTORS)


def _who_may_be(roster: Roster, phrase: PersonNoun) -> list[Person]:
    """Everybody named of that gender, but for who is ``his`` or ``her``."""
    gender = lexicon.gender_of_word(phrase.noun)
    named = [p for p in roster.people if p.kind == "human" and not p.role and p.gender == gender]
    return named[:-1] if lexicon.PRONOUNS.get(phrase.determiner) == gender else named
