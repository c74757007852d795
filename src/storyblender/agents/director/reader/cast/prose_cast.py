"""Finds the people of a prose story: names, and nouns for people with a determiner (notes of the director, 1a)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER
from storyblender.agents.director.reader.cast.animals import animal_acts
from storyblender.agents.director.reader.cast.kin import (
    Kinship,
    is_known_relative,
    link_kin,
    link_surnames,
    mentions_family,
)
from storyblender.agents.director.reader.cast.later_names import name_the_nameless
from storyblender.agents.director.reader.cast.name_evidence import is_person_name
from storyblender.agents.director.reader.cast.namings import (
    find_namings,
    find_spoken_names,
    name_by_title,
    name_called_soon,
    narration_only,
    title_noun,
)
from storyblender.agents.director.reader.cast.prose_names import add_name, names_in
from storyblender.agents.director.reader.cast.trades import join_trades
from storyblender.agents.director.reader.language.person_nouns import PersonNoun, find_person_nouns
from storyblender.agents.director.reader.language.words import TextIndex
from storyblender.agents.director.reader.manuscript import Manuscript, without_quotations
from storyblender.agents.director.reader.people.look import read_description
from storyblender.agents.director.reader.people.narrator import find_narrator
from storyblender.agents.director.reader.people.person_reference import is_epithet
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_APPOSED = re.compile(rf"\s+((?:(?:Mr|Mrs|Ms|Dr|Prof)\.?\s)?[{UPPER}][{LOWER}]+)")
_APPOSED_AFTER_COMMA = re.compile(
    rf",\s+((?:(?:Mr|Mrs|Ms|Dr|Prof)\.?\s)?[{UPPER}][{LOWER}]+(?: [{UPPER}][{LOWER}]+)*)(?=[,.;])"
)
"""``his wife, Anna Petrovna,``; ``his companion, Dr. Fell,``."""
_LISTED = rf",?\s+[{UPPER}][{LOWER}]+(?:, [{UPPER}][{LOWER}]+)*,? and [{UPPER}]"
"""``the twins, Ola and Per``: they have names."""
_NAMED = re.compile(rf"\s+(?:named|called)\s+([{UPPER}][\w’'-]+)")
_OPENING = re.compile(
    r"(?:(?i:without|after|before|while|on|in|at|by|from|through|behind|with|beside|next to|under|near|between)\b"
    r"[a-z ]*,\s*)+|[A-Z][a-z]+(?:ly|ing)[a-z ]*,"
)
"""``Without knocking, a tiny woman came in``, ``Beside me, on the bench, an old man``: nobody stands before her."""
_NOT_ROLES = frozenset({"people", "crowd", "figure", "narrator", "family", "couple", "animal", "creature"})
_LATER = lexicon.words("later")
"""``the man`` is a known person, found among the people present."""


_ANOTHER = 400
"""Characters from ``a man`` to ``a young man`` who is another."""
_STRANGERS = frozenset({"stranger", "newcomer", "intruder"})
"""What a man nobody named is called later."""
_CHESSMEN = frozenset({"king", "queen", "knight", "bishop", "pawn"})
_GAMES = re.compile(r"\b(?:chess|checkmate|playing cards|whist|draughts)\b")


class _RoleNoun(NamedTuple):
    """A noun for a person where it occurs in the story."""

    at: int
    phrase: PersonNoun
    after: str

    @property
    def name(self) -> str:
        """The name that follows: ``niece Clara``, for kin and companions also after a comma."""
        close = self.phrase.noun in lexicon.KIN or is_epithet(self.phrase.noun)
        match = _APPOSED.match(self.after) or (_APPOSED_AFTER_COMMA.match(self.after) if close else None)
        return match.group(1) if match and not self.phrase.plural else ""


def find_prose_cast(script: Manuscript) -> Roster:
    """Return the people of a story: longer names first, then roles in the order they appear."""
    roster = Roster()
    names: list[tuple[int, str]] = []
    roles: list[_RoleNoun] = []
    family = mentions_family(script.text)
    whole = narration_only(script)
    playing = _GAMES.search(script.text) is not None
    for paragraph in script.paragraphs:
        told = without_quotations(paragraph.raw)
        names += names_in(told, paragraph.start)
        for phrase in find_person_nouns(told):
            piece = playing and phrase.noun in _CHESSMEN
            idle = phrase.noun in lexicon.ANIMALS and not animal_acts(phrase.noun, whole)
            listed = phrase.plural and _are_listed(phrase.noun, whole)
            nobody = piece or idle or listed or _is_vehicle(phrase.noun, whole) or _only_compared(told, phrase)
            if phrase.noun not in _NOT_ROLES and not nobody:
                roles.append(_RoleNoun(paragraph.start + phrase.start, phrase, told[phrase.end : phrase.end + 60]))
    index = TextIndex(whole)
    distinct = {name: None for _, name in names}
    absent = {name for name in distinct if not is_person_name(name, index)}
    names = [(at, name) for at, name in names if name not in absent]
    for at, name in sorted(names, key=lambda item: (-len(item[1].split()), item[0])):
        add_name(roster, at, name, whole, family)
    link_surnames(roster)
    kin = [role for role in roles if role.name and role.phrase.noun in lexicon.KIN]
    kinships = [Kinship(r.at, r.phrase.determiner, r.phrase.noun, p) for r in kin for p in roster.find(r.name)[:1]]
    link_kin(roster, kinships, sorted(names))
    find_narrator(script, roster)
    spoken = find_spoken_names(script)
    titled = [name for at, name in spoken if any(title_noun(name) == r.phrase.noun and r.at < at for r in roles)]
    for role in sorted(roles, key=lambda role: (not role.name, is_epithet(role.phrase.noun), role.at)):
        _admit(roster, role, script.text, [(at, name) for at, name in spoken if name not in titled])
    name_by_title(roster, spoken)
    join_trades(roster, script.text, whole)
    name_the_nameless(roster, whole, find_namings(script))
    join_trades(roster, script.text, whole)
    roster.sort()
    roster.link_variants()
    return roster


@lru_cache(maxsize=256)
def _are_listed(noun: str, told: str) -> bool:
    """Whether a plural noun is only one of a list."""
    return re.search(rf"\b{noun}\w*{_LISTED}", told) is not None


@lru_cache(maxsize=256)
def _is_vehicle(noun: str, told: str) -> bool:
    """Whether a trade's noun is a vehicle here: ``climbed into the coach``."""
    boarding = r"\b(?:(?:climb|clamber|got|get|step|sat|sit)\w* (?:back )?(?:up )?(?:in|into|inside|out of)|aboard)"
    return re.search(rf"{boarding} (?:an?|the|his|her|their) (?:[\w-]+ )?{noun}\b", told) is not None


