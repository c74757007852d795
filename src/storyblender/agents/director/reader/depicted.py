"""What a sentence tells only of a picture, a screen or a dream, so that it is not on the set."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.language.words import Word
from storyblender.catalog.inflection import singular

_IMAGES = lexicon.words("images")
_SCREENS = lexicon.words("screens")
_SHOWING = frozenset({"show", "depict", "display", "portray"})
_ONES = frozenset({"one", "other", "another", "third", "second", "first", "next", "last"})
"""``On the left one``, after the monitors."""
_NEAR = 4
"""Things back to the one that ``it`` is, which shows something."""
_OPENING = 6
"""Most words of a place at the start of a sentence."""
_RESTING = frozenset({"stand", "sit", "lie", "lean", "hang", "rest"})
"""``On the television stands a vase``: no picture of one."""
_STOPS = frozenset({",", ";", ".", ":", "!", "?", "--", "—", "–", "(", ")"})


def split_depicted(words: list[Word], lately: Sequence[str]) -> tuple[list[Word], list[Word]]:
    """Split the words of a sentence into what is there and what a screen in it shows.

    What a picture or a dream shows is in neither.

    Args:
        words: Words of the sentence.
        lately: Head nouns of the things named lately.
    """
    start = _depiction_start(words, lately)
    return words[:start], words[start:]


def _depiction_start(words: Sequence[Word], lately: Sequence[str]) -> int:
    """Return the index of the first word of what a screen or a picture shows; the length if none."""
    screen = any(head in _SCREENS for head in lately)
    place = _opening_place(words, screen)
    if place:
        return place
    pictures = _SCREENS | _IMAGES
    told = [singular(word.low) for word in words[:1]]
    pictured = False
    for at in range(1, len(words) - 1):
        told.append(singular(words[at].low))
        pictured = pictured or told[at - 1] in pictures
        if words[at].text == ":" and pictured:
            return at + 1
        form = FORMS.get(words[at].low)
        if form is None or form.lemma not in _SHOWING or form.kind not in ("3sg", "past"):
            continue
        of_it = told[at - 1] == "it" and any(head in pictures for head in lately[:_NEAR])
        if of_it or told[at - 1] in pictures | {"wall"}:
            return at + 1
    return len(words)


def _opening_place(words: Sequence[Word], screen: bool) -> int:
    """Return the number of words of an opening ``On the big screen``, if more follows; else 0."""
    if not words or words[0].low not in ("on", "in", "across"):
        return 0
    for at in range(1, min(_OPENING, len(words) - 2)):
        noun, after = singular(words[at].low), words[at + 1].low
        if words[at].low in lexicon.PREPOSITIONS or words[at].mention or words[at].text in _STOPS:
            return 0
        if noun in _SCREENS or (screen and words[at].low in _ONES and after not in _ONES):
            at += after in lexicon.NUMBERS
            form = FORMS.get(words[at + 1].low)
            rests = form is not None and form.lemma in _RESTING
            return 0 if rests or words[at + 1].low in lexicon.PREPOSITIONS | {"of"} else at + 1
    return 0
