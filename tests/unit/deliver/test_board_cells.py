"""Pages of the board in every layout: nothing lies over something else or off the page."""

from __future__ import annotations

from itertools import combinations, product
from pathlib import Path
from typing import get_args

import pytest

from storyblender.deliver import board
from storyblender.deliver.board_cells import HEADING, MARGIN, Box, cells_of, page_size
from storyblender.memory.board_layout import BoardLayout, Orientation, PanelsPerPage, Paper
from storyblender.memory.graph import ContinuityMemoryGraph

LAYOUTS = [
    BoardLayout(panels=panels, paper=paper, orientation=orientation)
    for panels, paper, orientation in product(get_args(PanelsPerPage), get_args(Paper), get_args(Orientation))
]
ASPECTS = (0.5625, 1.0, 1.33, 16 / 9, 2.39)


def overlap(one: Box, other: Box) -> bool:
    across = min(one.left + one.width, other.left + other.width) - max(one.left, other.left)
    down = min(one.top, other.top) - max(one.bottom, other.bottom)
    return across > 0.1 and down > 0.1


@pytest.mark.parametrize("aspect", ASPECTS)
def test_pictures_and_words_of_every_layout_lie_on_the_page_and_apart(aspect: float) -> None:
    for layout in LAYOUTS:
        across, down = page_size(layout)
        cells = cells_of(layout, aspect)
        assert len(cells) == layout.panels
        boxes = [box for cell in cells for box in (cell.picture, cell.words)]
        for box in boxes:
            assert box.left >= MARGIN - 0.1 and box.left + box.width <= across - MARGIN + 0.1, layout
            assert box.bottom >= MARGIN - 0.1 and box.top <= down - MARGIN - HEADING, layout
        assert not any(overlap(*pair) for pair in combinations(boxes, 2)), layout


@pytest.mark.parametrize("aspect", ASPECTS)
def test_every_picture_has_the_shape_of_the_film_and_room_for_its_words(aspect: float) -> None:
    for layout in LAYOUTS:
        for cell in cells_of(layout, aspect):
            assert cell.picture.width / cell.picture.height == pytest.approx(aspect)
            assert cell.words.width > 120 and cell.words.height > 5 * cell.size, layout


def test_pictures_grow_with_the_paper_and_shrink_with_their_number() -> None:
    def width(**layout: object) -> float:
        return cells_of(BoardLayout.model_validate(layout), 16 / 9)[0].picture.width

    assert width(paper="a3") > width(paper="a4") > width(paper="a4", panels=9)
    assert width(panels=1) > width(panels=2) > width(panels=6)


@pytest.mark.parametrize(
    ("layout", "box"),
    [
        (BoardLayout(), b"841.8898 595.2756"),
        (BoardLayout(paper="letter"), b"792 612"),
        (BoardLayout(paper="a3", orientation="portrait"), b"841.8898 1190.551"),
    ],
)
def test_a_board_is_as_large_as_its_paper(
    graph: ContinuityMemoryGraph, tmp_path: Path, layout: BoardLayout, box: bytes
) -> None:
    board.write_board(graph, {}, tmp_path / "a.pdf", layout)
    assert b"/MediaBox [ 0 0 " + box in (tmp_path / "a.pdf").read_bytes()
