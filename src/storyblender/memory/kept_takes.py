"""Takes of blocking and of layout: what a person decided, put by under a number; one of them is in the film."""

from __future__ import annotations

from pydantic import Field

from storyblender.memory.base import Frozen, is_none
from storyblender.memory.scene_decision import BlockingDecision, LayoutDecision


class BlockingTake(Frozen):
    """A blocking of a shot that was put by."""

    number: int = Field(ge=1, le=999)
    """What people call it."""
    decision: BlockingDecision | None = Field(default=None, exclude_if=is_none)
    """Marks, poses and motions; None for what the crew makes of the script alone."""


class BlockingTakes(Frozen):
    """The takes of a shot's blocking."""

    number: int = Field(ge=1, le=999)
    """Of the one in the film: the shot's own decision."""
    others: tuple[BlockingTake, ...] = ()
    """By number."""


class LayoutTake(Frozen):
    """A layout of a scene that was put by."""

    number: int = Field(ge=1, le=999)
    """What people call it."""
    decision: LayoutDecision | None = Field(default=None, exclude_if=is_none)
    """Staging, and where things were placed; None for the crew's first."""


class LayoutTakes(Frozen):
    """The takes of a scene's layout."""

    number: int = Field(ge=1, le=999)
    """Of the one in the film: the scene's own decision."""
    others: tuple[LayoutTake, ...] = ()
    """By number."""
