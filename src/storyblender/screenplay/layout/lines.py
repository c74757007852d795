"""The lines of a page, and the elements built from them by character offsets."""

from __future__ import annotations

import re
from bisect import bisect_right
from typing import NamedTuple

from storyblender.screenplay.layout.spacing import PageRow, line_spacing
from storyblender.screenplay.model import Element, ElementKind

_EMPHASIS = re.compile(r"(?<![\w*])([*_]{1,3})(?=\S)([^*_\n]{1,300}?)(?<=\S)\1(?![\w*])")


class Line(NamedTuple):
    """A line of the file."""

    number: int
    start: int
    """Offset of its first non-space character."""
    words: str
    indent: int
    """Number of spaces before it; a tab counts as four."""

    @property
    def end(self) -> int:
        """Return the offset after its last non-space character."""
        return self.start + len(self.words)


def lines_of(text: str) -> list[Line]:
    """Return the lines of a text in order; a blank line has no words, and one that only spaces a speech is left out."""
    found: list[Line] = []
    position = 0
    for number, raw in enumerate(text.split("\n"), 1):
        words = raw.strip()
        lead = raw[: len(raw) - len(raw.lstrip())] if words else ""
        found.append(Line(number, position + len(lead), words, len(lead.expandtabs(4))))
        position += len(raw) + 1
    spacing = line_spacing([PageRow(line.indent, line.words) for line in found])
    return [line for index, line in enumerate(found) if index not in spacing]


def plain(words: str) -> str:
    """Return the words without emphasis marks, on one line."""
    return " ".join(_EMPHASIS.sub(r"\2", words).split())


class Page:
    """Collects the elements of a page.

    Args:
        text: The page.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.elements: list[Element] = []
        self.title_page: list[tuple[str, str]] = []
        self.picture: int | None = None
        """Number of the current panel, row or card."""
        self.pictures = 0
        self._starts = [line.start for line in lines_of(text)]

    def open_picture(self) -> None:
        """Begin the next panel, row or card."""
        self.pictures += 1
        self.picture = self.pictures

    def add(
        self, kind: ElementKind, start: int, end: int, *, name: str = "", extension: str = "", number: str = ""
    ) -> None:
        """Add the text between two offsets as an element; nothing if it has no words.

        Args:
            kind: Kind of the element.
            start: Offset of the first character; leading spaces are skipped.
            end: Offset after the last character.
            name: Speaker of a cue.
            extension: Bracket text of a cue.
            number: Number of a scene.
        """
        words = self.text[start:end]
        start, end = start + len(words) - len(words.lstrip()), start + len(words.rstrip())
        if start >= end:
            return
        words = self.text[start:end]
        shown = words.strip("()[]").strip() if kind == "parenthetical" else words
        self.elements.append(
            Element(
                kind=kind,
                text=plain(shown) if kind in ("heading", "cue", "parenthetical", "section", "title") else shown,
                start=start,
                end=end,
                line=bisect_right(self._starts, start),
                name=name,
                extension=extension,
                scene_number=number,
                picture=self.picture,
            )
        )
