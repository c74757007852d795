"""Inserts the noun that a word of place leaves out: ``Inside lies a key``, ``a wardrobe with a suitcase on top``."""

from __future__ import annotations

from dataclasses import replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase

THERE = "there"
"""Head of the noun that is not said."""
_BARE = frozenset({"inside", "underneath", "beneath", "below", "above", "beside", "behind"})
_ALWAYS_PLACES = frozenset({"underneath", "beneath", "below", "above"})
"""No particles of a verb: ``paint cans stand underneath``, but ``steps inside``."""
_STOPS = (".", ",", ";", ":", "and")


def insert_place_nouns(phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with the noun ``there`` after each word of place without its own.

    Args:
        phrases: Of a sentence.

    Returns:
        The phrases, with a pronoun ``there`` after every bare word of place.
    """
    said: list[Phrase] = []
    for index, phrase in enumerate(phrases):
        if phrase.text == "which" and len(said) > 1 and said[-1].kind == "preposition":
            whole = next((p for p in reversed(said[-3:-1]) if p.noun), None)
            if whole and whole.noun and said[-1].text in lexicon.RELATION_OF_PREPOSITION:
                said[-1:] = [Phrase("mark", phrase.first, phrase.first, ";"), said[-1], replace(whole, noun=whole.noun)]
                continue
        if phrase.kind == "noun" and said and _is_top(said[-1], phrase, phrases[index + 1 : index + 2]):
            said[-1] = Phrase("preposition", said[-1].first, phrase.last, "on top of")
            said.append(_with_there(said[-1]))
            continue
        said.append(phrase)
        if phrase.kind == "preposition" and phrase.text in _BARE and _is_bare(phrases, index):
            said.append(_with_there(phrase))
    return said


def _with_there(place: Phrase) -> Phrase:
    """Return the noun ``there`` after a word of place."""
    return Phrase("noun", place.last, place.last, noun=NounPhrase("pronoun", place.last, THERE))


def _is_top(left: Phrase, phrase: Phrase, after: list[Phrase]) -> bool:
    """Whether a phrase is ``on top``, but not ``on the top`` or ``on top of it``."""
    noun = phrase.noun
    bare = noun is not None and noun.head == "top" and not noun.determiner and noun.possessor is None
    return bare and left.kind == "preposition" and left.text == "on" and not any(p.text == "of" for p in after)


def _is_bare(phrases: list[Phrase], index: int) -> bool:
    """Whether a word of place has no noun: it opens a clause, or ends one about a thing with another."""
    left = phrases[index - 1] if index else None
    after = phrases[index + 1] if index + 1 < len(phrases) else None
    if left is None or (left.text in (";", "and", ",") and after is not None and after.kind == "verb"):
        inverted = after is not None and after.verb is not None and after.verb.lemma in lexicon.INVERTING | {"be"}
        return inverted or (after is not None and after.text in (",", ":"))
    ends = after is None or after.text in _STOPS
    had = index > 1 and phrases[index - 2].text == "with" and left.kind == "noun"
    return ends and (had or (phrases[index].text in _ALWAYS_PLACES and left.kind == "verb"))
