"""Names in a story: words with a capital that name somebody and no place (notes of the director, 1a)."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER, unaccented
from storyblender.agents.director.reader.language.morphology import form_kind, is_person_noun, singular
from storyblender.agents.director.reader.language.person_nouns import find_person_nouns
from storyblender.agents.director.reader.people.look import describe
from storyblender.agents.director.reader.people.roster import Roster, bare

_TITLE = (
    r"(?:Mr|Mrs|Ms|Miss|Dr|Prof|Prince|Princess|King|Queen|Captain|Sergeant|Officer|Doctor|Uncle|Aunt|Lady|Lord|Sir"
    r"|Sheriff|Father|Sister|Brother|Professor|Inspector|Constable|Colonel|Major|General|Lieutenant|Corporal"
    r"|Sergeant-Major|Reverend|Madame|Monsieur|Master)"
)
_NAME = re.compile(
    rf"(?<![.!?—–-]\s)(?<!^)(?<!\n)\b(?:(?:Mr|Mrs|Ms|Dr|Prof)\.?\s+)?[{UPPER}][{LOWER}]+(?:[ ][{UPPER}][{LOWER}]+)*"
    rf"|\b{_TITLE}\.?\s[A-Z][a-z]+(?: [{UPPER}][{LOWER}]+)*"
    rf"|(?:(?<=[.!?]\s)|^|(?<=\n))[{UPPER}][{LOWER}]+(?:[ ][{UPPER}][{LOWER}]+)*(?=(?:, who)?\s+([a-z]+)|['’]s\s[a-z])",
    re.MULTILINE,
)
_LATER_LOOK = re.compile(r"(?:\s*,[^.;!?,]*){0,3}\s*,\s*(?:and )?(?:with|in) (an? [^,.;!?]*)")
"""``named Iver, tall and stooped, with a grey beard``."""
_NOT_NAMES = lexicon.words("not_names")
_SMALL = lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES


def names_in(text: str, start: int) -> list[tuple[int, str]]:
    """Find names with their offsets.

    Args:
        text: A paragraph without its quotations.
        start: Its offset in the script.
    """
    found: list[tuple[int, str]] = []
    for match in _NAME.finditer(text):
        name = match.group(0)
        first = name.split()[0].lower()
        if first in _SMALL | _NOT_NAMES or name.lower() in lexicon.PRONOUNS:
            continue
        if match.group(1) and not _opens_like_a_name(name, match.group(1)):
            continue
        if first in lexicon.KIN and re.match(r" and ([a-z]+)", text[match.end() :]):
            continue
        before = text[max(0, match.start() - 8) : match.start()].lower()
        known = first.strip(".") in lexicon.FIRST_NAMES | lexicon.TITLES
        if not known and _is_somewhere(name, before) and not _is_apposed_to_somebody(text[match.end() :]):
            continue
        found.append((start + match.start(), name))
    return found


def _is_somewhere(name: str, before: str) -> bool:
    """``since Tulsa``, ``into the Starlite Motel``, ``Laburnam Villa``: a place, a ship or a car."""
    if re.search(r"\b(in|at|to|from|of|near|since|into|via|across|outside|inside)\s$", before):
        return True
    *_, last = name.lower().split()
    return (before.endswith("the ") and not is_person_noun(last)) or (" " in name and last in lexicon.PLACES)


def _opens_like_a_name(name: str, following: str) -> bool:
    """At the start of a sentence every word has a capital: a name is known, or does something next."""
    first = name.split()[0].lower()
    acts = form_kind(following) in ("past", "aux") or following in ("and", "who")
    common = lexicon.noun_class(singular(first)) != "unknown" or first in lexicon.ADJECTIVES | lexicon.ADVERBS
    return unaccented(first) in lexicon.FIRST_NAMES or (
        acts and not common and not form_kind(first) and first[-2:] != "ly"
    )


def _is_apposed_to_somebody(after: str) -> bool:
    """``in the house of Pyotr Ilyich, the postmaster of a small town``: no place."""
    phrase = next(find_person_nouns(after[2:60]), None) if after.startswith(", ") else None
    return phrase is not None and phrase.start == 0


def add_name(roster: Roster, at: int, name: str, text: str, family: bool) -> None:
    """Add somebody named; Mr. Barrow is Simon Barrow unless the story is about a family.

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
            roster.call(person, words[0])
        if titled:
            return
    if not family and words[0].strip(".") in lexicon.TITLES and len(words) == 2:
        gender = lexicon.TITLE_GENDER.get(words[0].strip("."), "unknown")
        for person in roster.find(words[1]):
            if "unknown" in (gender, person.gender) or gender == person.gender:
                roster.call(person, bare(name))
    if roster.find(name):
        return
    person = roster.add(name, at)
    look = re.match(r"\s*,\s*(an? [^,.;]*)", text[at + len(name) : at + len(name) + 80])
    if look:
        describe(person, look.group(1))
    later = _LATER_LOOK.match(text[at + len(name) : at + len(name) + 160])
    if later:
        describe(person, later.group(1))
