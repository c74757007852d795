"""What the inspector of the page shows of a shot besides its details: when its lines are said, what is sharp."""

from __future__ import annotations

from storyblender.deliver.panel import Panel
from storyblender.deliver.speech import speeches
from storyblender.memory.base import Described
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_decision import PersonMarks


class LineTime(Described):
    """When a line of a shot is said."""

    line: int
    """Its number in the shot, from 1; edits name it so."""
    person: str
    """Id of who says it."""
    at: float
    """Second of the shot from which."""
    seconds: float
    """Its length."""
    decided: bool
    """Whether a person decided about it."""


class InInspector(Described):
    """A shot in the inspector, besides its details."""

    speech: tuple[LineTime, ...]
    """When its lines are said, in order."""
    focus: tuple[str, ...]
    """What its lens is focused on: at first, and at last if the focus is racked; empty where all is sharp."""
    names: dict[str, str]
    """Names of the people on stage by id."""


def in_inspector(panel: Panel, graph: ContinuityMemoryGraph) -> InInspector:
    """Return what the inspector shows of a shot besides its details.

    Args:
        panel: The shot.
        graph: The story.
    """
    shot, lines = panel.shot, panel.outline.lines
    decided = shot.blocking_decision.people if shot.blocking_decision is not None else {}
    keys = shot.camera.focus if shot.camera is not None else ()

    def timed() -> list[LineTime]:
        times: list[LineTime] = []
        for speech in speeches(panel):
            number, person = lines.index(speech.line) + 1, speech.line.speaker or ""
            start, end = (round(frame / panel.fps, 2) for frame in (speech.start, speech.end))
            own = decided.get(person, PersonMarks()).lines
            times.append(
                LineTime(line=number, person=person, at=start, seconds=round(end - start, 2), decided=number in own)
            )
        return times

    return InInspector(
        speech=tuple(timed()),
        focus=tuple(dict.fromkeys(key.node_id for key in (*keys[:1], *keys[-1:]))),
        names={asset_id: graph.asset(asset_id).name or asset_id for asset_id in shot.on_stage},
    )
