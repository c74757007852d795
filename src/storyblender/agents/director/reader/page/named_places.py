"""Places named without a scene heading: ``Inside, the lamp room.``, and in capitals inside a scene: ``AT THE DOOR``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.camera_phrases import without_direction
from storyblender.agents.director.reader.language.morphology import FORMS
from storyblender.agents.director.reader.page.hours import heading_time, is_time
from storyblender.agents.director.reader.page.prose_places import place_head, scene_type_of
from storyblender.agents.director.reading import SceneReading
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import noun_key
from storyblender.catalog.sets import SETS
from storyblender.memory.vocabulary import SceneType, TimeOfDay
from storyblender.screenplay.headings import LEADING_WORDS, heading_words, is_heading

_SENTENCE = re.compile(r"(?<=[.!?:])(?<!Mr\.)(?<!Dr\.)(?<!Mrs\.)(?<!St\.)\s+|\n")
_LEAD = re.compile(
    r"(?:(?:back|out|up|down|over|meanwhile|later|now|and|then|far|deep|high|way|elsewhere|still|again|we(?:'re| are)"
    r"|cut to|moments later"
    r"|minutes later|hours later)[,:]?\s+)*(?:(?:inside|outside|in|at|on|among|along|under|aboard|above|below|near"
    r"|behind|by|across|through"
    r"|beside|beneath|to|into|onto|within|from)\s+)*(?:(?:the|a|an|his|her|their|our|my|its|this|that|another|same|some)\s+)*"
)
_OWNER = re.compile(r"^[\w-]+(?:\s[\w-]+)?['’]s?\s+")
_SIDE = re.compile(r"(?:back |now |meanwhile,? )*(inside|outside|indoors|outdoors)\b(?=[.,:;]|$)")
_SOMEWHERE = re.compile(
    r"\b(?:in|on|at|inside|outside|aboard|along|beside|by|under|through)\s+(?:the|a|an|his|her|their|its|our)\s+((?:[a-z'-]+\s+){0,2}?[a-z'-]+)(?=[,.;:]|$|\s(?:with"
    r"|and|at|in|on|of|as|while|is|are|\w+ing|\w+s)\b)"
)
_FURTHEST = 3
"""Sentences at the start of a paragraph that may name its place."""
_MOST_WORDS = 7
"""Most words of a phrase that names a place."""
_NO_PLACES = lexicon.words("seldom_place")
"""Place words with other common meanings: without a determiner or preposition they name no place."""


class NamedPlace(NamedTuple):
    """A place named by the text."""

    place: str
    """Name of the place; empty if only inside or outside, or the time of day, is given."""
    scene_type: SceneType | None
    time: TimeOfDay | None


def place_without_verb(text: str, *, pictured: bool = False) -> NamedPlace | None:
    """Return the place that the first sentences of a paragraph name without a verb, or None.

    Args:
        text: The paragraph as written; a camera direction before the place is skipped.
        pictured: The text describes one picture: ``Otto on the pier`` names the pier as well.
    """
    time: TimeOfDay | None = None
    found: NamedPlace | None = None
    for number, sentence in enumerate(_SENTENCE.split(text.strip())[:_FURTHEST]):
        directed = without_direction(sentence)
        words = directed.strip(" .:!?—–-…\"'()[]")
        first = re.split(r"[,;]", words)[0].strip()
        if is_time(first) and len(first.split()) <= 4:
            time = time or heading_time(first)
            continue
        if not words or found:
            continue
        found = _in_fragment(words)
        if found is None and pictured and number == 0:
            found = _in_picture(words, directed=directed != sentence)
        if found is None and (number or _has_verb(words.lower())):
            break
    if found:
        return found._replace(time=found.time or time)
    return NamedPlace("", None, time) if time else None


def _in_picture(words: str, *, directed: bool) -> NamedPlace | None:
    """Return the place of a described picture: ``Otto on the pier``, ``Wide. The whole street dark``; else None."""
    low = words.lower().replace("’", "'")
    places = [_kind_at_end(match[1].split()) for match in _SOMEWHERE.finditer(low)]
    place = next((place for place in places if place and place not in _NO_PLACES), "")
    if not place and directed and not _has_verb(low):
        lead = _LEAD.match(low)
        place = place_head((low[lead.end() :] if lead else low).split()[:4])
    return NamedPlace(place, type_of_place(place), None) if place else None


def _in_fragment(words: str) -> NamedPlace | None:
    """Return the place that a fragment names, or None."""
    if is_heading(words):
        return _place_from_heading(words)
    low = words.lower().replace("’", "'")
    side = _SIDE.match(low)
    kind: SceneType | None = None
    if side:
        kind = "indoor" if side[1].startswith("in") else "outdoor"
        low = low[side.end() :].strip(" ,.:;")
    segments = [segment.strip() for segment in re.split(r"[,;]|\s[-–—]+\s|\.\s", low) if segment.strip()]
    hours: list[TimeOfDay | None] = [heading_time(segment) for segment in segments if is_time(segment)]
    hour = hours[0] if hours else None
    verbless = not _has_verb(low)
    for index, segment in enumerate(segments):
        if index and not verbless:
            break
        place = _place_in_phrase(segment, alone=index == 0)
        if place:
            return NamedPlace(place, kind or type_of_place(place), hour)
    return NamedPlace("", kind, hour) if side else None


def _place_from_heading(words: str) -> NamedPlace:
    """Return the place of words in the form of a heading."""
    parts = heading_words(words)
    time = heading_time(words)
    place = re.split(r"\s+[-–—]+\s+|,\s*", parts.place.lower())[0].strip(" .")
    return NamedPlace(place, "outdoor" if parts.side == "outside" else "indoor", time)


def _place_in_phrase(segment: str, *, alone: bool) -> str:
    """Return the place that a phrase names: ``inside the old lamp room`` -> lamp room; empty if none."""
    lead = _LEAD.match(segment)
    rest = segment[lead.end() :] if lead else segment
    led = bool(lead and lead[0].strip())
    owner = _OWNER.match(rest)
    owned = owner[0] if owner else ""
    rest = rest[len(owned) :]
    words = rest.split()
    if not words or len(words) > _MOST_WORDS or _has_verb(" ".join(words[:-1])):
        return ""
    for stop, word in enumerate(words):
        if word in ("of", "at", "in", "with", "on", "near", "under", "behind", "by", "as", "outside", "inside", "and"):
            before, after = words[:stop], words[stop + 1 :]
            place = _kind_at_end(before)
            if word == "of" and not place:
                return _place_in_phrase(" ".join(after), alone=False)
            return owned + place if place else ""
    place = _kind_at_end(words)
    if not place or (place in _NO_PLACES and not (led or owned)):
        return ""
    return f"{owned}{place}" if alone or led or owned or len(words) <= 4 else ""


def _kind_at_end(words: list[str]) -> str:
    """Return the place at the end of a list of words; two words if they are one kind of place."""
    if not words:
        return ""
    pair = " ".join(words[-2:])
    if len(words) > 1 and (pair in place_words() or pair in lexicon.PLACE_KINDS):
        return pair
    last = words[-1]
    single = last if last in lexicon.PLACES else noun_key(last)
    if last in lexicon.PLACES or single in lexicon.PLACES or last in place_words() or single in place_words():
        return place_head(words) or last
    return ""


def type_of_place(place: str, otherwise: SceneType = "outdoor") -> SceneType:
    """Return whether a place is indoors, by the lists of places, else by the kit that it names.

    Args:
        place: The place as written.
        otherwise: What it is where neither tells.
    """
    head = place.rpartition(" ")[2]
    if head in lexicon.PLACES:
        return scene_type_of(place)
    indoor = place_words().get(place, place_words().get(head))
    return otherwise if indoor is None else "indoor" if indoor else "outdoor"


@cache
def place_words() -> dict[str, bool]:
    """Return each word or phrase that means a set kit, with whether the kit is indoors."""
    found: dict[str, bool] = {}
    for kit in SETS.values():
        for tag in (kit.key.replace("_", " "), *kit.tags):
            if noun_may_be_place(tag):
                found.setdefault(tag, kit.indoor)
    return found


def noun_may_be_place(tag: str) -> bool:
    """Whether a word of a kit names a place, and no furniture, trade or quality."""
    others = lexicon.PROPS | lexicon.SET_PIECES | lexicon.WORN | lexicon.ADJECTIVES | lexicon.ABSTRACT
    return " " in tag or tag not in others


def _has_verb(low: str) -> bool:
    """Whether a phrase in lower case has a verb."""
    words = re.findall(r"[a-z']+", low)
    for before, word in zip(["", *words], words, strict=False):
        form = FORMS.get(word)
        if word in ("is", "are", "was", "were", "has", "have", "had", "isn't", "it's", "he's", "she's", "there's"):
            return True
        if form is None or form.kind not in ("3sg", "past", "aux") or before in lexicon.DETERMINERS:
            continue
        if (
            word not in place_words()
            and noun_key(word) not in lexicon.PLACES
            and lexicon.noun_class(noun_key(word)) == "unknown"
        ):
            return True
    return False


_SLUG = re.compile(
    r"(?:BACK |LATER,? |MEANWHILE,? )?(?:(?:IN(?:SIDE)?|AT|ON|TO|OUTSIDE|UNDER|BEHIND|NEAR|BY|ACROSS"
    r"|ABOARD) )*(?:THE |A |HIS |HER |THEIR )?"
    r"(?P<place>[A-ZÀ-Þ][A-ZÀ-Þ0-9'’&]*(?: [A-ZÀ-Þ0-9'’&]+){0,4})(?P<time>\s*[-–—,]+\s*[A-ZÀ-Þ ]+)?\s*(?P<mark>:"
    r"|\.?\s*(?:\n|$))"
)
_HEAD = re.compile(r"(?:BACK |LATER|MEANWHILE)?(?:IN|INSIDE|AT|ON|TO|OUTSIDE|UNDER|BEHIND|NEAR|BY|ACROSS|ABOARD)\b")
_SMALL = frozenset({"the", "a", "of", "in", "at"})


@rule("place.slug")
def place_in_capitals(text: str, scenes: Sequence[SceneReading]) -> NamedPlace | None:
    """Return the place in capitals that a paragraph begins with (``AT THE DOOR``), or None.

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
    told = place_without_verb(beside) if beside and time is None else None
    if told and told.place:
        return told._replace(scene_type=type_of_place(told.place, scenes[-1].scene_type if scenes else "outdoor"))
    been = last_scene_with_words(place, scenes)
    if been:
        return NamedPlace(been.place, been.scene_type, time)
    if not _HEAD.match(text) and not (match["time"] or match["mark"] == ":"):
        return None
    told = place_without_verb(match[0].strip(" :.\n").lower())
    return NamedPlace(told.place, type_of_place(told.place), time) if told and told.place else None


def last_scene_with_words(words: str, scenes: Sequence[SceneReading]) -> SceneReading | None:
    """Return the last of ``scenes`` whose place contains all of ``words``, or None."""
    wanted = frozenset(re.findall(r"[^\W_]+", words.lower())) - _SMALL
    if not wanted:
        return None
    found = (scene for scene in reversed(scenes[-100:]) if wanted <= frozenset(re.findall(r"[^\W_]+", scene.place)))
    return next(found, None)
