"""Where the picture and the words of every panel lie on a page of the board."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from reportlab.lib.pagesizes import A3, A4, LEGAL, LETTER, TABLOID

from storyblender.memory.board_layout import BoardLayout, Paper

MARGIN, GUTTER = 30.0, 16.0
HEADING = 13.0
"""Points kept free above every picture for a scene heading."""
PAPERS: dict[Paper, tuple[float, float]] = {
    "a4": A4, "letter": LETTER, "a3": A3, "legal": LEGAL, "tabloid": TABLOID,
}  # fmt: skip
"""Short and long side in points."""

_HEAD, _FOOT = 16.0, 22.0
"""Points for the title above the panels, and for title and page number together."""
_LEAST_WORDS = 480.0
"""Width of the text under a picture in points, where its panel is as wide."""
_LEAST_WIDTH = 140.0
"""Of a panel that stands beside others, in points."""
_LEAST_LINES = 5.5
"""Lines under a picture, with that of the slate, as heights of its letters."""
_LEAST_BESIDE, _BESIDE_GAP = 150.0, 12.0
"""Least width of the text beside a picture, and what lies between the two, in points."""
_LARGEST_SHARE = 0.76
"""Largest share of a panel's height for a picture with words under it."""
_LARGEST_SHARE_ALONE = 0.78
"""The same of the only panel of a page."""
_LEAST_SIZE, _USUAL_SIZE, _LARGEST_SIZE = 7.5, 9.0, 15.0
"""Font sizes in points."""
_USUAL_WIDTH = 250.0
"""Width in points of a panel whose words have the usual size at least, however low the room under its picture."""
_ROOM, _ACROSS = 190.0, 16.0
"""Squares of a font size that the room for words has, and font sizes that its width has, at least: some 340 letters, in
lines of 30 and more.
"""


class Box(NamedTuple):
    """A rectangle on a page, in points."""

    left: float
    top: float
    """From the lower edge of the page."""
    width: float
    height: float

    @property
    def bottom(self) -> float:
        """Lower edge, from that of the page."""
        return self.top - self.height


@dataclass(frozen=True)
class Cell:
    """Where a panel lies on its page.

    Attributes:
        picture: The frame; the scene's heading stands above it.
        words: Slate, action, dialogue and notes.
        size: Font size of the slate in points.
        beside: Whether the words stand at the right of the picture.
    """

    picture: Box
    words: Box
    size: float
    beside: bool


def page_size(layout: BoardLayout) -> tuple[float, float]:
    """Return width and height of a page in points."""
    short, long = PAPERS[layout.paper]
    return (long, short) if layout.orientation == "landscape" else (short, long)


def cells_of(layout: BoardLayout, aspect: float) -> list[Cell]:
    """Return the panels of a page, row by row: in the grid in which pictures are largest.

    Args:
        layout: Of the pages.
        aspect: Width over height of the pictures.
    """
    return max(_grids(layout, aspect), key=lambda cells: round(cells[0].picture.width * cells[0].picture.height))


def _grids(layout: BoardLayout, aspect: float) -> Iterator[list[Cell]]:
    """Yield the panels of every grid, with the words under the pictures and beside them."""
    for columns in (count for count in range(layout.panels, 0, -1) if layout.panels % count == 0):
        boxes = [_box(layout, columns, index) for index in range(layout.panels)]
        if columns > 1 and boxes[0].width < _LEAST_WIDTH:
            continue
        share = _LARGEST_SHARE_ALONE if layout.panels == 1 else _LARGEST_SHARE
        yield [_words_under(box, aspect, share) for box in boxes]
        if boxes[0].width > _LEAST_BESIDE + _BESIDE_GAP:
            yield [_words_beside(box, aspect) for box in boxes]


def _box(layout: BoardLayout, columns: int, index: int) -> Box:
    """Return the place of a panel on the page, without what is kept free for the heading."""
    across, down = page_size(layout)
    width = (across - 2 * MARGIN - (columns - 1) * GUTTER) / columns
    row = (down - 2 * MARGIN - _FOOT) / (layout.panels // columns)
    left = MARGIN + index % columns * (width + GUTTER)
    return Box(left, down - MARGIN - _HEAD - HEADING - index // columns * row, width, row - HEADING)


def _words_under(box: Box, aspect: float, share: float) -> Cell:
    least = _LEAST_LINES * min(_USUAL_SIZE * math.sqrt(min(box.width, _LEAST_WORDS) / _USUAL_WIDTH), _USUAL_SIZE * 1.4)
    height = min(box.width / aspect, box.height * share, box.height - least)
    width = height * aspect
    words_width = min(box.width, max(width, _LEAST_WORDS))
    picture = Box(box.left + (box.width - width) / 2, box.top, width, height)
    words = Box(box.left + (box.width - words_width) / 2, box.top - height, words_width, box.height - height)
    return Cell(picture, words, _font_size(words), beside=False)


def _words_beside(box: Box, aspect: float) -> Cell:
    width = min(box.height * aspect, box.width - _LEAST_BESIDE - _BESIDE_GAP)
    left = box.left + width + _BESIDE_GAP
    words = Box(left, box.top, box.left + box.width - left, box.height)
    return Cell(Box(box.left, box.top, width, width / aspect), words, _font_size(words), beside=True)


def _font_size(words: Box) -> float:
    """Return the font size in points for words in a room: as large as a usual text fits it."""
    size = min(math.sqrt(words.width * words.height / _ROOM), words.width / _ACROSS)
    return min(_LARGEST_SIZE, max(_LEAST_SIZE, size))
