"""Finds nouns for people and animals with a determiner: ``a tall man``, ``his little brother``, ``two guards``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import unaccented
from storyblender.agents.director.reader.language.morphology import is_person_noun
from storyblender.catalog.inflection import singular

_DETERMINER = re.compile(
    r"\b(the|a|an|his|her|their|my|our|two|three|four|five|one|(?<=[a-z])['’]s)\s+(?=((?:[a-z’'-]+,?\s+){0,3}[a-z-]+))",
    re.IGNORECASE,
)
_THINGS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.WORN | lexicon.SCENERY | lexicon.PLACES
_TOYS = lexicon.words("toys")
"""``a rocking horse``: words that make an animal a thing."""
_SMALL = lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS | lexicon.DETERMINERS | lexicon.POSSESSIVES


class PersonNoun(NamedTuple):
    """A noun phrase for a person or an animal in running text."""

    start: int
    """Of the determiner, in the text searched."""
    end: int
    determiner: str
    adjectives: tuple[str, ...]
    noun: str
    """Singular."""
    plural: bool


def _is_a_place(word: str) -> bool:
    """Whether a word names a place: ``the Anchor Café``."""
    return word.istitle() and unaccented(word.lower()) in lexicon.PLACES


def _names_a_thing(noun: str, word: str, after: str) -> bool:
    """Whether an animal's noun is part of a thing's name or a comparison: ``a camel coat``."""
    following = re.match(r" ([^\W\d_]+)", after)
    if noun != word or following is None:
        return False
    if (noun, following.group(1)) == ("crew", "cut") or _is_a_place(following.group(1)):
        return True
    if noun not in lexicon.ANIMALS:
        return following.group(1) in lexicon.ANIMALS  # a hermit crab is an animal
    return following.group(1) in _THINGS or is_person_noun(singular(following.group(1)))


def find_person_nouns(text: str) -> Iterator[PersonNoun]:
    """Yield every noun for a person or animal with a determiner and at most three words between."""
    for match in _DETERMINER.finditer(text):
        at = match.end()
        adjectives: list[str] = []
        for word in match.group(2).split():
            low = word.lower().strip(",")
            noun = singular(low)
            at = text.index(word, at) + len(word.rstrip(","))
            if low in _SMALL:
                break
            toy = noun in lexicon.ANIMALS and bool(_TOYS & set(adjectives))
            if is_person_noun(noun) and (toy or _names_a_thing(noun, low, text[at:])):
                break
            if is_person_noun(noun):
                yield PersonNoun(match.start(), at, match.group(1).lower(), tuple(adjectives), noun, noun != low)
                break
            adjectives.append(low)
