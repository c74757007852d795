"""The input of every timeline format: the story, the media of its shots, and the start timecode."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from storyblender.deliver.panel import frame_of
from storyblender.memory.graph import ContinuityMemoryGraph


@dataclass(frozen=True)
class TimelineMedia:
    """A story with the media of its shots.

    Attributes:
        graph: The story.
        frames: Shot name to still picture.
        clips: Shot name to moving picture, as long as the shot.
        folder: Media paths are written relative to it, so that the project can be moved.
        start: Timecode of the first frame, ``HH:MM:SS:FF``.
    """

    graph: ContinuityMemoryGraph
    frames: Mapping[str, Path]
    clips: Mapping[str, Path]
    folder: Path
    start: str = "00:00:00:00"

    @property
    def first(self) -> int:
        """Frame number of the start timecode."""
        return frame_of(self.start, self.graph.format.fps)
