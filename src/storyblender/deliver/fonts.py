"""Noto Sans, the font of boards and slates, and which characters it has."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from pathlib import Path

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont

REGULAR = "NotoSans"


def font_file() -> Path:
    """Return the path of the text font, for pictures."""
    return Path(str(files("fontpkg_noto_sans") / "files" / "NotoSans[wdth,wght].ttf"))


@cache
def register() -> None:
    """Register the font with reportlab, once."""
    pdfmetrics.registerFont(TTFont(REGULAR, font_file()))


def in_regular(text: str) -> bool:
    """Return whether Noto Sans has every character of a text: Latin, Greek and Cyrillic letters."""
    return all(character.isspace() or ord(character) in _glyphs() for character in text)


@cache
def _glyphs() -> frozenset[int]:
    return frozenset(TTFont(REGULAR, font_file()).face.charToGlyph)
