"""How full of background people a place is, from the words of its scene: a crowded café, a packed bar, an audience."""

from __future__ import annotations

import re
from functools import cache
from typing import Final

from storyblender.catalog.sets import SETS
from storyblender.memory.vocabulary import Crowd

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


def crowd_in(place: str, words: str, before: Crowd | None = None) -> Crowd | None:
    """Return how full of background people a place is; it stays as full as it was unless its words tell otherwise.

    Args:
        place: The place as written.
        words: The action of the scene, without its dialogue.
        before: How full it was when it was last seen.
    """
    told = f"{place}. {words}".lower()
    if re.search(_MANY, told) or re.search(_FULL_ALONE, told) or _place_pattern(_FULL).search(told):
        return "full"
    if _place_pattern("busy|lively|bustling|crowded").search(told):
        return "busy"
    return None if re.search(_EMPTY, words.lower()) else before


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
