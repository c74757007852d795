"""More names for one of a screenplay's cast: nicknames, name tags, clothes, and names revealed after the first view."""

from __future__ import annotations

import re
from collections.abc import Collection

from storyblender.agents.director.naming import UPPER
from storyblender.agents.director.reader.cast.later_names import merge_people
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_NICKNAMED = re.compile(
    rf"(?<![{UPPER}])(?P<first>[{UPPER}]{{2,}}(?: [{UPPER}]{{2,}})?) "
    rf"[\"“'‘(](?P<nick>[{UPPER}][\w'’]*(?: [{UPPER}]\w+)?)[\"”'’)] "
    rf"(?P<last>[{UPPER}][{UPPER}'’-]+)"
)
_TAGGED = re.compile(
    rf"\b(?:tag|badge|named|name|aka|called|says|reads)\b\W+(?:that )?(?:\w+ )??[\"“'‘]?([{UPPER}]{{2,}})\b"
)

_ALSO = re.compile(
    r"\b(?:[Kk]nown (?:to \w+ )?as|[Nn]icknamed|[Cc]alled|[Aa][Kk][Aa]|[Rr]eal name) "
    rf"[\"“'‘]?([{UPPER}][\w'’-]*)"
)


def bracketed_alias(look: str) -> str:
    """Return another name told in brackets, ``(48, known as DEN, the coach)``, or an empty string."""
    also = _ALSO.search(look)
    return also.group(1) if also else ""


def find_nicknames(text: str) -> list[tuple[int, int, str, str]]:
    """Find ``BEATRIZ "BEA" LUNA``: start, end, whole name and nickname of each."""
    return [
        (match.start(), match.end(), f"{match.group('first')} {match.group('last')}", match.group("nick"))
        for match in _NICKNAMED.finditer(text)
    ]


def person_in_clothes(roster: Roster, name: str) -> Person | None:
    """Return the person whose clothes are the name: ``GREY SUIT`` is the MAN IN A GREY SUIT.

    Args:
        roster: The cast.
        name: The name.
    """
    return next(iter(roster.wearing(bare(name))), None)


def name_on_tag(look: str, names: Collection[str]) -> str:
    """Return the name on a tag in brackets, ``(40s, name tag: MARGE)``, if the script has it; else an empty string.

    Args:
        look: The words in brackets.
        names: Names of the script.
    """
    tag = _TAGGED.search(look)
    return tag.group(1) if tag and tag.group(1) in names else ""


_NOBODY_YET = "figure|stranger|silhouette|shape|shadow|man|woman|boy|girl|rider|driver|voice|intruder"
_REVEALING = re.compile(
    rf"\b(?i:the|a) (?P<who>(?i:{_NOBODY_YET}))\b"
    r"[^.!?]{0,80}?\b(?i:reveal(?:s|ed|ing)?|turns out to be|it is|it['’]s)\W+"
    rf"(?P<name>[{UPPER}][{UPPER}' -]+[{UPPER}])\b"
)


@rule("people.revealed")
def join_revealed(roster: Roster, text: str) -> None:
    """Merge a figure with the named person it turns out to be: ``A figure steps out, revealing -- MARCUS``.

    Args:
        roster: The cast of a screenplay.
        text: The script.
    """
    for match in _REVEALING.finditer(text):
        shown, known = roster.find(match.group("who")), roster.find(match.group("name").strip())
        if shown and known and shown[0] is not known[0] and shown[0].role and shown[0].first < known[0].first:
            merge_people(roster, known[0], shown[0])
