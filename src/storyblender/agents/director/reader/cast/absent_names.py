"""Names in a story of people who are never there: in a bust or a portrait, or only in what had been before."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.agents.director.reader.language.text_index import TextIndex
from storyblender.agents.director.rules import rule

_IMAGE_OF = re.compile(rf"\b(?:{'|'.join(sorted(lexicon.words('images')))})s? of $", re.IGNORECASE)
_DONE = frozenset({"past", "3sg", "aux"})
_NEAR = 24
"""Characters before a name in which an image is told."""


_BEFORE = re.compile(r"(?<![a-z])[a-z]{1,40} $")
_AFTER = re.compile(r"(?:['’]s)?(?: ([a-z]+))?(?= ([a-z]+))?")


@rule("people.only_told_of", without=False)
def is_only_told_of(name: str, told: TextIndex) -> bool:
    """Whether somebody is an image and never does anything, or is told of only as they had been.

    Args:
        name: As written.
        told: The words of the story without what is said.
    """
    images, acting, earlier, named, end = 0, 0, 0, 0, 0
    for at in told.places(name):
        before = _BEFORE.search(told.text, max(end, at - _NEAR - 17), at) if at >= end else None
        after = _AFTER.match(told.text, at + len(name))
        if after is None or at < end:
            continue
        start = before.start() if before else at
        images += _IMAGE_OF.search(told.text[max(0, start - _NEAR) : at if before else at + 1]) is not None
        then, following = after.groups()
        before_then = then == "had" and form_kind(following or "") in ("past", "pp", "aux")
        earlier += before_then
        words = (before[0].rstrip() if before else "", then)
        acting += not before_then and any(word and form_kind(word) in _DONE for word in words)
        named, end = named + 1, after.end()
    return bool(named) and not acting and (images > 0 or earlier == named)
