"""How a person wants the pages of the board: panels on a page, paper, and how it lies."""

from __future__ import annotations

from typing import Literal

from storyblender.memory.base import Described

Paper = Literal["a4", "letter", "a3", "legal", "tabloid"]
Orientation = Literal["landscape", "portrait"]
PanelsPerPage = Literal[1, 2, 3, 4, 6, 9, 12]


class BoardLayout(Described):
    """The pages of the board."""

    panels: PanelsPerPage = 6
    """Panels on a page."""
    paper: Paper = "a4"
    """Size of the pages."""
    orientation: Orientation = "landscape"
    """How the pages lie."""
