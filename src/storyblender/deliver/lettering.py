"""Text in scripts that Noto Sans lacks, drawn with Blender's fonts: shaped, wrapped, left to right or right to left."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.util import find_spec
from itertools import groupby, pairwise
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont
from reportlab.lib.utils import ImageReader
from reportlab.platypus.flowables import Flowable

from storyblender.deliver.fonts import font_file, in_regular

EM = 48
"""Pixels of an em in the drawing, which is scaled to the font size on the page."""
LEADING, ASCENT = 1.28, 1.02
"""Ems from line to line, and from the top of a line to its baseline."""
_SPACE = 0.26
"""Ems between words."""
_RANGES = (
    (0x0530, 0x058F, "Armenian"), (0x0590, 0x05FF, "Hebrew"), (0x0600, 0x08FF, "Arabic"),
    (0x0900, 0x097F, "Devanagari"), (0x0980, 0x09FF, "Bengali"), (0x0A00, 0x0A7F, "Gurmukhi"),
    (0x0A80, 0x0AFF, "Gujarati"), (0x0B80, 0x0BFF, "Tamil"), (0x0C00, 0x0C7F, "Telugu"), (0x0C80, 0x0CFF, "Kannada"),
    (0x0D00, 0x0D7F, "Malayalam"), (0x0E00, 0x0E7F, "Thai"), (0x1000, 0x109F, "Myanmar"), (0x10A0, 0x10FF, "Georgian"),
    (0x1100, 0x11FF, " CJK"), (0x1200, 0x139F, "Ethiopic"), (0x1780, 0x17FF, "Khmer"), (0x2200, 0x22FF, "SansMath"),
    (0x2190, 0x23FF, "Symbols-"), (0x2500, 0x2BFF, "Symbols2"), (0x2E80, 0xA4CF, " CJK"), (0xA980, 0xA9DF, "Javanese"),
    (0xAC00, 0xD7FF, " CJK"), (0xF900, 0xFAFF, " CJK"), (0xFB50, 0xFDFF, "Arabic"), (0xFE30, 0xFE4F, " CJK"),
    (0xFE70, 0xFEFC, "Arabic"), (0xFF00, 0xFFEF, " CJK"), (0x1F000, 0x1FAFF, "Emoji"), (0x20000, 0x3FFFF, " CJK"),
)  # fmt: skip
"""First and last character of a script, and a part of the file name of Blender's font for it."""
_NO_LINE_START = "、。，．！？：；）」』】〉》〕…ー"


@dataclass(frozen=True)
class LetteredWord:
    """Letters of one font that are never broken over two lines.

    Attributes:
        text: Its letters, in reading order.
        font: Its font file.
        color: Of the letters, ``#rrggbb``.
        spaced: Whether a space stands before it.
    """

    text: str
    font: Path
    color: str
    spaced: bool

    @property
    def width(self) -> float:
        """In ems."""
        return _length(self.font, self.text)

    @property
    def from_right(self) -> bool:
        """Whether it is read from right to left."""
        return any(unicodedata.bidirectional(letter) in ("R", "AL") for letter in self.text)


