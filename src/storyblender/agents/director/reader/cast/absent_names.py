"""Names in a story of people who are never there: in a bust or a portrait, or only in what had been before."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import form_kind

_IMAGE_OF = re.compile(rf"\b(?:{'|'.join(sorted(lexicon.words('images')))})s? of $", re.IGNORECASE)
_DONE = frozenset({"past", "3sg", "aux"})
_NEAR = 24
"""Characters before a name in which an image is told."""


def is_only_told_of(name: str, told: str) -> bool:
    """Whether somebody is an image and never does anything, or is told of only as they had been.

    Args:
        name: As written.
        told: The story without what is said.
    """
    images, acting, earlier = 0, 0, 0
    named = list(re.finditer(rf"(?:([a-z]+) )?\b{re.escape(name)}\b(?:['’]s)?(?: ([a-z]+))?(?= ([a-z]+))?", told))
    for match in named:
        before = told[max(0, match.start() - _NEAR) : match.start() + len(match[1] or "") + 1]
        images += _IMAGE_OF.search(before) is not None
        before_then = match[2] == "had" and form_kind(match[3] or "") in ("past", "pp", "aux")
        earlier += before_then
        acting += not before_then and any(word and form_kind(word) in _DONE for word in match.groups()[:2])
    return bool(named) and not acting and (images > 0 or earlier == len(named))
