"""Chooses the set kit of a scene: as named, else by its heading, else by its contents, else a plain fallback."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from typing import NamedTuple

from storyblender.agents.director.kit_evidence import kit_of_things
from storyblender.agents.director.reading import SceneReading
from storyblender.catalog.inflection import noun_key
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.drawing import Period
from storyblender.catalog.sets.period import period_of
from storyblender.memory.vocabulary import Age, SceneType

FALLBACK: dict[SceneType, str] = {"indoor": "room", "outdoor": "open_ground"}

_VAGUE = frozenset(
    [
        "room", "house", "apartment", "flat", "home", "interior", "chamber", "city", "town", "downtown", "building",
        "outside", "exterior", "village", "hall", "school", "hospital", "hotel", "castle", "palace", "camp", "yard",
        "ship", "boat", "plane", "estate", "farm", "island", "university", "station", "road", "highway",
    ]
)  # fmt: skip
"""Words for what surrounds a place (house, city); a more specific word beside them wins."""

_OUTSIDE_OF = {
    "living_room": "suburb", "bedroom": "suburb", "kitchen": "back_yard", "cottage": "cottage_garden",
    "gallery": "square", "greenhouse": "park", "attic": "park", "tent": "campsite", "cave": "mountain",
    "courtroom": "square", "lighthouse": "beach", "church": "park", "great_hall": "castle_court", "library": "street",
    "cell": "street", "warehouse": "dock", "dining_room": "park", "workshop": "street", "barn": "farm_yard",
    "carriage": "street", "room": "suburb", "classroom": "school_yard", "interrogation": "alley",
    "waiting_room": "platform", "control_room": "space_hull", "tatami_room": "park", "nursery": "back_yard",
    "locker_room": "stadium", "motel_room": "parking_lot", "supermarket": "parking_lot",
}  # fmt: skip
"""Indoor kit -> the kit for EXT. of the same place; a street if it is not listed."""

_INSIDE_OF = {
    "street": "room", "alley": "warehouse", "forest": "cottage", "park": "living_room", "porch": "living_room",
    "cemetery": "church", "pool": "gym", "stadium": "gym", "balcony": "living_room", "trench": "tent", "square": "shop",
    "beach": "cottage", "dock": "warehouse", "airfield": "airport_gate", "rooftop": "room", "bridge": "control_room",
    "desert": "cottage", "mountain": "cave", "ship_deck": "carriage", "space_hull": "control_room",
    "platform": "subway", "open_ground": "cottage", "vineyard": "barn",
}  # fmt: skip
"""Outdoor kit -> the kit for INT. of the same place; a plain room if it is not listed."""

_OLDER_KITS: dict[Period, dict[str, str]] = {
    "past": {
        "trench": "open_ground", "apartment": "living_room", "motel_room": "bedroom", "hospital_room": "bedroom",
        "open_office": "office", "meeting_room": "dining_room", "coffee_shop": "cafe", "diner": "bar",
        "supermarket": "shop", "restaurant_kitchen": "kitchen", "nightclub": "ballroom", "garage": "stable",
        "parking_garage": "stable", "server_room": "archive", "caravan": "cottage", "gas_station": "stable",
        "parking_lot": "square", "highway": "country_road", "bus_stop": "country_road", "suburb": "village",
        "construction_site": "village", "playground": "park", "coach": "horse_carriage", "car": "horse_carriage",
        "housing_estate": "street", "phone_box": "closet",
    },
    "classic": {
        "apartment": "living_room", "open_office": "office", "coffee_shop": "cafe", "supermarket": "shop",
        "server_room": "archive",
    },
}  # fmt: skip
"""Kit of a place before its time, by period: knights meet on open ground, a flat of the forties is a living room."""

_SURE, _SUITS = 10.0, 30.0
"""Points of a particular word, and for suiting INT or EXT: that beats any phrase that does not. INT. CAR - PARKING LOT
is in the car."""

_HALL = frozenset(["hall", "great", "main", "central", "big", "large"])

_BESIDE = re.compile(r"(?<=\w)[\s,-]+(?:of|behind|near|beside|outside|opposite|next to|close to|on|by|above)\s+")
"""Words after which another place is named: the alley behind the market is an alley."""

_PARTS = re.compile(r",\s*|\s+[-–—]+\s+")
"""Between the parts of a heading: the last, MANOR, LIBRARY, is where we are."""


def choose_kit(scene: SceneReading, things: Iterable[str], contents: str, age: Age | None = None) -> str:
    """Return the key of a scene's kit; one that no person named is the kit that its place had in the story's age.

    Args:
        scene: The scene.
        things: Ids of the people and things that are there.
        contents: The place and what is in it, in words.
        age: Age of the story; None if its words do not tell it.
    """
    if scene.kit in SETS:
        return scene.kit
    kit = _kit_by_words(scene, things, contents)
    return _OLDER_KITS.get(period_of(SETS[kit], age), {}).get(kit, kit)


def _kit_by_words(scene: SceneReading, things: Iterable[str], contents: str) -> str:
    """Return the kit of a scene by its heading, its people and things, or the words for its contents."""
    fallback = FALLBACK[scene.scene_type]
    key = _hall_of(scene) or find_kit(scene.place_kind, scene.place, scene.scene_type)
    vague = bool(scene.place) and _VAGUE.issuperset(_tokens(scene.place))
    if not vague and (key != fallback or _names(scene.place, key)):
        return key
    kits = (kit.key for kit in SETS.values() if kit.indoor == (scene.scene_type == "indoor"))
    told = kit_of_things((*things, contents), kits)
    if told is not None or key != fallback:
        return told or key
    return find_kit(scene.place_kind, f"{contents} {scene.place}", scene.scene_type)


def _hall_of(scene: SceneReading) -> str | None:
    """Return the kit of the building whose hall it is: the great hall of a museum is no castle's."""
    building, *_, last = _PARTS.split(scene.place.strip()) if _PARTS.search(scene.place.strip()) else ("", "")
    if not _HALL.issuperset(_tokens(last) or ["-"]):
        return None
    key = find_kit("", building, scene.scene_type)
    return key if _names(building, key) and SETS[key].indoor == (scene.scene_type == "indoor") else None


