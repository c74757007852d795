"""Finds the years a text is set in: ``Paris, 1789`` and ``in 1942``, but not ``Room 1408`` or ``1500 men``."""

from __future__ import annotations

import re

_YEAR = r"(?P<year>1\d{3}|20\d{2})"
_MONTH = (
    r"(?:jan(?:uary)?|feb(?:ruary)?|mar(?:ch)?|apr(?:il)?|may|june?|july?|aug(?:ust)?|sept?(?:ember)?|oct(?:ober)?"
    r"|nov(?:ember)?|dec(?:ember)?)\.?(?: \d{1,2}(?:st|nd|rd|th)?)?,?"
)
_SEASON = r"(?:spring|summer|autumn|fall|winter|christmas|easter|eve|dawn)(?: of| in)?"
_BEFORE = rf"(?:in|since|circa|early|late|mid|until|till|the year(?: is| was)?|{_MONTH}|{_SEASON}|it(?: is| was|['’]s))"
_NEXT = r"(?:the|an?|and|but|or|when|where|while|as|at|on|in|to|by|he|she|they|we|it|is|was|were|had|his|her|their)\b"
_TOLD = re.compile(
    rf"\b{_BEFORE}\s+{_YEAR}\b(?!['’]?s\b)(?=\W*$|\s*[^\w\s]|\s+{_NEXT}|\s+(?-i:[A-Z])|\n)"  # in 1942 the ...
    rf"|\b(?P<decade>1\d\d0|20\d0)['’]?s\b"
    rf"|(?:(?<=[^\W\d_]{{2}}[,.:])\s*|[(\[]|\s[-–—]+\s*){_YEAR.replace('year', 'placed')}"
    r"(?=\s*(?:$|\n|[.!?)\]\"”’]|[-–—]))"  # PARIS, 1789. (1931)
    rf"|(?:^|[\n\"“‘(]|[.!?]\s){_YEAR.replace('year', 'alone')}(?=\s*(?:$|\n|[.!?\"”’)]))"
    rf"|\b{_YEAR.replace('year', 'era')}\s*(?:A\.?D\b|C\.?E\b)|\bA\.?D\.?\s*{_YEAR.replace('year', 'counted')}\b",
    re.IGNORECASE,
)
_NOW = re.compile(
    rf"\b(?:it(?: is|['’]s)|this is|(?:the )?year is|here in|now,? in)\s+{_YEAR}\b(?=\s*(?:$|[.,;!?]))", re.IGNORECASE
)

_SHOWN = re.compile(
    r"\b(?:photo(?:graph)?|picture|portrait|plaque|headstone|gravestone|tombstone|engraved|label|medal|trophy|vintage)s?\b",
    re.IGNORECASE,
)
"""Things that show a year other than the story's, such as a gravestone."""
_NEAR = 80
"""A year is skipped if such a thing is named within this many characters before it."""


def years_in(words: str) -> list[int]:
    """Return the years that a text sets its story in, in order; a decade counts as its first year.

    Args:
        words: Text of a script, with headings and title cards.
    """
    told = (
        match
        for match in _TOLD.finditer(words)
        if not _SHOWN.search(words[max(0, match.start() - _NEAR) : match.start()])
    )
    return [int(next(filter(None, match.groups()))) for match in told]


def years_said(words: str) -> list[int]:
    """Return the years that dialogue says it is now: ``It's 1942``, but not ``since 1492``.

    Args:
        words: A speech.
    """
    return [int(match["year"]) for match in _NOW.finditer(words)]
