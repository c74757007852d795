"""Scene headings: interior or exterior, place, time, weather, and the earlier scene in the same place (notes, 4.5)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from itertools import islice
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Paragraph
from storyblender.agents.director.reader.page.hours import (
    default_time,
    heading_time,
    is_time,
    is_time_passage,
    weather_of,
)
from storyblender.agents.director.reading import SceneReading
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import SceneType, TimeOfDay
from storyblender.screenplay.headings import Side, heading_words

_NUMBER = re.compile(r"\s*#[^#]*#\s*$|\s+[A-Z]?\d+[A-Z]?\s*$")
_DASH = re.compile(
    r"\s+[-–—]+\s*|\s*[–—]+\s*|\s+--\s*|--+|(?<=[a-z]{3})-(?=[A-Z]{3})|\s*/\s*(?=(?:DAY|NIGHT|MORNING|EVENING|DAWN|DUSK)\b)"
)
_BACK = re.compile(
    r"^back (?:in|at|to|on) (?:the )?|^(?:the|a|an|in|at|on|el|la|los|las|le|les|der|die|das) |^(?:l|dell)['’]"
)
_STOP = re.compile(
    r"(?<=[^\W\d_]{2})(?<!\bST)(?<!\bMT)(?<!\bDR)(?<!\bMR)(?<!\bMRS)(?<!\bFT)(?<!\bNO)(?<!\bSt)\."
    r"(?:\s+(?=[A-ZÀ-Þ0-9])|(?=(?:EARLY |LATE )?(?:DAY|NIGHT|MORNING|EVENING|DAWN|DUSK|AFTERNOON|NOCHE|D[ÍI]A|NUIT"
    r"|JOUR|TAG|NACHT)\b))"
)
"""``INT. ASHDOWN PARK, BALLROOM. NIGHT. 1811``: full stops divide like dashes."""
_BRACKETS = re.compile(r"\s*\([^)]*\)\s*")
_TITLED = re.compile(r"[\"“'‘][^\"”]*[\"”'’]")
"""``Scene One "Notes"``: a title, and no place."""
_LATELY = 250
"""Scenes back in which a place may be that is named shorter now."""
_SMALL = frozenset({"the", "a", "of", "in", "at", "s"})


class _Place(NamedTuple):
    """Place and time of a heading."""

    whole: str
    first: str
    """The part before the first dash: the building."""
    time: TimeOfDay
    written: str


def read_heading(paragraph: Paragraph, scenes: list[SceneReading]) -> SceneReading:
    """Read ``INT. MUSEUM - VAULT CORRIDOR - CONTINUOUS``, or any other heading form of ``headings``.

    Args:
        paragraph: The heading.
        scenes: The scenes before; the new one takes the next id.
    """
    heading = " ".join(paragraph.text.replace("\\", "").split())
    words = heading_words(_NUMBER.sub("", heading) if not paragraph.scene_number else heading)
    found = _place_and_time(words.place.strip(" .-"), scenes)
    place = _BACK.sub("", "" if _TITLED.fullmatch(found.whole) else found.whole.lower())
    scene_type = _scene_type(words.side, place)
    return SceneReading(
        id=len(scenes) + 1,
        heading=heading,
        place=place,
        place_kind=lexicon.place_kind(place),
        scene_type=scene_type,
        time=found.time,
        time_written=found.written,
        weather=weather_of(heading),
        reference=same_place(place, scene_type, scenes, _BACK.sub("", found.first.lower())),
        number=paragraph.scene_number or words.number,
        start=paragraph.start,
        end=paragraph.end,
    )


def first_scene(paragraph: Paragraph) -> SceneReading:
    """Return the scene of a script that starts without a heading."""
    return SceneReading(1, "", "", "", "outdoor", "day", start=paragraph.start, end=paragraph.end)


def _place_and_time(rest: str, scenes: list[SceneReading]) -> _Place:
    """Return place and time of a heading without its ``INT.`` or ``EXT.``"""
    parts = [part for whole in _DASH.split(rest) if whole for part in _STOP.split(whole) if part.strip()]
    if len(parts) == 1 and "," in rest:
        place, last = rest.rsplit(",", 1)
        parts = [place, last.strip()] if is_time(last) or is_time_passage(last) else parts
    if len(parts) == 1 and (bracket := re.search(r"\(([^)]+)\)\s*$", rest)) and is_time(bracket[1]):
        parts = [rest[: bracket.start()].strip(), bracket[1]]
    time: TimeOfDay | None = None
    written: list[str] = []
    kept = len(parts)
    while kept > 1:
        last = parts[kept - 1].strip(" .").upper()
        told = heading_time(last)
        if not told and not is_time_passage(last) and (kept < 3 or weather_of(last) == "clear"):
            break
        written.insert(0, last)
        kept -= 1
        time = time or told
        if told and not is_time(last):
            break
        if told and kept > 1 and not is_time_passage(parts[kept - 1]):
            break
    parts = parts[:kept]
    if len(parts) == 1 and not written:
        parts, time, written = _trailing_time(parts[0])
    whole = _BRACKETS.sub(" ", " ".join(parts)).strip(" .,")
    first = _BRACKETS.sub(" ", parts[0]).strip(" .,") if parts else ""
    goes_on = scenes[-1].time if written and scenes else default_time(scenes, _BACK.sub("", whole.lower()))
    return _Place(whole, first, time or goes_on, " ".join(written))


def _trailing_time(place: str) -> tuple[list[str], TimeOfDay | None, list[str]]:
    """Split a heading without dashes: ``KITCHEN NIGHT``; it may be a time of day alone."""
    words = place.split()
    if is_time(place) and len(words) < 4:
        return [], heading_time(place), [place.upper()]
    if len(words) > 1 and words[-1].upper() in ("DAY", "NIGHT", "NOCHE", "DÍA", "NUIT", "JOUR", "TAG", "NACHT"):
        return [" ".join(words[:-1])], heading_time(words[-1]), [words[-1].upper()]
    return [place], None, []


def _scene_type(side: Side, place: str) -> SceneType:
    """Return the scene type by ``INT.`` or ``EXT.``, else by the words of the place."""
    if "," in side and place.split()[-1:] and place.split()[-1] in lexicon.OUTDOOR - lexicon.INDOOR:
        return "outdoor"
    if side:
        return "outdoor" if side.startswith("outside") else "indoor"
    return "indoor" if set(re.findall(r"[^\W\d_-]+(?:-\w+)?", place)) & lexicon.INDOOR else "outdoor"


@rule("place.same")
def same_place(place: str, scene_type: SceneType, scenes: list[SceneReading], building: str = "") -> int | None:
    """Return the id of the first scene in the same place, else with all its words in its place, else in its building.

    Args:
        place: The name of the place.
        scene_type: Inside or outside.
        scenes: The scenes before.
        building: The first part of the heading: the pool of ``POOL - KIOSK``; used only if both are one kind of place.
    """
    exact = next((s.id for s in scenes if place and s.place == place and s.scene_type == scene_type), None)
    if exact:
        return exact
    words, whole = _words(place), _words(building)
    kind = lexicon.place_kind(place)
    lately = [s for s in islice(reversed(scenes), _LATELY) if s.scene_type == scene_type]
    containing = next((s for s in lately if words and words <= _words(s.place)), None)
    if containing is None and whole and whole != words and kind:
        last = building.split()[-1]
        named = (s for s in lately if whole <= _words(s.place) and s.place.endswith(last))
        containing = next((s for s in named if s.place_kind == kind and s.reference is None), None)
    return (containing.reference or containing.id) if containing else None


@lru_cache(maxsize=16384)
def _words(place: str) -> frozenset[str]:
    """Return the words of a place that tell it from others."""
    return frozenset(re.findall(r"[^\W_]+", place)) - _SMALL


_OUTSIDE, _INSIDE, _AFLOAT = lexicon.words("outdoor_sign"), lexicon.words("indoor_sign"), lexicon.words("afloat")
_ENOUGH = 2
"""Least number of signs that switch a scene between inside and outside."""
_WATERS = frozenset({"sea", "ocean", "river", "lake", "bay", "water", "lagoon"})


@rule("place.side")
def settle_sides(text: str, scenes: Sequence[SceneReading], *, chat: bool = False) -> None:
    """Set scenes to interior or exterior where only the things in them can decide it.

    Args:
        text: The script.
        scenes: The scenes in order; changed here.
        chat: The page is a chat, whose senders are in different places.
    """
    for index, scene in enumerate(scenes):
        words = re.findall(r"[a-z]+", text[scene.start : scene.end].lower())
        outside, inside = ({word for word in words if word in signs} for signs in (_OUTSIDE, _INSIDE))
        if not scene.place and not scene.heading and not chat:
            scene.scene_type = "indoor" if len(inside) > len(outside) else scene.scene_type
        inherited = index > 0 and not scene.heading and scene.place == scenes[index - 1].place
        if inherited and scene.scene_type == "indoor" and len(outside) >= _ENOUGH > len(inside):
            _set_exterior(scene, words)
        if scene.place in _WATERS and len({*words} & _AFLOAT) >= _ENOUGH:
            scene.place, scene.place_kind = f"boat on the {scene.place}", "ship_deck"


def _set_exterior(scene: SceneReading, words: Sequence[str]) -> None:
    """Move a scene outside the door of the place that it inherits."""
    places = lexicon.OUTDOOR - lexicon.INDOOR
    named = next((word for word in words if word in places and word in lexicon.PLACE_KINDS), "yard")
    scene.place, scene.place_kind = named, lexicon.place_kind(named)
    scene.scene_type, scene.reference = "outdoor", None
