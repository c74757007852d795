"""What a shot that a person split off or added shows of the time that the crew staged for another."""

from __future__ import annotations

from pydantic import Field

from storyblender.memory.base import Frames, Frozen


class Covers(Frozen):
    """The part of a staged shot that another shot shows; which staged shot, its own number tells (``staged_id``)."""

    start: Frames
    """First frame, counted from the start of the staged shot."""
    first_line: int | None = Field(default=None, ge=0)
    """Of what was split off: index in the staged shot of its first line; its time goes on to the next shot. None of
    another camera on the same moment, which has no lines of its own and is as long as its ``duration``."""
