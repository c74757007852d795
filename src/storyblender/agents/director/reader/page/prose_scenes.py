"""Scene changes in prose: a paragraph that begins with a new place or a jump in time."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Paragraph, without_quotations
from storyblender.agents.director.reader.page.hours import default_time, story_time, time_in_text, weather_of
from storyblender.agents.director.reader.page.prose_places import (
    WHOLE,
    destination,
    first_place,
    opening_place,
    room_within,
    scene_type_of,
    sentence_place,
    subject_place,
)
from storyblender.agents.director.reader.page.scenes import same_place
from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import TimeOfDay

_COUNT = "|".join(sorted(lexicon.NUMBERS))
_SENTENCE_END = re.compile(r"(?<=[.!?])(?<!Mr\.)(?<!Dr\.)(?<!Ms\.)(?<!Mrs\.)\s")
_TIME_JUMP = re.compile(
    r"(?:(?:early |late )?(?:the next|next|that|one|on|by|at|in the|the following|some|years|weeks|days|hours|later"
    r"|soon after|a (?:week|month|year|day|few)|when|after|before|towards?|two|three|four|five|six|seven|ten)\b)[^,.]*"
    r"\b(?:morning|day|night|evening|noon|afternoon|dawn|dusk|sunset|sunrise|midnight|weeks?|months?|years?|days|hours"
    r"|later|winter|spring|summer|autumn|(?:mon|tues|wednes|thurs|fri|satur|sun)day)\b|meanwhile|later\b"
)
_PLACE_FIRST = re.compile(
    r"(?:(?:deep|high|far|down|out|up|back|over|not far|just|upstairs|downstairs|below|above) )*"
    r"(?:in|at|on|inside|outside|aboard|across|near|behind|under)\b"
)
_YONDER = re.compile(r"(?:on|from|at|across) the (?:far|other|opposite) (?:side|bank|end|shore|edge)\b")
"""``On the far side of the river a person rang``: the story stays on this side."""
_ARRIVAL = re.compile(
    r"\b(?:reach(?:ed|es)|arrive[ds]|enter(?:ed|s)|return(?:ed|s)|sail(?:ed|s)|c[ao]mes? back|pulled into|pulls into"
    r"|(?:came|got|went|comes|gets|goes) home|(?:came|went|drove|rode|comes|goes|drives|rides) to"
    r"|(?:got|gets?|came|comes) (?:up|down|back|out|over|in) to)\b"
)
_TRAVELLING = re.compile(
    r"\b(?:went|walked|drove|rode|climbed|ran|hurried|marched|sailed|rowed|go|walk|drive|ride)s?\b"
)
_UNLOCKED = re.compile(r"\b(?:open|unlock|push)(?:ed|s)? (?:open )?the (?:\w+ )?door\b")
"""``I unlocked the door. The room was dark``."""
_A_PARAGRAPH = 500
"""Characters."""
_CLOCK = re.compile(
    r"(?:at|by|towards?|just before|just after) (?:about )?"
    rf"(?:(?:a )?(?:quarter|half|{_COUNT}) (?:past|to|before|after) )?(?:{_COUNT}|\d+)\b(?! \w+s\b)"
)
"""``At a quarter to twelve``."""
_AWHILE = re.compile(
    rf"(?:about |some |barely |not )?(?:{_COUNT}|half an|a few|several|many|\d+)"
    r" (?:minutes?|hours?|moments?) (?:later|after)"
)
_NEXT_DAY = re.compile(
    r"(?:early |late )?(?:in|on|by|at|with|towards?|the|next)\b[^,.;]*?"
    r"\b(?:next|following) (?:day|morning|evening|night|afternoon)\b|(?:early |late )?next (?:day|morning|evening)\b"
)
"""``In the pale sun next morning``: a scene of its own, where the last one was if it names no place."""
_OTHER_TIME = re.compile(r"(?:that|in the|by|towards?|at) (?:\w+ )?(?:morning|evening|night|noon|dawn|dusk|midnight)\b")
"""``In the morning there was an egg``: the same place, unless one is named."""


def read_scene_change(paragraph: Paragraph, scenes: list[SceneReading], title: str = "") -> SceneReading | None:
    """Return the scene that a paragraph opens, or None where the last one continues.

    Args:
        paragraph: A paragraph of prose; its first two sentences are searched.
        scenes: The scenes before.
        title: Of the story; may tell when it begins.
    """
    raw = _SENTENCE_END.split(without_quotations(paragraph.raw))
    told = [sentence.lower() for sentence in raw]
    if scenes:
        moved = _new_place_and_time(told, raw, scenes)
        if moved is None:
            return None
        place, time = moved
    else:
        whole = " ".join(told)
        place = (
            sentence_place(told[0])
            or opening_place(told[0])
            or sentence_place(whole)
            or first_place(whole)
            or sentence_place(whole, " ".join(raw))
        )
        place = room_within(place, told)
        time = story_time(told, title)
    scene_type = scene_type_of(place)
    return SceneReading(
        id=len(scenes) + 1,
        heading="",
        place=place,
        place_kind=lexicon.place_kind(place),
        scene_type=scene_type,
        time=time or default_time(scenes, place),
        time_written=time or "",
        weather=weather_of(told[0]),
        reference=same_place(place, scene_type, scenes),
        start=paragraph.start,
        end=paragraph.end,
    )


def _new_place_and_time(
    told: list[str], raw: list[str], scenes: list[SceneReading]
) -> tuple[str, TimeOfDay | None] | None:
    """Return where and when a paragraph takes the story, or None where it stays."""
    last = scenes[-1]
    opening = told[0]
    second = told[1] if len(told) > 1 else ""
    later = _is_time_jump(opening)
    arrival = _ARRIVAL.search(opening)
    place = ""
    if later or arrival or _PLACE_FIRST.match(opening):
        start = 0 if later or arrival is None else arrival.start()
        place = sentence_place(opening[start:], raw[0][start:], home=scenes[0].place)
        place = place or (sentence_place(second, raw[1], home=scenes[0].place) if later and second else "")
    place = place or destination(told) or (subject_place(opening, last.place) if not _just_came_in(last) else "")
    if not place and _is_time_jump(second):
        place = sentence_place(second, raw[1]) or first_place(opening)
    elif not place and _PLACE_FIRST.match(second) and not _YONDER.match(second):
        place = sentence_place(second)
        place = place if place in lexicon.PLACE_KINDS or (_TRAVELLING.search(opening) and place) else ""
    if not place and _UNLOCKED.search(opening) and second.startswith("the room "):
        place = "room"
    next_day = _NEXT_DAY.match(opening) is not None
    hour = time_in_text(opening) if later else None
    elapsed = hour is not None and hour != last.time and _OTHER_TIME.match(opening) is not None
    if not (next_day or elapsed) and place in ("", last.place):
        return None
    return place or last.place, time_in_text(opening)


def _just_came_in(last: SceneReading) -> bool:
    """Whether a story has only just come to an inn: the taproom told next is the same place."""
    return last.place in WHOLE and last.end - last.start < _A_PARAGRAPH


def _is_time_jump(sentence: str) -> bool:
    """Whether a sentence jumps in time."""
    return any(pattern.match(sentence) for pattern in (_TIME_JUMP, _NEXT_DAY, _CLOCK, _AWHILE))
