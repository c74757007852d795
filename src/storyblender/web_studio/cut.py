"""The film as a timeline: its shots with their lengths, and who speaks when."""

from __future__ import annotations

from collections.abc import Collection

from storyblender.deliver.panel import cue_of, panels
from storyblender.deliver.speech import speeches
from storyblender.edits.camera_edits import refuse_fixed_length
from storyblender.errors import InputError
from storyblender.memory.base import Described, scene_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import ShotContext


class CutSpeech(Described):
    """A speech on the timeline."""

    start: int
    """First frame, from the start of its shot."""
    end: int
    """The frame after the last."""
    speaker: str
    """As scripts write a cue."""
    words: str
    """What is said."""


class CutShot(Described):
    """A shot on the timeline."""

    shot: str
    """Its name."""
    scene: str
    """Name of its scene."""
    title: str
    """Heading of its scene."""
    frames: int
    """Length."""
    held: str
    """Why its length cannot be changed, in a sentence; empty where it can."""
    speech: tuple[CutSpeech, ...]
    """In order."""


class Cut(Described):
    """The film as a timeline."""

    fps: int
    """Frames a second."""
    shots: tuple[CutShot, ...]
    """In the order of the film, without what is omitted."""
    stale: tuple[str, ...]
    """Shots whose pictures do not show the story as it is."""


def cut_of(graph: ContinuityMemoryGraph, stale: Collection[str]) -> Cut:
    """Return the film of a story as a timeline.

    Args:
        graph: The story.
        stale: Names of shots whose pictures do not show the story as it is.
    """
    return Cut(
        fps=graph.format.fps,
        shots=tuple(
            CutShot(
                shot=panel.name,
                scene=scene_name(panel.scene.scene_id),
                title=panel.scene.numbered_title,
                frames=panel.shot.duration,
                held=_held(graph, panel.shot),
                speech=tuple(
                    CutSpeech(start=each.start, end=each.end, speaker=cue_of(each.line), words=each.line.text)
                    for each in speeches(panel)
                ),
            )
            for panel in panels(graph)
        ),
        stale=tuple(sorted(stale)),
    )


def _held(graph: ContinuityMemoryGraph, shot: ShotContext) -> str:
    try:
        refuse_fixed_length(graph, graph.shot(shot.scene_id, shot.shot_id))
    except InputError as error:
        return str(error)
    return ""
