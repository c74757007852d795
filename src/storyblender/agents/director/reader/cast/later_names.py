"""Who is first a man, a nun or my sister and then has a name: ``Her brother came in, soaked. Goran sat down``."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person

_SOON, _VERY_SOON = 900, 400
"""Characters from ``a man`` to the name he has a title in, and from ``her brother`` to his."""
_SOMEBODY = frozenset({"man", "woman", "lady", "gentleman"})
_YOUNG = frozenset({"boy", "girl", "child", "youth", "lad"})
_GENERIC = _SOMEBODY | {"fellow", "stranger", "figure"}
_ATTENDANTS = frozenset(
    {"waiter", "waitress", "barman", "bartender", "barmaid", "driver", "coachman", "cabman", "conductor", "porter"}
    | {"guard", "sentry", "doorman", "servant", "maid", "butler", "footman", "cook", "nurse", "clerk", "cashier"}
    | {"landlord", "landlady", "innkeeper", "priest", "vicar", "postman", "policeman", "constable", "captain", "mate"}
    | {"bosun", "pilot", "teacher", "headmaster", "king", "queen", "prisoner", "receptionist", "steward", "pianist"}
)
"""``the waiter`` comes with the place, nobody has to introduce him."""
_COMING = "came|comes|enter(?:ed|s)|arrive[ds]|appear(?:ed|s)|walk(?:ed|s) in|ran|runs|burst|bursts"
_STILL_NEAR = 1500
"""Characters from ``a man`` to ``the surveyor``."""
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
    _call_by_trade(roster, text)


def _call_by_trade(roster: Roster, text: str) -> None:
    """``A man stood on the landing. The surveyor did not look up``: who was never introduced is the man."""
    for person in sorted(roster.people, key=lambda person: person.first):
        trade = person.role
        if not _is_nameless(person) or trade in _GENERIC | _ATTENDANTS | lexicon.KIN | lexicon.YOUNG_NOUNS:
            continue
        if not text[person.first :].lower().startswith("the ") or re.search(rf"\ban? (?:[\w-]+ )?{trade}\b", text):
            continue
        men = [
            other
            for other in roster.people
            if other.role in _GENERIC
            and _is_nameless(other)
            and 0 < person.first - other.first < _STILL_NEAR
            and (person.gender in ("unknown", other.gender) or other.gender == "unknown")
        ]
        if len(men) == 1 and not _told_together(men[0], trade, text):
            _join(roster, person, men[0])
            person.role = men[0].role  # he stays the man he was before


def _told_together(nameless: Person, trade: str, text: str) -> bool:
    """Whether they are two people: a paragraph has both, or one of them comes in."""
    low = text.lower()
    called = re.compile(rf"\b(?:an?|the|that|this) (?:{'|'.join(map(re.escape, nameless.aliases))})\b")
    if any(called.search(each) and re.search(rf"\b{trade}\b", each) for each in re.split(r"\n\s*\n", low)):
        return True
    return re.search(rf"\b{trade} (?:{_COMING})\b", low) is not None


def _is_nameless(person: Person) -> bool:
    return person.role == bare(person.name) and person.kind == "human" and person.count == 1


def _may_be(nameless: Person, named: Person, text: str) -> bool:
    """Whether a name can be that of somebody without one: by gender, title, distance and how both are told."""
    distance, gender = named.first - nameless.first, nameless.gender
    if "unknown" not in (gender, named.gender) and gender != named.gender:
        return False
    if _is_told_after_all(nameless, named, text):
        return True
    title, noun = bare(named.name).split()[0].strip("."), nameless.role
    if title in lexicon.TITLES and " " in named.name:
        ranked = title in lexicon.RANKS.get(noun, ())
        plain = noun in _SOMEBODY and title not in lexicon.KIN
        return (ranked or plain) and distance < _SOON and _INDEFINITE.match(text, nameless.first) is not None
    owned = noun in lexicon.KIN and _POSSESSED.match(text, nameless.first) is not None
    return owned and distance < _VERY_SOON and _does_something(named, text)


def _is_told_after_all(nameless: Person, named: Person, text: str) -> bool:
    """``at his side an old woman with a goose: Mother Kern``, ``A man stood there. It was Goran``."""
    between = text[nameless.first : named.first]
    if len(between) > _VERY_SOON or _INDEFINITE.match(between) is None or nameless.role not in _GENERIC | _YOUNG:
        return False
    return re.search(r"(?<=\w)(?:: | — | -- )$|[.;] (?:It|This|That|it) (?:was|is) $", between) is not None


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