def _only_compared(told: str, phrase: PersonNoun) -> bool:
    """Whether a noun is only a comparison or an owner: ``like a squirrel``, ``a man's coat``."""
    owned = phrase.determiner in ("a", "an") and re.match(r"['’]s", told[phrase.end :]) is not None
    before = told[max(0, phrase.start - 12) : phrase.start]
    return owned or re.search(r"\b(?:like|as|than|size of|height of|belonged to) $", before) is not None


@rule("people.noun_in_story")
def _admit(roster: Roster, role: _RoleNoun, text: str, spoken: Sequence[tuple[int, str]]) -> None:
    """Add a role to the cast unless it is a known person."""
    phrase, look = role.phrase, " ".join(role.phrase.adjectives)
    named = _NAMED.match(role.after)
    apposed = _is_apposed(role, text)
    fresh = (
        phrase.noun in _LATER | lexicon.RANKS.keys()
        and phrase.determiner in ("a", "an")
        and not phrase.plural
        and not apposed
    )
    if role.name and is_epithet(phrase.noun) and phrase.determiner not in ("a", "an"):
        return
    if role.name:
        _name_by_kin(roster, role, role.name)
    elif fresh and (name := name_called_soon(roster, spoken, role.at, phrase.noun)):
        person = roster.add(name, role.at)
        person.gender = person.gender if person.gender != "unknown" else lexicon.gender_of_word(phrase.noun)
        read_description(roster, person, look)
    elif named:
        person = roster.add(named.group(1), role.at)
        if person.gender == "unknown":
            person.gender = lexicon.gender_of_word(phrase.noun)
        person.role = person.role or phrase.noun
        person.kind = "animal" if person.role in lexicon.ANIMALS else person.kind
        roster.add_alias(person, phrase.noun)
        read_description(roster, person, look)
    elif _is_another(roster, role, text, apposed):
        _add_role(roster, role, look, f"{look} {phrase.noun}")
    elif old := _contrasting_person(roster, role, text, apposed):
        roster.remove_aliases(old, phrase.noun)
        roster.rename(old, f"Old {phrase.noun}")
        _add_role(roster, role, look)
    elif known := [person for person in roster.people if person.role == phrase.noun]:
        for person in known if not (phrase.noun in _LATER and lexicon.AGED & set(phrase.adjectives)) else ():
            read_description(roster, person, look)
    elif not _is_known_person(roster, role, text):
        _add_role(roster, role, look)


