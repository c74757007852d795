"""Kinds of script lines that their words alone decide: headings, transitions, divisions, page furniture."""

from __future__ import annotations

import re

from storyblender.screenplay.cues import closes_series, opens_series
from storyblender.screenplay.headings import is_heading
from storyblender.screenplay.model import ElementKind

_SECTION = re.compile(
    r"(?:END (?:OF )?)?(?:TEASER|COLD OPEN(?:ING)?|TAG|SCENE [A-Z]|ACT (?:ONE|TWO|THREE|FOUR|FIVE|SIX|[IVX]+|\d+))\.?"
    r"|(?:BEGIN |START |END (?:OF )?)?(?:[A-Z' -]*\bMONTAGE\b|SERIES OF SHOTS\b)(?:[ :.–—-][^a-z]*)?"
    r"|(?:BEGIN |START |END (?:OF )?)?(?:FLASH[ -]?(?:BACK|FORWARD)|DREAM|FANTASY)(?: SEQUENCE)?[:.]?"
    r"|(?:BACK|RETURN) TO (?:THE )?PRESENT(?: DAY)?[:.]?"
)
"""Lines in capitals that divide a script and show nothing themselves: acts, montages, ends of flashbacks."""
TRANSITION = re.compile(
    r"[^a-z]*\bTO:|(?:FADE (?:IN|OUT|TO BLACK|TO WHITE)|CUT TO BLACK|SMASH CUT|DISSOLVE)[^a-z]{0,3}|THE END\.?"
)
_PAGE_FURNITURE = re.compile(r"\(?CONTINUED\)?:?(?: ?\(\d+\))?|\d{1,3}\.")
"""What a printed page repeats at its top and bottom."""


def kind_of_words(words: str) -> ElementKind | None:
    """Return the kind of a line between blank lines by its words alone; None for action and speech."""
    if is_heading(words):
        return "heading"
    if TRANSITION.fullmatch(words):
        return "transition"
    if _SECTION.fullmatch(words) or opens_series(words) or closes_series(words):
        return "section"
    return "page_break" if _PAGE_FURNITURE.fullmatch(words) else None
