"""Parses the start of a scene heading, in five languages: inside or outside, and a scene number."""

from __future__ import annotations

import re
from typing import Literal, NamedTuple

Side = Literal["inside", "outside", "inside, outside", "outside, inside", ""]

_INSIDE = r"INT(?:ERIOR|[EÉ]RIEUR|ERNO)?|INNEN"
_OUTSIDE = r"EXT(?:ERIOR|[EÉ]RIEUR)?|ESTERNO|EST|AU(?:SS|ß)EN"
_SIDES = rf"(?:(?:{_INSIDE}|{_OUTSIDE})(?:\.?\s*/\s*(?:{_INSIDE}|{_OUTSIDE}))?|I/E|E/I)(?![^\W\d_])"
_PREFIX = re.compile(rf"(?P<side>{_SIDES})(?P<mark>\s*[.:]|\s*[-–—](?=\s)|(?=\s|$))\s*", re.IGNORECASE)
_NUMBER = re.compile(
    rf"\(?(?P<number>[A-Z]{{0,2}}\d{{1,4}}(?:/\d{{1,3}})?[A-Z]{{0,2}})[.):]?\s*[-–—]?\s+(?={_SIDES})", re.IGNORECASE
)
"""Scene number before the heading, and usually once more after it, as in shooting scripts."""
_WORDED = (
    r"ONE|TWO|THREE|FOUR|FIVE|SIX|SEVEN|EIGHT|NINE|TEN|ELEVEN|TWELVE|FIRST|SECOND|THIRD|FOURTH|LAST|FINAL|[IVX]{1,5}"
    r"|\d{1,4}[A-Z]{0,2}"
)
_LABEL = re.compile(
    rf"(?:SCENE|SC|SZENE|ESCENA|SC[ÈE]NE|SCENA|BILD|S[ÉE]QUENCE|SECUENCIA|SEQ|SEC|CARD|TABLEAU)\b\.?\s*"
    rf"(?P<number>{_WORDED})(?![^\W_])\s*(?P<length>[(\[][^)\]]{{1,40}}[)\]])?\s*[.:)–—-]*\s*",
    re.IGNORECASE,
)
"""``Scene 2:``, ``Sc. 3 (15 sec)``, ``Szene 4 -``."""
_NAMED = re.compile(
    r"(?:THE )?(?:SETTING|SET|SCENE|PLACE|LOCATION|ORT|LUGAR|LIEU|LUOGO)\s*(?:[:=]|\.\s?[-–—]|\s[-–—]+\s)\s*",
    re.IGNORECASE,
)
"""``Setting: a mill``, ``SCENE.--The drawing-room``: the label of a place."""
LEADING_WORDS = re.compile(
    r"(?:BEGIN |START )?(?:FLASH[ -]?(?:BACK|FORWARD)|DREAM|FANTASY|MEMORY|MONTAGE|INTERCUT)(?: SEQUENCE)?"
    rf"(?: TO)?\s*[-–—:.]+\s*(?={_SIDES})"
)
"""Words that may precede ``INT.`` and are part of the heading."""


class HeadingWords(NamedTuple):
    """The parts of a heading that its form alone determines."""

    side: Side
    number: str
    place: str
    """The rest: place and time as written."""


def is_heading(line: str) -> bool:
    """Return whether a line reads as a scene heading; without a mark after INT it must be in capitals."""
    number = _NUMBER.match(line)
    line = LEADING_WORDS.sub("", line[number.end() :] if number else line)
    labelled = _LABEL.match(line)
    match = _PREFIX.match(line, labelled.end() if labelled else 0)
    if match is None or len(line) <= match.end():
        return False
    if match["mark"].strip() in (".", ":"):
        return True
    return line == line.upper() or (match["side"].isupper() and bool(match["mark"].strip()))


def is_side_alone(line: str) -> bool:
    """Return whether a line is nothing but ``INT.``; the place then stands on the next."""
    match = _PREFIX.fullmatch(line.strip())
    return match is not None and (match["side"].isupper() or bool(match["mark"].strip()))


def scene_label(line: str) -> re.Match[str] | None:
    """Match ``Scene 2:`` or ``Sc. 3 (15 sec)`` at the start of a line."""
    return _LABEL.match(line)


def place_label(line: str) -> re.Match[str] | None:
    """Match ``Setting:`` or ``SCENE.--`` at the start of a line."""
    return _NAMED.match(line)


def split_number(heading: str) -> tuple[str, int]:
    """Return the number before ``INT`` and the offset after it; empty and 0 if there is none."""
    match = _NUMBER.match(heading)
    return (match["number"], match.end()) if match else ("", 0)


def heading_words(heading: str) -> HeadingWords:
    """Split a heading into inside or outside, its number, and the place and time as written."""
    rest = heading.strip()
    number, at = split_number(rest)
    rest = LEADING_WORDS.sub("", rest[at:])
    labelled = _LABEL.match(rest)
    if labelled:
        number, rest = number or labelled["number"], rest[labelled.end() :]
    named = _NAMED.match(rest)
    rest = rest[named.end() :] if named else rest
    match = _PREFIX.match(rest)
    if match is None:
        return HeadingWords("", number, rest.strip())
    return HeadingWords(_side(match["side"]), number, rest[match.end() :].strip())


def _side(words: str) -> Side:
    """Return whether the first words of a heading are inside, outside, both or neither."""
    first, _, second = words.upper().replace("ß", "SS").partition("/")
    begins: Side = "inside" if re.match(rf"{_INSIDE}|I$", first.strip()) else "outside"
    if not second:
        return begins
    return "inside, outside" if begins == "inside" else "outside, inside"