def _is_known_person(roster: Roster, role: _RoleNoun, text: str) -> bool:
    """Whether a role is a person known already: ``the man`` where a man is known, ``Clara, a tall girl``."""
    phrase = role.phrase
    if phrase.determiner not in ("a", "an") and not phrase.plural and _is_kind(roster, phrase.noun):
        return True
    if (
        phrase.noun in _LATER
        and phrase.plural
        and re.search(r"\b(?:the|his|her|their) $", text[max(0, role.at - 6) : role.at].lower())
    ):
        return True
    apposed = _is_apposed(role, text)
    if apposed and phrase.determiner == "the" and _names_before(roster, role, text):
        return True
    if phrase.determiner not in ("a", "an") and _is_other_role_of_known(roster, role, text):
        return True
    converse = lexicon.CONVERSE_KIN.get(phrase.noun, ())
    if phrase.determiner in lexicon.POSSESSIVES and any(person.role in converse for person in roster.people):
        return True
    if phrase.noun in _LATER and phrase.plural and phrase.determiner in lexicon.POSSESSIVES:
        return True
    if phrase.determiner in lexicon.POSSESSIVES and is_known_relative(roster, phrase, role.at, role.after, text):
        return True
    gender = lexicon.gender_of_word(phrase.noun)
    of_a_kind = bool(phrase.adjectives) and lexicon.noun_class(phrase.adjectives[-1]) not in ("unknown", "abstract")
    if phrase.noun in _LATER and phrase.determiner == "the" and not of_a_kind:
        return any(gender in (person.gender, "unknown") or person.gender == "unknown" for person in roster.people)
    if text[max(0, role.at - 3) : role.at].lower() == "as ":
        return True
    return apposed and (phrase.determiner in ("a", "an") or _names_before(roster, role, text))


def _is_kind(roster: Roster, noun: str) -> bool:
    """Whether a noun is the kind of a known animal: ``a goose``, later ``the bird``."""
    kinds = lexicon.KINDS.get(noun, frozenset())
    same = [person for person in roster.people if person.kind == "animal" and person.role in kinds]
    for person in same[:1]:
        roster.add_alias(person, noun)
    return bool(same)


def _is_apposed(role: _RoleNoun, text: str) -> bool:
    """Whether a role describes the person before it: ``Prado came in, a fat man``."""
    sentence = re.split(r"[.!?]", text[max(0, role.at - 90) : role.at])[-1]
    beside = re.search(r"\band (?:next to|beside|behind|with|between|in front of|on)\b", sentence)
    alone = _OPENING.fullmatch(sentence.strip())
    return text[max(0, role.at - 2) : role.at] == ", " and beside is None and alone is None


def _is_other_role_of_known(roster: Roster, role: _RoleNoun, text: str) -> bool:
    """Whether a known person has this other role: ``the soldier`` who is a sergeant."""
    phrase = role.phrase
    ranked = [person for person in roster.people if phrase.noun in _title_nouns(person) and not phrase.plural]
    before = [person for person in roster.people if person.first < role.at]
    nameless = [person for person in before if person.role in _LATER and person.role == bare(person.name)]
    if phrase.noun in _STRANGERS and nameless:
        roster.add_alias(nameless[-1], phrase.noun)
        return True
    if len(ranked) > 1 and phrase.noun in lexicon.FEMALE_NOUNS:
        ranked = []  # of two ladies nobody knows who is the landlady
    for person in ranked:
        roster.add_alias(person, phrase.noun)
    if ranked or any(phrase.noun in person.aliases for person in roster.people if phrase.noun not in _LATER):
        return True
    others = [person for person in before if person.kind == "human" and not is_epithet(person.role)]
    if phrase.noun in lexicon.CALLINGS:
        introduced = re.search(rf"\ban? (?:[a-z-]+ )?{phrase.noun}\b", text)
        return phrase.determiner == "the" and bool(others) and introduced is None
    return is_epithet(phrase.noun) and len(others) > 1


