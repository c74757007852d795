"""Where a paragraph of prose changes the scene: a new place or a jump in time at its start."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Paragraph, without_quotations
from storyblender.agents.director.reader.morphology import form_kind
from storyblender.agents.director.reader.scenes import same_place, time_of, weather_of
from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import SceneType

_PLACE_PHRASE = re.compile(
    r"(?=\b(?:in|at|into|to|inside|reached|entered|through|on|near|outside|of|across|aboard|along|over|up|down|by|behind"
    r"|above|upon|beside|round)\s+"
    r"(?:the|a|an|his|her|their)\s+((?:[a-z'’-]+\s+){0,3}[a-z'’-]+))"
)
_NUMBERED = re.compile(
    r"\b((?:room|cabin|cell|ward|suite|flat|apartment|compartment|berth|bay|platform|hangar|studio|laboratory|lab)"
    rf" (?:number )?(?:\d+|{'|'.join(sorted(set(lexicon.NUMBERS) - {'a', 'an'}))}))\b"
)
"""``the door of Room Nine``."""
_SENTENCE_END = re.compile(r"(?<=[.!?])(?<!Mr\.)(?<!Dr\.)(?<!Ms\.)(?<!Mrs\.)\s")
_NOUN_PHRASE = re.compile(r"(?=\b(?:the|a|an|his|her|their)\s+((?:[a-z'’-]+\s+){0,3}[a-z'’-]+))")
_TIME_JUMP = re.compile(
    r"(?:(?:early |late )?(?:the next|next|that|one|on|by|at|in the|the following|some|years|weeks|days|hours|later"
    r"|soon after|a (?:week|month|year|day|few)|when|after|before|towards?|two|three|four|five|six|seven|ten)\b)[^,.]*"
    r"\b(?:morning|day|night|evening|noon|afternoon|dawn|dusk|sunset|sunrise|midnight|weeks?|months?|years?|days|hours"
    r"|later|winter|spring|summer|autumn|(?:mon|tues|wednes|thurs|fri|satur|sun)day)\b|meanwhile|later\b"
)
_PLACE_FIRST = re.compile(
    r"(?:(?:deep|high|far|down|out|up|back|over|not far|just) )*"
    r"(?:in|at|on|inside|outside|aboard|across|near|behind|under)\b"
)
_ARRIVAL = re.compile(
    r"\b(?:reached|arrived|entered|returned|sailed|came back|(?:came|got|went) home|(?:came|went|drove|rode) to)\b"
)
_HOME = re.compile(r"\b(?:came|went|returned|was|got) home\b")
_NEXT_DAY = re.compile(
    r"(?:early |late )?(?:in|on|by|at|with|towards?|the|next)\b[^,.;]*?"
    r"\b(?:next|following) (?:day|morning|evening|night|afternoon)\b|(?:early |late )?next (?:day|morning|evening)\b"
)
"""``In the pale sun next morning``: a scene of its own, where the last one was if it names no place."""
_OTHER_TIME = re.compile(r"(?:that|in the|by|towards?|at) (?:\w+ )?(?:morning|evening|night|noon|dawn|dusk|midnight)\b")
"""``In the morning there was an egg``: the same place, unless one is named."""
_SMALL = lexicon.PREPOSITIONS | lexicon.DETERMINERS | lexicon.CONJUNCTIONS
_PLAIN = lexicon.ADJECTIVES | _SMALL | {"", "other", "next", "same", "whole", "own", "old", "empty", "single"}
"""``the day room`` is a kind of room, ``the little room`` is not."""
_THINGS = lexicon.PROPS | lexicon.SET_PIECES


def read_scene_change(paragraph: Paragraph, scenes: list[SceneReading], title: str = "") -> SceneReading | None:
    """The scene a paragraph opens, or None where it goes on with the last.

    A place in the middle of a sentence is only where somebody is (``They pulled him into the kitchen``); a new scene
    is told by an opening: a place or a time at its start, or somebody who arrives.

    Args:
        paragraph: A paragraph of prose; its first sentence is searched, after a jump in time also the second.
        scenes: The scenes before.
        title: Of the story; may tell when it begins.
    """
    told = _SENTENCE_END.split(without_quotations(paragraph.raw).lower())
    opening = told[0]
    if scenes:
        later = (_TIME_JUMP.match(opening) or _NEXT_DAY.match(opening)) is not None
        if not (later or _PLACE_FIRST.match(opening) or _ARRIVAL.search(opening)):
            return None
        place = _place(opening, scenes) or (_place(told[1], scenes) if later and len(told) > 1 else "")
        next_day = _NEXT_DAY.match(opening) is not None
        hour = time_of(opening) if later else None
        elapsed = hour is not None and hour != scenes[-1].time and _OTHER_TIME.match(opening) is not None
        if not (next_day or elapsed) and place in ("", scenes[-1].place):
            return None
        place = place or scenes[-1].place
    else:
        whole = " ".join(told)
        place = _place(opening, scenes) or _place(whole, scenes) or _any_place(whole)
    time = time_of(opening) or (time_of(" ".join(told)) or time_of(title) if not scenes else None)
    scene_type = _scene_type(place)
    return SceneReading(
        id=len(scenes) + 1,
        heading="",
        place=place,
        place_kind=lexicon.place_kind(place),
        scene_type=scene_type,
        time=time or (scenes[-1].time if scenes else "day"),
        time_written=time or "",
        weather=weather_of(opening),
        reference=same_place(place, scene_type, scenes),
        start=paragraph.start,
        end=paragraph.end,
    )


def _place(opening: str, scenes: list[SceneReading]) -> str:
    """The place a sentence happens in; a known kind of place wins over others, else the first named."""
    if _HOME.search(opening) and scenes:
        return scenes[0].place
    numbered = _NUMBERED.search(opening)
    if numbered:
        return numbered.group(1)
    places = [
        _part(opening[: match.start()]) or _leading_place(match.group(1).split())
        for match in _PLACE_PHRASE.finditer(opening)
    ]
    named = [place for place in places if place and place != "room"]
    known = [place for place in named if place in lexicon.PLACE_KINDS]
    return (known or named or [""])[0]


def _part(before: str) -> str:
    """``the yard of the inn``: the yard; where a preposition follows another place, that place."""
    words = before.split()
    return words[-1] if words and words[-1] in lexicon.PLACES and words[-2:-1] == ["the"] else ""


def _any_place(text: str) -> str:
    """The first place a text names at all: ``had kept the lighthouse for forty years``."""
    places = [_leading_place(match.group(1).split()) for match in _NOUN_PHRASE.finditer(text)]
    return next((place for place in places if place), "")


def _leading_place(words: list[str]) -> str:
    """``small cottage at the edge`` -> cottage; ``castle gate`` stays two words."""
    for index, word in enumerate(words):
        if word in _SMALL:
            return ""
        compound = index + 1 < len(words) and words[index + 1] in lexicon.PLACES | _THINGS
        if word in lexicon.PLACES and not compound:
            before = words[index - 1] if index else ""
            pair = f"{before} {word}".strip()
            of_a_kind = word == "room" and before not in _PLAIN and form_kind(before) in ("", "ing")
            return pair if of_a_kind or before in lexicon.PLACES | _THINGS or pair in lexicon.PLACE_KINDS else word
    return ""


def _scene_type(place: str) -> SceneType:
    head = place.partition(" ")[0] if _NUMBERED.match(place) else place.rpartition(" ")[2]
    return "indoor" if head in lexicon.INDOOR and head not in lexicon.OUTDOOR else "outdoor"