class Lettering(Flowable):
    """A paragraph for reportlab, drawn as a picture.

    Args:
        pieces: Texts with their colours, in reading order.
        size: Points of an em.
        indent: Points.
        most: Most lines to draw; 0 for all.
    """

    def __init__(self, pieces: Sequence[tuple[str, str]], size: float, indent: float = 0.0, most: int = 0) -> None:
        super().__init__()
        self._words = [word for text, color in pieces for word in words_of(text, color)]
        self._size, self._indent, self._most = size, indent, most

    def wrap(self, aW: float, aH: float) -> tuple[float, float]:
        """Return the width given, and the height that the lines take.

        Args:
            aW: Points across that there are.
            aH: Points down that there are; not used.
        """
        lines = lines_of(self._words, (aW - self._indent) / self._size)
        self._lines = lines[: self._most] if self._most else lines
        self.width, self.height = aW, len(self._lines) * LEADING * self._size
        return self.width, self.height

    def split(self, aW: float, aH: float) -> list[Flowable]:
        """Return the lines that fit, if any do.

        Args:
            aW: Points across that there are; not used.
            aH: Points down that there are.
        """
        fits = int(aH // (LEADING * self._size))
        self._most = fits
        return [self] if fits else []

    def draw(self) -> None:
        """Put the picture on the page."""
        width = self.width - self._indent
        picture = ImageReader(draw_lines(self._lines, width / self._size))
        self.canv.drawImage(picture, self._indent, 0, width, self.height)


def words_of(text: str, color: str) -> Iterator[LetteredWord]:
    """Split text at spaces and where the font changes; a line may break after any Chinese or Japanese letter.

    Args:
        text: In reading order.
        color: Of the letters, ``#rrggbb``.
    """
    for word in text.split():
        spaced = True
        for font, run in _runs(word):
            for piece in _breakable(run) if " CJK" in font.name else (run,):
                yield LetteredWord(piece, font, color, spaced)
                spaced = False


def lines_of(words: Sequence[LetteredWord], width: float) -> list[list[LetteredWord]]:
    """Break words into lines of at most ``width`` ems.

    Args:
        words: In reading order; one that is longer than a line gets a line of its own.
        width: Ems.
    """
    lines: list[list[LetteredWord]] = [[]]
    used = 0.0
    for word in words:
        space = _SPACE if word.spaced and lines[-1] else 0.0
        if lines[-1] and used + space + word.width > width:
            lines.append([])
            used = space = 0.0
        lines[-1].append(word)
        used += space + word.width
    return lines if words else []


def width_of(text: str, size: float) -> float:
    """Return the width in points of a text on one line, at a font size of ``size`` points."""
    words = list(words_of(text, ""))
    return size * sum(word.width + _SPACE * (word.spaced and bool(at)) for at, word in enumerate(words))


def draw_lines(lines: Sequence[Sequence[LetteredWord]], width: float) -> Image.Image:
    """Return lines as a picture on white, ``width`` ems wide; right-to-left lines are aligned right.

    Args:
        lines: Words in reading order, as ``lines_of`` returns them.
        width: Ems, each ``EM`` pixels.
    """
    picture = Image.new("RGB", (max(1, round(width * EM)), max(1, round(len(lines) * LEADING * EM))), "white")
    draw = ImageDraw.Draw(picture)
    for number, line in enumerate(lines):
        order = _visual(line)
        spaces = [0.0, *(_SPACE * line[max(pair)].spaced for pair in pairwise(order))]
        x = width - sum(spaces) - sum(word.width for word in line) if line[0].from_right else 0.0
        baseline = (number * LEADING + ASCENT) * EM
        for space, word in zip(spaces, (line[at] for at in order), strict=True):
            x += space
            draw.text((x * EM, baseline), word.text, font=_face(word.font), fill=word.color, anchor="ls")
            x += word.width
    return picture


@lru_cache(maxsize=2**15)
def font_of(letter: str) -> Path:
    """Return the font for a character: Noto Sans, or else Blender's for its script."""
    if in_regular(letter):
        return font_file()
    code = ord(letter)
    key = next((key for first, last, key in _RANGES if first <= code <= last), "")
    return next((path for path in _blender_fonts() if key and key in path.name), font_file())


def _runs(word: str) -> list[tuple[Path, str]]:
    """Split a word where its font changes; punctuation keeps the font of the letters before it."""
    runs: list[tuple[Path, str]] = []
    for letter in word:
        font = runs[-1][0] if runs and in_regular(letter) and not letter.isalnum() else font_of(letter)
        if runs and runs[-1][0] == font:
            runs[-1] = (font, runs[-1][1] + letter)
        else:
            runs.append((font, letter))
    return runs


def _visual(line: Sequence[LetteredWord]) -> list[int]:
    """Return the indices of a line's words from left to right: right-to-left runs are reversed."""
    runs = [list(run) for _, run in groupby(range(len(line)), key=lambda at: line[at].from_right)]
    turned = [run[::-1] if line[run[0]].from_right else run for run in runs]
    return [at for run in (turned[::-1] if line[0].from_right else turned) for at in run]


def _breakable(run: str) -> list[str]:
    pieces: list[str] = []
    for letter in run:
        if pieces and letter in _NO_LINE_START:
            pieces[-1] += letter
        else:
            pieces.append(letter)
    return pieces


@lru_cache(maxsize=2**15)
def _length(font: Path, text: str) -> float:
    return _face(font).getlength(text) / EM


@cache
def _face(path: Path) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(str(path), EM)


@cache
def _blender_fonts() -> tuple[Path, ...]:
    """The fonts in Blender's package, which is found without loading it."""
    spec = find_spec("bpy")
    places = (spec.submodule_search_locations or []) if spec else []
    return tuple(sorted(path for place in places for path in Path(place).glob("*/datafiles/fonts/Noto*.woff2")))