def _title_nouns(person: Person) -> set[str]:
    """Return the nouns that a title stands for: a sergeant is a soldier, Dr. Fell a doctor."""
    title = bare(person.name).split()[0].strip(".")
    nouns = {noun for noun, titles in lexicon.RANKS.items() if title in titles or person.role in titles}
    nouns |= lexicon.RANKS.get(person.role, frozenset())
    return nouns | ({lexicon.TITLE_SYNONYMS.get(title, title)} if title in lexicon.TITLES else set())


def _names_before(roster: Roster, role: _RoleNoun, text: str) -> bool:
    """Give a role to the name before it: ``Mrs. Finch, the new caretaker,``."""
    before = text[max(0, role.at - 60) : role.at - 2].lower()
    person = next((p for p in roster.people for alias in p.aliases if before.endswith(alias)), None)
    end = role.at + role.phrase.end - role.phrase.start
    closed = text[end - 1 : end + 1].endswith((",", ".", ", ")) or text[end : end + 4] == " of "
    if person is None or not closed:
        return False
    roster.add_alias(person, bare(role.phrase.noun))
    person.role = person.role or role.phrase.noun
    read_description(roster, person, " ".join(role.phrase.adjectives))
    return True


def _is_another(roster: Roster, role: _RoleNoun, text: str, apposed: bool) -> bool:
    """Whether a role is another person than the one known by it: much later ``knelt a young man``."""
    phrase = role.phrase
    if phrase.noun not in _LATER or phrase.determiner not in ("a", "an") or phrase.plural or apposed:
        return False
    look = " ".join(phrase.adjectives)
    known = [person for person in roster.people if person.role == phrase.noun and person.first < role.at]
    told = any(f"{look} {phrase.noun}" in person.aliases for person in known)
    is_said = re.search(
        r"\b(?:is|was|be|been|am|are|were|become|became|such|not|for|of) $", text[: role.at][-10:].lower()
    )
    near = any(role.at - person.first < _ANOTHER for person in known)
    return bool(known and look) and not told and not near and is_said is None


def _contrasting_person(roster: Roster, role: _RoleNoun, text: str, apposed: bool) -> Person | None:
    """Return the person always called ``the old man`` where much later ``a man`` comes, who is another."""
    noun = role.phrase.noun
    if noun not in _LATER or role.phrase.determiner not in ("a", "an") or role.phrase.plural or apposed:
        return None
    called = {name for age in lexicon.AGED if text.lower().count(name := f"the {age} {noun}") > 1}
    for person in roster.people:
        aged = [f"the {alias}" for alias in person.aliases]
        if person.role == noun == bare(person.name) and called & {*aged} and role.at - person.first > _ANOTHER:
            return person
    return None


def _add_role(roster: Roster, role: _RoleNoun, look: str, name: str = "") -> None:
    """Add a person for a role."""
    phrase = role.phrase
    person = roster.add(name or phrase.noun, role.at)
    person.count = lexicon.NUMBERS.get(phrase.determiner, 2) if phrase.plural else 1
    if person.count > 1 and person.kind == "human":
        person.kind = "group"
    if look:
        read_description(roster, person, look)
        roster.add_alias(person, f"{look} {phrase.noun}")


def _name_by_kin(roster: Roster, role: _RoleNoun, name: str) -> None:
    """Add the person of ``His niece Clara``: Clara, a woman, a niece."""
    known = roster.find(name)
    person = known[0] if known else roster.add(name, role.at)
    gender = lexicon.gender_of_word(role.phrase.noun)
    person.gender = gender if gender != "unknown" else person.gender
    person.role = person.role or role.phrase.noun
    roster.add_alias(person, bare(role.phrase.noun))
    if {"little", "younger", "small"} & set(role.phrase.adjectives):
        person.age = person.age or "child"
