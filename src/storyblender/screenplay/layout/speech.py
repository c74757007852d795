"""A speech on the page: its words, and the brackets between them."""

from __future__ import annotations

import re

from storyblender.screenplay.layout.lines import Page

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
