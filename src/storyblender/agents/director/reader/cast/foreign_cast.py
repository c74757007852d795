"""The cast of a script in German, Spanish, French or Italian: nouns for people and animals, genders by pronouns."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.lexicon.foreign import Tongue
from storyblender.agents.director.reader.manuscript import Manuscript, without_brackets, without_quotations
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_WORD = re.compile(r"[^\W\d_]+")
_COMPOUND = 4
"""Least letters of a German noun at the end of a compound: ``REVIERKATZE``."""
_VOTING = 160
"""Characters after a name within which the next pronoun gives the gender."""
_ENDINGS: dict[str, Gender] = {"a": "female", "o": "male"}
_PRONOUNS: dict[str, dict[str, Gender]] = {
    "de": {"er": "male", "sie": "female"},
    "es": {"él": "male", "ella": "female"},
    "fr": {"il": "male", "elle": "female"},
    "it": {"lui": "male", "lei": "female"},
}


@rule("people.another_language")
def add_foreign(roster: Roster, script: Manuscript) -> None:
    """Add people and animals named by a noun of the script's language, with kind and gender.

    Args:
        roster: The people with names; changed.
        script: A script in a language without a grammar in the reader.
    """
    tongue = script.tongue
    if tongue is None:
        return
    for paragraph in script.paragraphs:
        if paragraph.kind != "action":
            continue
        text = without_quotations(without_brackets(paragraph.body))
        for match in _WORD.finditer(text):
            english = _person_noun(match.group(), tongue)
            if english and match.group().isupper():
                _add(roster, match.group(), english, paragraph.start + match.start())
    for person in roster.people:
        english = _person_noun(person.name.split()[-1], tongue)
        if english and not person.role and " " not in person.name:
            _set_kind(person, english)
        if person.gender == "unknown" and person.kind == "human":
            others = {alias for other in roster.people if other is not person for alias in other.aliases}
            person.gender = _gender_of(person, others, script.text, tongue)
    roster.sort()


def _person_noun(word: str, tongue: Tongue) -> str:
    """Return the English noun for a person noun, also at the end of a German compound; empty if there is none."""
    low = word.lower()
    if low in tongue.people:
        return tongue.people[low]
    if tongue.key != "de" or not word[0].isupper():
        return ""
    ends = [noun for noun in tongue.people if len(noun) >= _COMPOUND and low.endswith(noun)]
    return tongue.people[max(ends, key=len)] if ends else ""


def _add(roster: Roster, word: str, english: str, at: int) -> None:
    """Add a person of a noun at an offset."""
    known = roster.find(word) or [person for person in roster.people if word.upper() in person.name.upper().split()]
    if known:
        return
    _set_kind(roster.add(word, at), english)


def _set_kind(person: Person, english: str) -> None:
    """Set kind and gender of a person by the English noun."""
    person.role = english
    person.gender = lexicon.gender_of_word(english)
    person.kind = "animal" if english in lexicon.ANIMALS else person.kind
    person.age = person.age or lexicon.AGE_NOUNS.get(english, "")


def _gender_of(person: Person, others: set[str], text: str, tongue: Tongue) -> Gender:
    """Return the gender by the name's ending, else by the next pronoun before another name."""
    first = person.name.split()[0].lower()
    if tongue.key != "fr" and first[-1] in _ENDINGS:
        return _ENDINGS[first[-1]]
    names = "|".join(re.escape(alias) for alias in person.aliases if alias == bare(alias))
    for mention in re.finditer(rf"\b(?:{names})\b", text, re.IGNORECASE) if names else ():
        for word in _WORD.findall(text[mention.end() : mention.end() + _VOTING]):
            if word.lower() in others:
                break
            if word.lower() in _PRONOUNS[tongue.key]:
                return _PRONOUNS[tongue.key][word.lower()]
    return "unknown"
