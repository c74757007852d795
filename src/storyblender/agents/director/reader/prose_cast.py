"""Who is in a story: names with capitals, titles, nouns for people with a determiner (notes of the director, 1a)."""

from __future__ import annotations

import re
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER, unaccented
from storyblender.agents.director.reader.look import describe
from storyblender.agents.director.reader.manuscript import Manuscript, without_quotations
from storyblender.agents.director.reader.morphology import form_kind, singular
from storyblender.agents.director.reader.person_nouns import PersonNoun, find_person_nouns
from storyblender.agents.director.reader.roster import Roster, bare

_TITLE = (
    r"(?:Mr|Mrs|Ms|Miss|Dr|Prof|Prince|Princess|King|Queen|Captain|Sergeant|Officer|Doctor|Uncle|Aunt|Lady|Lord|Sir"
    r"|Sheriff|Father|Sister|Brother|Professor)"
)
_NAME = re.compile(
    rf"(?<![.!?—–-]\s)(?<!^)(?<!\n)\b(?:(?:Mr|Mrs|Ms|Dr|Prof)\.?\s+)?[{UPPER}][{LOWER}]+(?:[ ][{UPPER}][{LOWER}]+)*"
    rf"|\b{_TITLE}\.?\s[A-Z][a-z]+"
    rf"|(?:(?<=[.!?]\s)|^|(?<=\n))[{UPPER}][{LOWER}]+(?:[ ][{UPPER}][{LOWER}]+)*(?=(?:, who)?\s+([a-z]+)|['’]s\s[a-z])",
    re.MULTILINE,
)
_LATER_LOOK = re.compile(r"(?:\s*,[^.;!?,]*){0,3}\s*,\s*(?:and )?(?:with|in) (an? [^,.;!?]*)")
"""``named Iver, tall and stooped, with a grey beard``."""
_APPOSED = re.compile(rf"\s+([{UPPER}][{LOWER}]+)")
_NAMED = re.compile(rf"\s+(?:named|called)\s+([{UPPER}][\w’'-]+)")
_NOT_NAMES = lexicon.words("not_names")
_SMALL = lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES
_NOT_ROLES = frozenset({"people", "crowd", "figure", "narrator", "family", "couple", "animal", "creature"})
_LATER = frozenset(
    {"man", "woman", "boy", "girl", "child", "lady", "gentleman", "guy", "fellow", "kid", "lad", "person"}
)
"""``the man`` is somebody known, to be found by looking who is there."""


class _Role(NamedTuple):
    """A noun for a person where it stands in the story."""

    at: int
    phrase: PersonNoun
    after: str


def find_prose_cast(script: Manuscript) -> Roster:
    """Collect the people of a story: longer names first, then roles in the order they appear."""
    roster = Roster()
    names: list[tuple[int, str]] = []
    roles: list[_Role] = []
    for paragraph in script.paragraphs:
        told = without_quotations(paragraph.raw)
        names += _names(told, paragraph.start)
        for phrase in find_person_nouns(told):
            if phrase.noun not in _NOT_ROLES and not _only_compared(told, phrase):
                roles.append(_Role(paragraph.start + phrase.start, phrase, told[phrase.end : phrase.end + 60]))
    for at, name in sorted(names, key=lambda item: (-len(item[1].split()), item[0])):
        if not roster.find(name):
            person = roster.add(name, at)
            look = re.match(r"\s*,\s*(an? [^,.;]*)", script.text[at + len(name) : at + len(name) + 80])
            if look:
                describe(person, look.group(1))
            later = _LATER_LOOK.match(script.text[at + len(name) : at + len(name) + 160])
            if later:
                describe(person, later.group(1))
    for role in sorted(roles, key=lambda role: (_APPOSED.match(role.after) is None, role.at)):
        _admit(roster, role, script.text)
    roster.people.sort(key=lambda person: person.first)
    roster.link_variants()
    return roster


def _opens_like_a_name(name: str, following: str) -> bool:
    """At the start of a sentence every word has a capital: a name is known, or does something next."""
    first = name.split()[0].lower()
    acts = form_kind(following) in ("past", "aux") or following in ("and", "who")
    common = lexicon.noun_class(singular(first)) != "unknown" or first in lexicon.ADJECTIVES | lexicon.ADVERBS
    return unaccented(first) in lexicon.FIRST_NAMES or (
        acts and not common and not form_kind(first) and first[-2:] != "ly"
    )


def _only_compared(told: str, phrase: PersonNoun) -> bool:
    """``a man's coat``, ``like a squirrel``: nobody is there."""
    owned = phrase.determiner in ("a", "an") and re.match(r"['’]s", told[phrase.end :]) is not None
    return owned or re.search(r"\b(?:like|as|than) $", told[max(0, phrase.start - 5) : phrase.start]) is not None


