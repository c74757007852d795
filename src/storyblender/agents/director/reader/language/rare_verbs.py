"""Verbs of the large list that are more often nouns, and unknown words in a verb's position."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import RARE_FORMS, VerbForm, form_kind, guess_lemma
from storyblender.agents.director.reader.language.words import TaggedRow, Word
from storyblender.catalog.inflection import singular

OPENERS = lexicon.DETERMINERS | lexicon.POSSESSIVES
OBJECTS = OPENERS | {"him", "her", "it", "them", "himself", "herself", "itself", "themselves", "each"}
"""Words that start the object of a verb, and hardly ever follow a plural noun."""
DIRECTIONS = lexicon.words("directions")
BEFORE_NOUN = OPENERS | lexicon.PREPOSITIONS | {"'s"}
AFTER_VERB = OPENERS | lexicon.PREPOSITIONS | {".", ",", ";", ":", "open", "shut", "and", "slowly", "away", "back"}
SELDOM_VERBS = frozenset(
    {
        "finger",
        "knee",
        "eye",
        "hand",
        "thumb",
        "elbow",
        "boot",
        "arm",
        "leg",
        "toe",
        "heel",
        "foot",
        "ear",
        "lip",
        "tooth",
    }
    | {
        "hoof",
        "knuckle",
        "shoe",
        "glove",
        "sock",
        "hair",
        "paw",
        "tail",
        "wing",
        "fist",
        "palm",
        "mouth",
        "chin",
        "cheek",
    }
)
"""Parts of bodies and garments that are verbs only with an object: ``hands her the key``."""
_ANY_NOUNS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.BODY | lexicon.WORN | lexicon.ABSTRACT | lexicon.SCENERY


def rare_verb(word: Word, following: Word | None, row: TaggedRow) -> VerbForm | None:
    """Return the verb form of a rarely used verb, or of an unknown word in -s or -ed: ``the train barrels``.

    Args:
        word: The word.
        following: The next word, or None.
        row: The words before it, tagged.
    """
    left = row.neighbour()
    right = following.low if following else "."
    form = RARE_FORMS.get(word.low)
    if left is None or not word.text.islower() or len(word.low) < 4:
        return form if left is None and form and form.kind == "3sg" and right in OBJECTS else None
    if form and form.kind == "3sg" and right in OBJECTS:
        return form if left.low not in BEFORE_NOUN else None
    after_person = (left.mention is not None and left.mention.kind != "group") or left.low in ("he", "she", "it")
    listed = left.low in ("and", ",", "then", "but") and row.verb_seen
    after_noun = form is not None and not row.verb_seen and left.solid and left.low not in BEFORE_NOUN
    if form and form.kind == "3sg" and left.mention and left.named and form_kind(right) not in ("past", "aux"):
        return form
    past = form is not None and form.kind == "past"
    if not (after_person or listed or after_noun) or not (may_follow_verb(right) or (past and listed)):
        return None
    if form is None:
        form = _guessed(word) if after_person or (listed and any(w.mention for w in row.words)) else None
    told = listed and word.low not in lexicon.ADJECTIVES and not row.last_kind
    if form is None or (form.kind == "past" and (listed or after_noun) and right not in OBJECTS and not told):
        return None
    known_noun = form.kind == "3sg" and singular(word.low) in _ANY_NOUNS
    return None if known_noun and not after_person else form


def _guessed(word: Word) -> VerbForm | None:
    """Return the form of an unknown verb by its ending, or None."""
    if re.search(r"[^s]s$", word.low):
        known_noun = singular(word.low) in _ANY_NOUNS
        return None if known_noun else VerbForm(guess_lemma(word.low), "3sg")
    return VerbForm(word.low[:-2], "past") if word.low.endswith("ed") else None


def may_follow_verb(right: str) -> bool:
    """Whether a word may follow a verb: it opens an object, or is a direction or an adverb."""
    return right in AFTER_VERB or right in OBJECTS | DIRECTIONS | {"not", "to"} or right.endswith("ly")


def is_listed_part(word: Word, left: Word | None, following: Word | None) -> bool:
    """Whether a body part after a comma is a noun: ``his face weathered, eyes tired``.

    Args:
        word: The word.
        left: The word before it, or None.
        following: The word after it, or None.
    """
    right = following.low if following else "."
    return (
        left is not None
        and left.low in (",", ";", "and")
        and singular(word.low) in SELDOM_VERBS
        and right not in OBJECTS
    )
