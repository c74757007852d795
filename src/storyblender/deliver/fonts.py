"""Fonts for boards and slates: Noto Sans, with Adobe's Asian fonts where it has no glyph."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from pathlib import Path
from xml.sax.saxutils import escape

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.cidfonts import UnicodeCIDFont
from reportlab.pdfbase.ttfonts import TTFont

REGULAR = "NotoSans"
_ASIAN = {"ko": "HYSMyeongJo-Medium", "ja": "HeiseiKakuGo-W5", "zh": "STSong-Light"}


def font_file() -> Path:
    """Return the path of the text font, for pictures."""
    return Path(str(files("fontpkg_noto_sans") / "files" / "NotoSans[wdth,wght].ttf"))


@cache
def register() -> None:
    """Make the fonts known to reportlab, once."""
    pdfmetrics.registerFont(TTFont(REGULAR, font_file()))
    for name in _ASIAN.values():
        pdfmetrics.registerFont(UnicodeCIDFont(name))


def markup(text: str) -> str:
    """Escape text for a reportlab paragraph, naming a font for every run that Noto Sans cannot set."""
    register()
    runs: list[tuple[str, str]] = []
    for character in text:
        font = _font_of(character)
        if runs and runs[-1][0] == font:
            runs[-1] = (font, runs[-1][1] + character)
        else:
            runs.append((font, character))
    return "".join(
        escape(run) if font == REGULAR else f'<font name="{font}">{escape(run)}</font>' for font, run in runs
    )


@cache
def _glyphs() -> frozenset[int]:
    return frozenset(TTFont(REGULAR, font_file()).face.charToGlyph)


def _font_of(character: str) -> str:
    code = ord(character)
    if code < 0x250 or code in _glyphs():
        return REGULAR
    if 0xAC00 <= code <= 0xD7AF or 0x1100 <= code <= 0x11FF:
        return _ASIAN["ko"]
    if 0x3040 <= code <= 0x30FF:
        return _ASIAN["ja"]
    return _ASIAN["zh"] if 0x2E80 <= code <= 0xFFEF else REGULAR
