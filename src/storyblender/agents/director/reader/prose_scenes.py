"""Where a paragraph of prose changes the scene: a new place or a jump in time at its start."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Paragraph, without_quotations
from storyblender.agents.director.reader.scenes import same_place, time_of, weather_of
from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import SceneType

_PLACE_PHRASE = re.compile(
    r"(?=\b(?:in|at|into|to|inside|reached|entered|through|on|near|outside|of|across|aboard)\s+"
    r"(?:the|a|an|his|her|their)\s+((?:[a-z'’-]+\s+){0,3}[a-z'’-]+))"
)
_SENTENCE_END = re.compile(r"(?<=[.!?])(?<!Mr\.)(?<!Dr\.)(?<!Ms\.)(?<!Mrs\.)\s")
_HOME = re.compile(r"\b(?:came|went|returned|was|got) home\b")
_SMALL = lexicon.PREPOSITIONS | lexicon.DETERMINERS | lexicon.CONJUNCTIONS
_THINGS = lexicon.PROPS | lexicon.SET_PIECES


def read_scene_change(paragraph: Paragraph, scenes: list[SceneReading]) -> SceneReading | None:
    """The scene a paragraph opens, or None where it goes on with the last.

    Args:
        paragraph: A paragraph of prose; only its first sentence is searched.
        scenes: The scenes before.
    """
    opening = _SENTENCE_END.split(without_quotations(paragraph.raw))[0].lower()
    place = _place(opening, scenes)
    if scenes and (not place or place == scenes[-1].place):
        return None
    place = place or "unknown"
    scene_type = _scene_type(place)
    time = time_of(opening)
    return SceneReading(
        id=len(scenes) + 1,
        heading="",
        place=place,
        place_kind=lexicon.place_kind(place),
        scene_type=scene_type,
        time=time or (scenes[-1].time if scenes else "day"),
        time_written=time or "",
        weather=weather_of(opening),
        reference=next((scene.id for scene in scenes if scene.place == place), None)
        or same_place(place, scene_type, scenes),
        start=paragraph.start,
        end=paragraph.end,
    )


def _place(opening: str, scenes: list[SceneReading]) -> str:
    """The place a sentence happens in; a known kind of place wins over others, else the first named."""
    if _HOME.search(opening) and scenes:
        return scenes[0].place
    named: list[str] = []
    for match in _PLACE_PHRASE.finditer(opening):
        place = _leading_place(match.group(1).split())
        if place and (place != "room" or " " in place):
            named.append(place)
    known = [place for place in named if place in lexicon.PLACE_KINDS]
    return (known or named or [""])[0]


def _leading_place(words: list[str]) -> str:
    """``small cottage at the edge`` -> cottage; ``castle gate`` stays two words."""
    for index, word in enumerate(words):
        if word in _SMALL:
            return ""
        compound = index + 1 < len(words) and words[index + 1] in lexicon.PLACES
        if word in lexicon.PLACES and not compound:
            before = words[index - 1] if index else ""
            pair = f"{before} {word}".strip()
            return pair if before in lexicon.PLACES | _THINGS or pair in lexicon.PLACE_KINDS else word
    return ""


def _scene_type(place: str) -> SceneType:
    head = place.split()[-1]
    return "indoor" if head in lexicon.INDOOR and head not in lexicon.OUTDOOR else "outdoor"
