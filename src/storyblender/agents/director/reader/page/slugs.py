"""Half-headings inside a scene: ``IN THE GARAGE``, ``AT THE DOOR - LATER``, ``STABLE:``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director.reader.page.hours import heading_time
from storyblender.agents.director.reader.page.told_places import ToldPlace, place_set_down, type_of_place
from storyblender.agents.director.reading import SceneReading
from storyblender.agents.director.rules import rule
from storyblender.screenplay.headings import LEADING_WORDS

_SLUG = re.compile(
    r"(?:BACK |LATER,? |MEANWHILE,? )?(?:(?:IN(?:SIDE)?|AT|ON|TO|OUTSIDE|UNDER|BEHIND|NEAR|BY|ACROSS"
    r"|ABOARD) )*(?:THE |A |HIS |HER |THEIR )?"
    r"(?P<place>[A-ZÀ-Þ][A-ZÀ-Þ0-9'’&]*(?: [A-ZÀ-Þ0-9'’&]+){0,4})(?P<time>\s*[-–—,]+\s*[A-ZÀ-Þ ]+)?\s*(?P<mark>:"
    r"|\.?\s*(?:\n|$))"
)
_HEAD = re.compile(r"(?:BACK |LATER|MEANWHILE)?(?:IN|INSIDE|AT|ON|TO|OUTSIDE|UNDER|BEHIND|NEAR|BY|ACROSS|ABOARD)\b")
_SMALL = frozenset({"the", "a", "of", "in", "at"})


@rule("place.slug")
def slug_of(text: str, scenes: Sequence[SceneReading]) -> ToldPlace | None:
    """Return the place that a paragraph begins with in capitals, or None.

    It must be known as a place, or be part of the name of an earlier scene's place.

    Args:
        text: The paragraph.
        scenes: The scenes before.
    """
    match = _SLUG.match(LEADING_WORDS.sub("", text))
    if match is None or (match["mark"] != ":" and "\n" not in match["mark"] and match.end() < len(text)):
        return None
    place = match["place"].lower().replace("’", "'")
    time = heading_time(match["time"] or "")
    beside = (match["time"] or "").strip(" -–—,").lower()
    told = place_set_down(beside) if beside and time is None else None
    if told and told.place:
        return told._replace(scene_type=type_of_place(told.place, scenes[-1].scene_type if scenes else "outdoor"))
    been = place_before(place, scenes)
    if been:
        return ToldPlace(been.place, been.scene_type, time)
    if not _HEAD.match(text) and not (match["time"] or match["mark"] == ":"):
        return None
    told = place_set_down(match[0].strip(" :.\n").lower())
    return ToldPlace(told.place, type_of_place(told.place), time) if told and told.place else None


def place_before(words: str, scenes: Sequence[SceneReading]) -> SceneReading | None:
    """Return the last scene whose place contains all these words."""
    wanted = frozenset(re.findall(r"[^\W_]+", words.lower())) - _SMALL
    if not wanted:
        return None
    found = (scene for scene in reversed(scenes[-100:]) if wanted <= frozenset(re.findall(r"[^\W_]+", scene.place)))
    return next(found, None)
