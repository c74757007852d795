"""People who are seen before they are named: ``A figure steps into the light, revealing -- MARCUS``."""

from __future__ import annotations

import re

from storyblender.agents.director.naming import UPPER
from storyblender.agents.director.reader.cast.later_names import join
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.rules import rule

_NOBODY_YET = "figure|stranger|silhouette|shape|shadow|man|woman|boy|girl|rider|driver|voice|intruder"
_REVEALING = re.compile(
    rf"\b(?i:the|a) (?P<who>(?i:{_NOBODY_YET}))\b"
    r"[^.!?]{0,80}?\b(?i:reveal(?:s|ed|ing)?|turns out to be|it is|it['’]s)\W+"
    rf"(?P<name>[{UPPER}][{UPPER}' -]+[{UPPER}])\b"
)


@rule("people.revealed")
def join_revealed(roster: Roster, text: str) -> None:
    """Merge a figure with the named person it turns out to be.

    Args:
        roster: The cast of a screenplay.
        text: The script.
    """
    for match in _REVEALING.finditer(text):
        shown, known = roster.find(match.group("who")), roster.find(match.group("name").strip())
        if shown and known and shown[0] is not known[0] and shown[0].role and shown[0].first < known[0].first:
            join(roster, known[0], shown[0])
