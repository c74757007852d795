"""Who is in a story: names with capitals, titles, and nouns for people with a determiner (notes of the director, 1a.6)."""

from __future__ import annotations

import re
from dataclasses import dataclass

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.look import describe
from storyblender.agents.director.reader.manuscript import Manuscript, without_quotations
from storyblender.agents.director.reader.morphology import is_person_noun, singular
from storyblender.agents.director.reader.roster import Roster, bare

_TITLE = r"(?:Mr|Mrs|Ms|Miss|Dr|Prof|Prince|Princess|King|Queen|Captain|Sergeant|Officer|Doctor|Uncle|Aunt|Lady|Lord|Sir|Sheriff)"
_NAME = re.compile(
    r"(?<![.!?]\s)(?<!^)(?<!\n)\b(?:(?:Mr|Mrs|Ms|Dr|Prof)\.?\s+)?[A-ZÀ-Ý][a-zà-ÿ]+(?:[ ][A-ZÀ-Ý][a-zà-ÿ]+)*"
    rf"|\b{_TITLE}\.?\s[A-Z][a-z]+"
    r"|(?:(?<=[.!?]\s)|^|(?<=\n))[A-ZÀ-Ý][a-zà-ÿ]+(?=\s+[a-z]+ed\b|['’]s\s[a-z]|\s+(?:was|had|said|ran|sat|stood|took|went|came|is"
    r"|has|put|held|gave|knew|saw|felt|kept|left|and [A-Z]))",
    re.MULTILINE,
)
_DETERMINER = re.compile(
    r"\b(the|a|an|his|her|their|two|three|four|five|one)\s+(?=((?:[a-z’'-]+,?\s+){0,3}[a-z-]+))", re.IGNORECASE
)
_NAMED = re.compile(r"\s+(?:named|called)\s+([A-ZÀ-Ý][\w’'-]+)")
_NOT_NAMES = frozenset(
    {"once", "deep", "but", "and", "when", "then", "i", "monday", "tuesday", "wednesday", "thursday", "friday", "saturday",
     "sunday", "christmas", "there", "what", "nobody", "everyone", "somebody", "someone", "god", "english", "french",
     "january", "february", "march", "april", "may", "june", "july", "august", "september", "october", "november", "december",
     "inside", "outside", "suddenly", "behind", "nothing", "something", "everything", "chapter", "yes", "no"}
)  # fmt: skip
_SMALL = lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES
_NOT_ROLES = frozenset({"people", "crowd", "figure", "narrator", "family", "couple"})
_LATER = frozenset({"man", "woman", "boy", "girl", "child"})
"""``the man`` is somebody known, to be found by looking who is there."""


@dataclass(frozen=True)
class _Role:
    at: int
    determiner: str
    adjectives: tuple[str, ...]
    noun: str
    plural: bool
    name: str
    after: str


def find_prose_cast(script: Manuscript) -> Roster:
    """Collect the people of a story: longer names first, then roles in the order they appear."""
    roster = Roster()
    names: list[tuple[int, str]] = []
    roles: list[_Role] = []
    for paragraph in script.paragraphs:
        told = without_quotations(paragraph.raw)
        names += _names(told, paragraph.start)
        roles += _roles(told, paragraph.start)
    for at, name in sorted(names, key=lambda item: (-len(item[1].split()), item[0])):
        if not roster.find(name):
            person = roster.add(name, at)
            look = re.match(r"\s*,\s*(an? [^,.;]*)", script.text[at + len(name) : at + len(name) + 80])
            if look:
                describe(person, look.group(1))
    for role in sorted(roles, key=lambda role: (re.match(r"\s+[A-Z][a-z]", role.after) is None, role.at)):
        _admit(roster, role, script.text)
    roster.people.sort(key=lambda person: person.first)
    roster.link_variants()
    return roster


def _names(text: str, start: int) -> list[tuple[int, str]]:
    found: list[tuple[int, str]] = []
    for match in _NAME.finditer(text):
        name = match.group(0)
        first = name.split()[0].lower()
        if first in _SMALL | _NOT_NAMES or name.lower() in lexicon.PRONOUNS:
            continue
        before = text[max(0, match.start() - 6) : match.start()].lower()
        somewhere = re.search(r"\b(in|at|to|from|of|near)\s$", before)
        if somewhere and first.strip(".") not in lexicon.FIRST_NAMES | lexicon.TITLES:
            continue
        found.append((start + match.start(), name))
    return found


def _roles(text: str, start: int) -> list[_Role]:
    """Nouns for people with a determiner and at most three words between."""
    found: list[_Role] = []
    for match in _DETERMINER.finditer(text):
        at = match.end()
        adjectives: list[str] = []
        for word in match.group(2).split():
            noun, low = singular(word), word.lower().strip(",")
            at = text.index(word, at) + len(word)
            if low in _SMALL:
                break
            if is_person_noun(noun) and noun not in _NOT_ROLES:
                name = _NAMED.match(text, at)
                found.append(
                    _Role(start + match.start(), match.group(1).lower(), tuple(adjectives), noun, noun != low,
                          name.group(1) if name else "", text[at : at + 60])
                )  # fmt: skip
                break
            adjectives.append(low)
    return found


def _admit(roster: Roster, role: _Role, text: str) -> None:
    apposed = re.match(r"\s+([A-ZÀ-Ý][a-zà-ÿ]+)", role.after)
    look = " ".join(role.adjectives)
    if apposed and not role.plural and not role.name:
        _name_by_kin(roster, role, apposed.group(1))
        return
    if role.name:
        person = roster.add(role.name, role.at)
        if person.gender == "unknown":
            person.gender = lexicon.gender_of_word(role.noun)
        person.role = person.role or role.noun
        roster.call(person, role.noun)
        describe(person, look)
        return
    known = [person for person in roster.people if person.role == role.noun]
    if known:
        for person in known:
            describe(person, look)
        return
    converse = lexicon.CONVERSE_KIN.get(role.noun, ())
    if role.determiner in lexicon.POSSESSIVES and any(person.role in converse for person in roster.people):
        return
    gender = lexicon.gender_of_word(role.noun)
    if role.noun in _LATER and role.determiner == "the":
        if any("unknown" in (person.gender, gender) or person.gender == gender for person in roster.people):
            return
    if role.determiner in ("a", "an") and text[max(0, role.at - 2) : role.at] == ", ":
        return
    person = roster.add(role.noun, role.at)
    person.count = lexicon.NUMBERS.get(role.determiner, 2) if role.plural else 1
    if person.count > 1:
        person.kind = "group" if person.kind == "human" else person.kind
    if look:
        describe(person, look)
        roster.call(person, f"{look} {role.noun}")


def _name_by_kin(roster: Roster, role: _Role, name: str) -> None:
    """``His niece Clara``: Clara, a woman, somebody's niece."""
    known = roster.find(name)
    person = known[0] if known else roster.add(name, role.at)
    gender = lexicon.gender_of_word(role.noun)
    person.gender = gender if gender != "unknown" else person.gender
    person.role = person.role or role.noun
    roster.call(person, bare(role.noun))
    if {"little", "younger", "small"} & set(role.adjectives):
        person.age = person.age or "child"
