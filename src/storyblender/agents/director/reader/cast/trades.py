"""Resolves a trade that nobody was introduced with: ``A man stood there. The surveyor did not look up``."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.cast.later_names import GENERIC, GENTLE, is_nameless, merge_people
from storyblender.agents.director.reader.language.morphology import is_person_noun
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_ATTENDANTS = frozenset(
    {
        "waiter",
        "waitress",
        "barman",
        "barkeep",
        "bartender",
        "barmaid",
        "driver",
        "coachman",
        "cabman",
        "conductor",
        "porter",
    }
    | {"guard", "sentry", "doorman", "servant", "maid", "butler", "footman", "cook", "nurse", "clerk", "cashier"}
    | {"landlord", "landlady", "innkeeper", "priest", "vicar", "postman", "policeman", "constable", "captain", "mate"}
    | {"bosun", "pilot", "teacher", "headmaster", "king", "queen", "prisoner", "receptionist", "steward", "pianist"}
)
"""``the waiter`` comes with the place, nobody has to introduce him."""
_COMING = "came|comes|enter(?:ed|s)|arrive[ds]|appear(?:ed|s)|walk(?:ed|s) in|ran|runs|burst|bursts"
_SPEAKING = re.compile(r"\b(?:said|says|asked|asks|cried|cries|shouted|shouts|replied|answered|whispered) $")
_STILL_NEAR, _JUST_NAMED = 1500, 160
"""Characters from ``a man`` to ``the surveyor``, and from ``Mr. Finch`` to ``The lawyer``."""


@rule("people.trade")
def join_trades(roster: Roster, text: str, told: str) -> None:
    """Join a person first called *the surveyor* with the man, or the Mr. Finch, who was there already.

    Args:
        roster: The cast of a story.
        text: The script.
        told: The same without what is said.
    """
    for person in sorted(roster.people, key=lambda person: person.first):
        trade = person.role
        if not is_nameless(person) or trade in GENERIC | _ATTENDANTS | lexicon.KIN | lexicon.YOUNG_NOUNS:
            continue
        speaks = _SPEAKING.search(told[: person.first][-40:]) is not None
        known = "the |his |her " if speaks else "the "
        if re.match(known, text[person.first :], re.IGNORECASE) is None:
            continue
        if re.search(rf"\ban? (?:[\w-]+ )?{trade}\b", text):
            continue
        men = [
            other
            for other in roster.people
            if other.role in GENERIC
            and 0 < person.first - other.first < _STILL_NEAR
            and _genders_agree(person, other)
            and not _are_distinct(other, trade, told, speaks)
        ]
        men = [other for other in men if is_nameless(other)] or men
        if len(men) == 1:
            one, other = (person, men[0]) if is_nameless(men[0]) else (men[0], person)
            role = men[0].role
            merge_people(roster, one, other)
            one.role = role  # he stays the man he was before
        elif titled := _just_named(roster, person, told, speaks):
            merge_people(roster, titled, person)


def _genders_agree(person: Person, other: Person) -> bool:
    """Whether the genders of two people may be the same."""
    return "unknown" in (person.gender, other.gender) or person.gender == other.gender


def _just_named(roster: Roster, nameless: Person, told: str, speaks: bool) -> Person | None:
    """Return the titled or newly named person right before: ``said Mr. Finch. The lawyer unrolled the will``."""
    opens = told[nameless.first].isupper()
    coming = re.match(rf"\w+ [\w-]+ (?:{_COMING})\b", told[nameless.first :]) is not None
    for other in roster.people if (opens or speaks) and not coming else ():
        title = bare(other.name).split()[0].strip(".")
        newest = max((each.first for each in roster.people if each.first < nameless.first), default=-1)
        fresh = opens and other.first == newest and not is_person_noun(bare(other.name))
        near = told.rfind(other.name, max(0, nameless.first - _JUST_NAMED), nameless.first)
        between = told[near : nameless.first].strip()
        fits = (
            (title in GENTLE or fresh) and not other.role and other.kind == "human" and _genders_agree(nameless, other)
        )
        if fits and near >= 0 and (speaks or "\n\n" not in between):
            return other
    return None


def _are_distinct(nameless: Person, trade: str, told: str, speaks: bool) -> bool:
    """Whether two people are told together, in a paragraph or sentence, and so are not the same."""
    low = told.lower()
    called = re.compile(rf"\b(?:an?|the|that|this) (?:{'|'.join(map(re.escape, nameless.aliases))})\b")
    pieces = re.split(r"[.!?\n]" if speaks else r"\n\s*\n", low)
    if any(called.search(each) and re.search(rf"\b{trade}\b", each) for each in pieces):
        return True
    return re.search(rf"\b{trade} (?:{_COMING})\b", low) is not None
