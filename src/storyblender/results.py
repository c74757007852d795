"""What a call on a session returns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import Flaw
from storyblender.pipeline.reviewing import FrameReview

if TYPE_CHECKING:
    from storyblender.agents.director.reader.reasons import Reason


@dataclass(frozen=True)
class Delivery:
    """What a call made.

    Attributes:
        folder: The project.
        files: Names in it, in the order people open them.
        graph: The story as it is now.
        reasons: Which rule read what in the script, if that was asked.
        followed: Shots that nobody edited and that changed in consequence of an edit, each with what changed.
        wrong_cuts: What is wrong with the cuts to and from cameras that the call set.
        reviews: What the Frame Critic finds in the frames that were asked for, by shot name.
    """

    folder: Path
    files: list[str]
    graph: ContinuityMemoryGraph
    reasons: list[Reason] = field(default_factory=list)
    followed: tuple[str, ...] = ()
    wrong_cuts: tuple[Flaw, ...] = ()
    reviews: Mapping[str, FrameReview] = field(default_factory=dict)
