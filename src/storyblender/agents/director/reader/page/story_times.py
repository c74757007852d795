"""What time of day a story begins at, where it says so in other words: ``It was long past dark``, ``past nine``."""

from __future__ import annotations

import re

from storyblender.agents.director.reader.page.hours import time_of
from storyblender.memory.vocabulary import TimeOfDay

_DARK = re.compile(
    r"\b(?:past|after|since|by) dark\b|\bin the dark(?:ness)?\b(?! of)|\bit was (?:\w+ )?dark\b"
    r"|\b(?:dark|darkness) (?:had )?(?:fell|fallen|came)\b|\b(?:the (?:full |new |half )?moon|the stars|starlight)\b"
    r"|\b(?:candle|lamp|torch)light\b|\bstreet ?lamps?\b|\bheadlights\b|\blights went out\b"
)
_LATE = re.compile(
    r"\b(?:past|at|after|by|before|nearly|almost|about) (?:\w+ past )?(?:nine|ten|eleven|twelve)(?: o'clock)?\b"
    r"(?! (?:minutes|hours|days|years|men|people|steps|miles|feet|times|of|or|and)\b)"
)
_SUN = re.compile(r"\b(?:the sun was|in the sun|sunlight|sunshine|the midday)\b")
_GREY = re.compile(r"\b(?:first|grey|gray|pale) (?:grey |gray )?light\b")
_GONE = re.compile(r"\b(?:since|until|till|last|yesterday|tomorrow)\W+(?:\w+ )?$")
"""``since noon``, ``last night``: another time than now."""


def story_time(told: list[str], title: str) -> TimeOfDay | None:
    """The time a story begins at, from its first paragraph or its title; None where they tell none.

    Args:
        told: Sentences of the paragraph, in small letters, without speech.
        title: Of the story.
    """
    whole = " ".join(told)
    return _now(told[0]) or _now(whole) or time_of(title)


def _now(text: str) -> TimeOfDay | None:
    for match in re.finditer(r"[a-z]+", text):
        named = time_of(match.group(0))
        if named and not _GONE.search(text[: match.start()]):
            return named
    if _DARK.search(text) or (_LATE.search(text) and "morning" not in text and not _SUN.search(text)):
        return "night"
    return "dawn" if _GREY.search(text) else None
