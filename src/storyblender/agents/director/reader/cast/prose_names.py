"""Finds names in a prose story: capitalised words that name a person and no place (notes of the director, 1a)."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER, unaccented
from storyblender.agents.director.reader.cast.name_evidence import gender_by_pronouns
from storyblender.agents.director.reader.language.morphology import form_kind, is_person_noun
from storyblender.agents.director.reader.language.person_nouns import find_person_nouns
from storyblender.agents.director.reader.people.look import read_description
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular

_TITLE = rf"(?:{'|'.join(sorted(title.title() for title in lexicon.TITLES | {'master'}))})"
_WORDS = rf"[{UPPER}][{LOWER}]+(?:-[{UPPER}][{LOWER}]+)*(?:[ ][{UPPER}][{LOWER}]+)*"
_NAME = re.compile(
    rf"(?<![.!?—–:)(\]\[-]\s)(?<![.!?—–:)(\]\[-]\s\s)(?<![(\[\-_/<#])(?<!^)(?<!\n)\b(?:(?:Mr|Mrs|Ms|Dr|Prof)\.?\s+)?{_WORDS}"
    rf"|\b{_TITLE}\.?\s[A-Z][a-z]+(?: [{UPPER}][{LOWER}]+)*"
    rf"|(?<=:\s)[{UPPER}][{LOWER}]+(?:[ ][{UPPER}][{LOWER}]+)+|(?<=:\s)[{UPPER}][{LOWER}]+(?=\.)"
    rf"|(?:(?<=[.!?:)\]]\s)|(?<=[.!?:)\]]\s\s)|(?<=[(\[])|^|(?<=\n)){_WORDS}(?=(?:, who)?\s+([a-z]+)|['’]s\s[a-z])",
    re.MULTILINE,
)
"""Position after a full stop, a colon or a bracket, where a capital alone is no evidence of a name."""
_LATER_LOOK = re.compile(r"(?:\s*,[^.;!?,]*){0,3}\s*,\s*(?:and )?(?:with|in) (an? [^,.;!?]*)")
"""``named Iver, tall and stooped, with a grey beard``."""
_CALLING = re.compile(r"\s*,\s*(?:for [^,.;]{1,30} )?(?:[a-z]+ )??([a-z]+) (?:to|of|at)\b")
"""``Josiah Finch, for eleven years confidential clerk to``: a trade without an article."""
_NOT_NAMES = lexicon.words("not_names")
_SMALL = lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES
_KNOWN = lexicon.FIRST_NAMES | lexicon.TITLES
_WHERE = re.compile(
    r"(?:\b(?:in|at|to|from|of|near|since|into|via|across|outside|inside|towards?|beyond|far as"
    r"|reach(?:ed|es)?|entered)|&)\s$"
)
_OWNED = re.compile(r"\b(?:an?|his|her|their|my|our)\s((?:[a-z-]+\s){0,2})$")
"""``a silver Volvo``: a thing has a name too."""
_OPENERS = (
    _SMALL
    | _NOT_NAMES
    | {"so", "still", "soon", "again", "now", "only", "even", "perhaps", "maybe", "here"}
    | {
        "little",
        "dear",
        "poor",
        "young",
        "good",
        "sweet",
        "brave",
        "clever",
    }
)
"""``So Hana said``: what may stand before a name at the start of a sentence."""
_AGED = frozenset(lexicon.AGE_WORDS)
"""``Old Jonas``, but not ``in Old Town``."""


def names_in(text: str, start: int) -> list[tuple[int, str]]:
    """Return the names in a text with their offsets.

    Args:
        text: A paragraph without its quotations.
        start: Its offset in the script.
    """
    found: list[tuple[int, str]] = []
    for match in _NAME.finditer(text):
        name = match.group(0)
        while " " in name:
            opener, rest = name.split(maxsplit=1)
            aged = opener.lower() in _AGED and (match.group(1) or rest.split()[0].lower() in _KNOWN)
            if opener.lower() not in _OPENERS and not aged:
                break
            name = rest
        at = match.start() + match.group(0).rindex(name)
        first = name.split()[0].lower()
        if {first, singular(first)} & (_SMALL | _NOT_NAMES) or name.lower() in lexicon.PRONOUNS:
            continue
        if match.group(1) and not _opens_like_a_name(name, match.group(1)):
            continue
        if first in lexicon.KIN and re.match(r" and ([a-z]+)", text[match.end() : match.end() + 9]):
            continue
        before = text[max(0, at - 30) : at].lower()
        if before.endswith(": ") and " " not in name and not any(find_person_nouns(text[max(0, at - 60) : at])):
            continue
        if re.search(r"\bmessrs\.?\s(?:[a-z]+ and )?$", before):
            continue
        known = first.strip(".") in _KNOWN
        if (
            not known
            and _is_place_name(name, before)
            and not _is_apposed_to_a_person(text[match.end() : match.end() + 62])
        ):
            continue
        found.append((start + at, name))
    return found


def _is_place_name(name: str, before: str) -> bool:
    """Whether a name is a place, a ship or a car: ``since Tulsa``, ``into the Starlite Motel``."""
    owned = _OWNED.search(before)
    named = any(form_kind(word) for word in owned.group(1).split()) if owned else False
    if _WHERE.search(before) or (owned and not named and not any(find_person_nouns(before))):
        return True
    last = name.lower().split()[-1]
    return re.search(r"\bthe\s+$", before) is not None and not is_person_noun(last)


def _opens_like_a_name(name: str, following: str) -> bool:
    """Whether a word at the start of a sentence is a name: it is known, or acts next."""
    first = name.split()[0].lower()
    acts = form_kind(following) in ("past", "aux", "3sg") or following in ("and", "who")
    common = lexicon.noun_class(singular(first)) != "unknown" or first in lexicon.ADJECTIVES | lexicon.ADVERBS
    return unaccented(first) in lexicon.FIRST_NAMES or (
        acts and not common and not form_kind(first) and first[-2:] != "ly"
    )


def _is_apposed_to_a_person(after: str) -> bool:
    """Whether an apposition shows a person: ``in the house of Pyotr Ilyich, the postmaster``."""
    phrase = next(find_person_nouns(after[2:60]), None) if after.startswith(", ") else None
    return phrase is not None and phrase.start == 0


@rule("people.name_in_story")
def add_name(roster: Roster, at: int, name: str, text: str, family: bool) -> None:
    """Add the person of a name to the cast; Mr. Barrow is Simon Barrow unless the story is about a family.

    Args:
        roster: The cast so far, filled here.
        at: Offset of the name.
        name: As written.
        text: The script, for the look told after the name.
        family: Whether several people may share a surname.
    """
    words = bare(name).split()
    if len(words) == 1 and words[0] in lexicon.TITLES:
        titled = [person for person in roster.people if bare(person.name).split()[0] == words[0]]
        for person in titled:
            roster.add_alias(person, words[0])
        if titled:
            return
    if not family and words[0].strip(".") in lexicon.TITLES and len(words) == 2:
        gender = lexicon.TITLE_GENDER.get(words[0].strip("."), "unknown")
        for person in roster.find(words[1]):
            if "unknown" in (gender, person.gender) or gender == person.gender:
                roster.add_alias(person, bare(name))
    for namesake in roster.find(name):
        if len(words) == 1 and _is_husband_of(namesake, words[0], text):
            roster.remove_aliases(namesake, words[0])
    if roster.find(name):
        return
    person = roster.add(name, at)
    look = re.match(r"\s*,\s*(an? [^,.;]*)", text[at + len(name) : at + len(name) + 80])
    if look:
        read_description(roster, person, look.group(1))
    calling = _CALLING.match(text[at + len(name) : at + len(name) + 80])
    if calling and is_person_noun(calling.group(1)):
        person.role = person.role or calling.group(1)
        roster.add_alias(person, calling.group(1))
    later = _LATER_LOOK.match(text[at + len(name) : at + len(name) + 160])
    if later:
        read_description(roster, person, later.group(1))


def _is_husband_of(namesake: Person, surname: str, told: str) -> bool:
    """Whether ``Coker`` is another person than Mrs. Coker: ``said Coker. He lit the lantern``."""
    title = bare(namesake.name).split()[0].strip(".")
    called = title in lexicon.TITLES and lexicon.TITLE_GENDER.get(title) == "female"
    return called and gender_by_pronouns(told, rf"(?:{surname.title()})") == "male"
