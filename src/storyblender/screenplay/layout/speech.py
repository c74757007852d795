"""Speeches on a page: cue names on lines of their own, the words, and the brackets between them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from storyblender.screenplay.cues import looks_like_cue, split_cue
from storyblender.screenplay.layout.labels import element_of_label
from storyblender.screenplay.layout.lines import Line, Page, plain
from storyblender.screenplay.line_kinds import kind_of_words

_BRACKET = re.compile(r"[_*\\]*(?:\((?P<round>[^()]{1,600}?)\\?\)|\[(?P<square>[^\[\]]{1,600})\])[_*]*", re.DOTALL)
_OFF = re.compile(
    r"(?:V\.?\s?O|O\.?\s?S|O\.?\s?C|OFF|VOICE[ -]?OVER|FILTERED|ON (?:THE )?(?:PHONE|RADIO|TV|SCREEN|TELEPHONE"
    r"|LAPTOP)|CONT['’]?D|OFFSTAGE|OFF[ -]STAGE"
    r"|OFF[ -]SCREEN|WITHIN|PRE-?LAP|OFF PANEL|OP|FROM OFF|AUS DEM OFF|EN OFF|FUERA DE CAMPO|HORS CHAMP|HC|VOZ EN OFF"
    r"|VOIX OFF)\b\.?",
    re.IGNORECASE,
)
_ACTED = 8
"""Number of words from which a bracket is a direction of its own."""


def is_extension(words: str) -> bool:
    """Return whether a bracket gives the source of a voice: ``V.O.``, ``off``, ``on the phone``."""
    return _OFF.match(words.strip()) is not None


def add_cue(page: Page, start: int, end: int, name: str, bracket: str) -> None:
    """Add a cue; a bracket after the name is the source of the voice, or the manner of speaking.

    Args:
        page: Takes the elements.
        start: Offset of the name.
        end: Offset after the name, or after its bracket.
        name: The name alone.
        bracket: Text of the bracket after it, or empty.
    """
    spoken_off = bool(bracket) and is_extension(bracket)
    at = page.text.find(bracket, start, end) if bracket and not spoken_off else -1
    cue_end = at - 1 if at > 0 else end
    shouting = name.upper() if name.isupper() or name.islower() else name
    page.add("cue", start, cue_end, name=shouting.upper(), extension=bracket.upper() if spoken_off else "")
    if at > 0:
        page.add("parenthetical", at - 1, end)


def add_speech(page: Page, start: int, end: int) -> None:
    """Add the words of a speech; a bracket before words is a parenthetical, a long or final one is action.

    Args:
        page: Takes the elements.
        start: Offset of the speech.
        end: Offset after its last word.
    """
    at = start
    for match in _BRACKET.finditer(page.text, start, end):
        page.add("dialogue", at, match.start())
        at = match.end()
        inside = match["round"] or match["square"] or ""
        group = "round" if match["round"] else "square"
        if is_extension(inside) or not re.search(r"\w", inside):
            continue
        goes_on = re.search(r"\w", page.text[at:end]) is not None
        if goes_on and len(inside.split()) < _ACTED and "\n\n" not in inside:
            page.add("parenthetical", match.start(), match.end())
        else:
            page.add("action", match.start(group), match.end(group))
    page.add("dialogue", at, end)


_BROKEN = 2
"""Number of cues in places Fountain does not accept from which a page has a layout of its own."""
_SHARE = 0.25
"""Least share of those among all names on lines of their own."""


def standing_names(lines: Sequence[Line]) -> frozenset[str]:
    """Return the names in capitals that stand alone on two or more lines."""
    counts = Counter(name for line in lines if (name := standing_name(line)))
    return frozenset(name for name, count in counts.items() if count > 1)


def standing_name(line: Line) -> str:
    """Return the name that a line consists of, without its brackets; empty if it is something else."""
    words = line.words
    if not words or len(words) > 50 or not looks_like_cue(words) or kind_of_words(words) or element_of_label(words):
        return ""
    return plain(split_cue(words)[0])


def is_out_of_place(lines: Sequence[Line]) -> bool:
    """Return whether many cues lack the blank line above, or have one below, so that Fountain misses them."""
    names = standing_names(lines)
    padded = [Line(0, 0, "", 0), *lines, Line(0, 0, "", 0)]
    found = [i for i in range(1, len(padded) - 1) if standing_name(padded[i]) in names and padded[i].words]
    broken = sum(bool(padded[i - 1].words) or not padded[i + 1].words for i in found)
    return broken >= _BROKEN and broken >= _SHARE * len(found)


def goes_on_as_action(line: Line, before: Line, names: frozenset[str]) -> bool:
    """Return whether a line under a speech is action: it begins with a character's name, after a full stop.

    Args:
        line: The line.
        before: The line above it.
        names: Names of the characters, in capitals.
    """
    if not re.search(r"[.!?…][\"”')]*$", before.words):
        return False
    first = re.match(r"(?:(?:Mr|Mrs|Ms|Dr)\.? )?([^\W\d_][\w'’-]+)(?=\s+[a-z])", line.words)
    return first is not None and any(first[1].upper() in name.split() for name in names) and not first[1].isupper()
