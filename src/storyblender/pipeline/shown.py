"""Which story a file that is written on request shows, so that it can be said whether that is still the present one."""

from __future__ import annotations

from storyblender.memory.base import content_hash
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import ShotContext
from storyblender.outputs import Outputs

FILM = "animatic.mp4"
_RECORDS = "build/shown"
_UNSEEN = {"notes": (), "approved": None, "locked": (), "takes": ()}
"""What people say about a shot; no film, timeline or scene shows it."""


def note_shown(outputs: Outputs, graph: ContinuityMemoryGraph, name: str) -> None:
    """Keep which story a file shows that was just written.

    Args:
        outputs: Of the project.
        graph: The story that it shows.
        name: Of the file in the project.
    """
    outputs.write(_record(name), _shown_of(graph))


def note_old(outputs: Outputs, name: str) -> None:
    """Keep that a file shows an earlier story."""
    outputs.write(_record(name), "")


def shows(outputs: Outputs, graph: ContinuityMemoryGraph, name: str) -> bool | None:
    """Return whether a file shows a story as it is; None if it was written before this was kept.

    Args:
        outputs: Of the project.
        graph: The story.
        name: Of the file in the project.
    """
    shown = outputs.read(_record(name), bytes.decode)
    return None if shown is None else shown == _shown_of(graph)


def as_seen(shot: ShotContext) -> ShotContext:
    """Return a shot without what people say about it, which no picture shows."""
    return shot.model_copy(update=_UNSEEN)


def _record(name: str) -> str:
    return f"{_RECORDS}/{name.replace('/', '-')}.txt"


def _shown_of(graph: ContinuityMemoryGraph) -> str:
    shots = tuple(as_seen(shot) for shot in graph.shots)
    return content_hash(graph.model_copy(update={"shots": shots}))