def _names(text: str, start: int) -> list[tuple[int, str]]:
    found: list[tuple[int, str]] = []
    for match in _NAME.finditer(text):
        name = match.group(0)
        first = name.split()[0].lower()
        if first in _SMALL | _NOT_NAMES or name.lower() in lexicon.PRONOUNS:
            continue
        if match.group(1) and not _opens_like_a_name(name, match.group(1)):
            continue
        before = text[max(0, match.start() - 6) : match.start()].lower()
        somewhere = re.search(r"\b(in|at|to|from|of|near)\s$", before)
        if somewhere and first.strip(".") not in lexicon.FIRST_NAMES | lexicon.TITLES:
            continue
        found.append((start + match.start(), name))
    return found


def _admit(roster: Roster, role: _Role, text: str) -> None:
    phrase, look = role.phrase, " ".join(role.phrase.adjectives)
    named, apposed = _NAMED.match(role.after), _APPOSED.match(role.after)
    if apposed and not phrase.plural:
        _name_by_kin(roster, role, apposed.group(1))
    elif named:
        person = roster.add(named.group(1), role.at)
        if person.gender == "unknown":
            person.gender = lexicon.gender_of_word(phrase.noun)
        person.role = person.role or phrase.noun
        roster.call(person, phrase.noun)
        describe(person, look)
    elif known := [person for person in roster.people if person.role == phrase.noun]:
        for person in known:
            describe(person, look)
    elif not _is_somebody_known(roster, role, text):
        _add_role(roster, role, look)


def _is_somebody_known(roster: Roster, role: _Role, text: str) -> bool:
    """``her uncle`` of a niece, ``the man`` where a man is known, ``Clara, a tall girl``, ``as a baby``."""
    phrase = role.phrase
    converse = lexicon.CONVERSE_KIN.get(phrase.noun, ())
    if phrase.determiner in lexicon.POSSESSIVES and any(person.role in converse for person in roster.people):
        return True
    if phrase.noun in _LATER and phrase.plural and phrase.determiner in lexicon.POSSESSIVES:
        return True
    related = phrase.determiner in lexicon.POSSESSIVES and phrase.noun in lexicon.CONVERSE_KIN | {"cousin": ()}
    if related and len(re.findall(rf"\b{phrase.noun}\b", text)) < 2 and len(roster.people) > 1:
        return True
    gender = lexicon.gender_of_word(phrase.noun)
    if phrase.noun in _LATER and phrase.determiner == "the":
        return any(gender in (person.gender, "unknown") or person.gender == "unknown" for person in roster.people)
    if text[max(0, role.at - 3) : role.at].lower() == "as ":
        return True
    apposed = text[max(0, role.at - 2) : role.at] == ", "
    return apposed and (phrase.determiner in ("a", "an") or _names_before(roster, role, text))


def _names_before(roster: Roster, role: _Role, text: str) -> bool:
    """``Mrs. Crabbe, the old housekeeper,``: she is the housekeeper from then on."""
    before = text[max(0, role.at - 60) : role.at - 2].lower()
    person = next((p for p in roster.people for alias in p.aliases if before.endswith(alias)), None)
    closed = text[role.at : role.at + role.phrase.end - role.phrase.start + 1].endswith((",", ".", ", "))
    if person is None or not closed:
        return False
    roster.call(person, bare(role.phrase.noun))
    person.role = person.role or role.phrase.noun
    describe(person, " ".join(role.phrase.adjectives))
    return True


def _add_role(roster: Roster, role: _Role, look: str) -> None:
    phrase = role.phrase
    person = roster.add(phrase.noun, role.at)
    person.count = lexicon.NUMBERS.get(phrase.determiner, 2) if phrase.plural else 1
    if person.count > 1 and person.kind == "human":
        person.kind = "group"
    if look:
        describe(person, look)
        roster.call(person, f"{look} {phrase.noun}")


def _name_by_kin(roster: Roster, role: _Role, name: str) -> None:
    """``His niece Clara``: Clara, a woman, somebody's niece."""
    known = roster.find(name)
    person = known[0] if known else roster.add(name, role.at)
    gender = lexicon.gender_of_word(role.phrase.noun)
    person.gender = gender if gender != "unknown" else person.gender
    person.role = person.role or role.phrase.noun
    roster.call(person, bare(role.phrase.noun))
    if {"little", "younger", "small"} & set(role.phrase.adjectives):
        person.age = person.age or "child"