def _names(words: str, key: str) -> bool:
    """Return whether a heading has a particular word for a kit: a prairie is open ground, and no mere fallback."""
    return any(_score(tag, _heading("", words)) >= _SURE for tag in SETS[key].tags if tag not in _VAGUE)


def names_a_kit(scene: SceneReading) -> bool:
    """Return whether the words of a place name a kit rather than falling back; ``ROOM`` names the plain room."""
    key = find_kit(scene.place_kind, scene.place, scene.scene_type)
    if key != FALLBACK[scene.scene_type] or _VAGUE.issuperset(_tokens(scene.place)):
        return True
    return _names(scene.place, key) or _names(scene.place_kind.replace("_", " "), key)


def find_kit(place_kind: str, words: str, scene_type: SceneType) -> str:
    """Return the key of the kit that fits a place best.

    Args:
        place_kind: The Director's key of the place, or empty; counts more than the heading's other words.
        words: The place as written, e.g. ``HOTEL - LOBBY``, or any description.
        scene_type: INT or EXT: an outdoor scene never gets a ceiling, an indoor one always does.
    """
    told = _heading(place_kind, words)
    found: dict[str, float] = {}
    said = {*told.kind[:1], *(token for tokens, _, _ in told.parts for token in tokens)}
    for key, tag in (tagged for word in said for tagged in _tags_by_first_word().get(word, ())):
        found[key] = max(found.get(key, 0.0), _score(tag, told))
    scores = {key: found[key] for key in SETS if found.get(key, 0.0) > 0}
    if not scores:
        return FALLBACK[scene_type]
    indoor = scene_type == "indoor"

    def suits(key: str) -> float:
        """Return a kit's score, raised where it is indoors or outdoors as wanted and lowered where it is not."""
        score = scores[key]
        return score / 3 if SETS[key].indoor != indoor else score + (_SUITS if score >= _SURE else 4.0)

    best = max(scores, key=suits)
    if SETS[best].indoor == indoor:
        return best
    return SETS[best].counterpart or (_INSIDE_OF.get(best, "room") if indoor else _OUTSIDE_OF.get(best, "street"))


class _Heading(NamedTuple):
    """A place in words: the Director's key of it, and each part of the words with its last piece and its weight."""

    kind: list[str]
    parts: tuple[tuple[list[str], list[str], float], ...]


def _heading(place_kind: str, words: str) -> _Heading:
    """Return a place in words with its parts: what comes after ``behind``, ``near`` and the like counts half."""
    head, *owners = _BESIDE.split(words.lower(), maxsplit=1)
    parts = ((head, 1.0), *((owner, 0.5) for owner in owners))
    told = tuple((_tokens(text), _tokens(_PARTS.split(text.strip())[-1]), share) for text, share in parts)
    return _Heading(_tokens(place_kind.replace("_", " ")), told)


def _score(tag: str, heading: _Heading) -> float:
    """Return how strongly a tag is meant: longer phrases, particular words, and the last word named count most."""
    phrase = _phrase(tag)
    weight = 10.0 * len(phrase) - (6.0 if len(phrase) == 1 and phrase[0] in _VAGUE else 0.0)
    score = weight + 6.0 if heading.kind == phrase else 0.0
    for tokens, last, share in heading.parts:
        if phrase in (tokens, last) and share == 1.0:  # the heading, or its last part, says this and nothing else
            score = max(score, weight + 12.0)
        if phrase[:1] and phrase[0] not in tokens:
            continue
        for start in range(len(tokens) - len(phrase) + 1):
            if tokens[start : start + len(phrase)] == phrase:
                score = max(score, share * weight + (start + len(phrase)) / (1 + len(tokens)))
    return score


@cache
def _tags_by_first_word() -> dict[str, list[tuple[str, str]]]:
    """Return the first word of each tag -> kits and their tags that begin with it."""
    found: dict[str, list[tuple[str, str]]] = {}
    for kit in SETS.values():
        for tag in (kit.key.replace("_", " "), *kit.tags):
            for word in _phrase(tag)[:1]:
                found.setdefault(word, []).append((kit.key, tag))
    return found


@cache
def _phrase(tag: str) -> list[str]:
    """Return the words of a kit's tag."""
    return _tokens(tag)


def _tokens(text: str) -> list[str]:
    """Return the words of a text in lower case, in the singular, without ``'s``."""
    words = re.findall(r"[a-zà-ÿ]+", re.sub(r"['’]s?\b", "", text.lower()))
    return [noun_key(word) for word in words]
