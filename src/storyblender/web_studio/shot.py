"""What the inspector of the page shows of a shot besides its details: times of lines, what is sharp, where to split."""

from __future__ import annotations

import math

from storyblender.agents.director.durations import SHORTEST_SHOT
from storyblender.deliver.panel import Panel
from storyblender.deliver.speech import speeches
from storyblender.edits.line_frames import line_frames
from storyblender.memory.base import Described
from storyblender.memory.coverage import as_filmed, is_beside
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


class SplitPlaces(Described):
    """Where a shot is split so that neither part is shorter than the shortest shot that the Director plans."""

    shortest: float
    """Seconds of that shot."""
    first: float
    """Second from which it can be split, in tenths."""
    last: float
    """Second up to which; before the first one if nowhere."""
    lines: tuple[int, ...]
    """Numbers of the lines at whose beginning it can be split."""


class InInspector(Described):
    """A shot in the inspector, besides its details."""

    speech: tuple[LineTime, ...]
    """When its lines are said, in order."""
    focus: tuple[str, ...]
    """What its lens is focused on: at first, and at last if the focus is racked; empty where all is sharp."""
    names: dict[str, str]
    """Names of the people on stage by id."""
    split: SplitPlaces
    """Where it can be split."""


def in_inspector(panel: Panel, graph: ContinuityMemoryGraph) -> InInspector:
    """Return what the inspector shows of a shot besides its details.

    Args:
        panel: The shot.
        graph: The story.
    """
    shot, lines = panel.shot, panel.lines
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
        split=split_places(graph, panel),
        names={asset_id: graph.asset(asset_id).name or asset_id for asset_id in shot.on_stage},
    )


def split_places(graph: ContinuityMemoryGraph, panel: Panel) -> SplitPlaces:
    """Return where a shot is sensibly split; another camera on the time of other shots is nowhere.

    Args:
        graph: The story.
        panel: A shot of it.
    """
    shot, fps = graph.shot(panel.shot.scene_id, panel.shot.shot_id), graph.format.fps
    least = math.ceil(SHORTEST_SHOT * fps)
    last = 0 if is_beside(shot) else panel.shot.duration - least
    frames = enumerate(line_frames(as_filmed(graph), shot), start=1)
    return SplitPlaces(
        shortest=SHORTEST_SHOT,
        first=math.ceil(least / fps * 10) / 10,
        last=math.floor(last / fps * 10) / 10,
        lines=tuple(number for number, frame in frames if number > 1 and least <= frame <= last),
    )
