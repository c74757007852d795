"""Who is first a man, a nun or my sister and then has a name: ``Her brother came in, soaked. Goran sat down``."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.morphology import form_kind
from storyblender.agents.director.reader.roster import Roster, bare
from storyblender.agents.director.reading import Person

_SOON, _VERY_SOON = 900, 400
"""Characters from ``a man`` to the name he has a title in, and from ``her brother`` to his."""
_SOMEBODY = frozenset({"man", "woman", "lady", "gentleman"})
_POSSESSED = re.compile(r"(?:my|our|his|her|their)\b", re.IGNORECASE)
_INDEFINITE = re.compile(r"an?\b", re.IGNORECASE)
_SPEAKING = re.compile(r"[,.!?]?[\"”’'] \w+ $")


def name_the_nameless(roster: Roster, text: str) -> None:
    """Join somebody introduced by a noun with the name that turns up soon after without any introduction.

    Args:
        roster: The cast of a story; whoever is joined leaves it under the old name.
        text: The script.
    """
    for person in sorted(roster.people, key=lambda person: person.first):
        if person.role == bare(person.name) or person is roster.narrator or person.kind != "human":
            continue
        nameless = [other for other in roster.people if _is_nameless(other) and other.first < person.first]
        for other in sorted(nameless, key=lambda other: -other.first):
            if _may_be(other, person, text):
                _join(roster, person, other)
                break


def _is_nameless(person: Person) -> bool:
    return person.role == bare(person.name) and person.kind == "human" and person.count == 1


def _may_be(nameless: Person, named: Person, text: str) -> bool:
    """Whether a name can be that of somebody without one: by gender, title, distance and how both are told."""
    distance, gender = named.first - nameless.first, nameless.gender
    if "unknown" not in (gender, named.gender) and gender != named.gender:
        return False
    title, noun = bare(named.name).split()[0].strip("."), nameless.role
    if title in lexicon.TITLES and " " in named.name:
        ranked = title in lexicon.RANKS.get(noun, ())
        plain = noun in _SOMEBODY and title not in lexicon.KIN
        return (ranked or plain) and distance < _SOON and _INDEFINITE.match(text, nameless.first) is not None
    owned = noun in lexicon.KIN and _POSSESSED.match(text, nameless.first) is not None
    return owned and distance < _VERY_SOON and _does_something(named, text)


def _does_something(named: Person, text: str) -> bool:
    """Whether a name opens a sentence, or a verb of saying stands before it."""
    before, after = text[max(0, named.first - 24) : named.first], text[named.first + len(named.name) :][:24]
    opens = re.search(r"(?:[.!?][\"”]?\s+|\n)$", before) or before.endswith(("” ", '" ')) or _SPEAKING.search(before)
    verb = re.match(r"\s+([a-z]+)", after)
    return opens is not None and (
        (verb is not None and form_kind(verb.group(1)) in ("past", "base", "aux")) or after[:1] in ",."
    )


def _join(roster: Roster, named: Person, nameless: Person) -> None:
    for alias in nameless.aliases:
        roster.call(named, alias)
    named.first = min(named.first, nameless.first)
    named.role = named.role or nameless.role
    if named.gender == "unknown":
        named.gender = nameless.gender
    for look in ("age", "hair", "face", "outfit", "build"):
        if not getattr(named, look):
            setattr(named, look, getattr(nameless, look))
    roster.people.remove(nameless)


def call_by_nouns(roster: Roster, text: str) -> None:
    """``A MOVER``, later ``the mover``: the name is a noun for what they do, though no list knows it."""
    for person in roster.people:
        name = person.name.lower()
        known = name in lexicon.FIRST_NAMES or lexicon.noun_class(name) != "unknown"
        if person.role or known or not name.isalpha():
            continue
        shown = re.search(rf"\b(?i:an?|the) (?:[\w-]+ ){{0,2}}{name.upper()}\b", text)
        if shown and re.search(rf"\bthe (?:[a-z-]+ )?{name}\b", text):
            person.role = name
