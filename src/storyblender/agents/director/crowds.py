"""How many background people a scene has, from its words: a crowded café, a packed bar, an audience."""

from __future__ import annotations

import re
from functools import cache
from typing import Final

from storyblender.catalog.sets import SETS

_FULL: Final = "crowded|packed|jam[- ]?packed|bustling|teeming|heaving|thronged|rammed|swarming|overflowing|jostling"
_FULL_ALONE: Final = (
    rf"(?:^|[.!?]\s+|,\s*)(?:it(?:['’]s| is) )?(?:{_FULL}|standing room only|full house)\s*(?:$|[.!?,;])"
)
_NOUNS: Final = (
    r"audiences?|crowds?|throngs?|mobs?|congregation|spectators|onlookers|passers-by|pedestrians|commuters|shoppers"
    r"|diners|guests|patrons|customers|dancers|worshippers|revellers|partygoers|travell?ers|passengers|tourists|gamblers"
    r"|drinkers|regulars|extras"
)
_MANY: Final = (
    rf"(?:full|packed|crowded|filled|crammed|swarming|teeming|alive) (?:of|with) (?:\w+ ){{0,2}}(?:people|{_NOUNS})"
    rf"|(?:a )?(?:sea|crush|press|crowd) of (?:people|faces|bodies|{_NOUNS})"
    rf"|(?:{_NOUNS}) (?:fill|crowd|pack|throng|jam|line|mill|bustle|jostle|applaud|cheer|roar|chatter)s?\b"
    r"|(?:hundreds|dozens|scores) of (?:people|men|women|faces)"
    r"|the (?:audience|crowd|congregation)\b"
)
_EMPTY: Final = r"\b(?:empty|deserted|abandoned|closed|shut up|vacant|nobody (?:else )?(?:is )?(?:here|there|about))\b"
_BUSY_SIZE, _FULL_SIZE = 12, 16
_LARGE_AREA, _LARGE_EXTRA = 80.0, 8
"""Square metres above which a place holds more people, and how many more."""


def background_crowd_size(place: str, words: str, area: float) -> int:
    """Return the number of background people in a scene; 0 where its words tell of none.

    Args:
        place: The place as written.
        words: The action of the scene, without its dialogue.
        area: Floor of the place in square metres.
    """
    told = f"{place}. {words}".lower()
    if re.search(_MANY, told) or re.search(_FULL_ALONE, told) or _place_pattern(_FULL).search(told):
        most = _FULL_SIZE
    elif _place_pattern("busy|lively|bustling|crowded").search(told):
        most = _BUSY_SIZE
    else:
        return 0
    return most + (_LARGE_EXTRA if area > _LARGE_AREA else 0)


def is_crowd_gone(words: str) -> bool:
    """Whether the words of a scene say that its place is empty."""
    return re.search(_EMPTY, words.lower()) is not None


@cache
def _place_pattern(adjectives: str) -> re.Pattern[str]:
    """Return the pattern of a place with one of these adjectives: ``a packed bar``, ``the bar is packed``."""
    nouns = {tag.split()[-1].lower() for kit in SETS.values() for tag in (*kit.tags, kit.name)} | {
        "place",
        "room",
        "house",
    }
    places = "|".join(sorted(map(re.escape, nouns), key=len, reverse=True))
    return re.compile(
        rf"\b(?:{adjectives})\s+(?:[\w'’-]+\s+){{0,2}}?(?:{places})s?\b"
        rf"|\b(?:{places})\s+(?:is|was|are|['’]s)\s+(?:\w+ )?(?:{adjectives})\b"
    )
