"""When each line of a shot begins: by the motions that play it, else by its share of the words."""

from __future__ import annotations

from itertools import accumulate

from storyblender.agents.layout_artist.story_moment import cues_of
from storyblender.deliver.panel import panels
from storyblender.deliver.speech import speeches
from storyblender.edits.effect import name_of
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import ShotContext


def line_frames(graph: ContinuityMemoryGraph, shot: ShotContext) -> list[int]:
    """Return the frame at which each line of a shot begins, counted from its start; the first at 0.

    Args:
        graph: The story as the film shows it.
        shot: One of its shots; only its ids are used.
    """
    panel = next(each for each in panels(graph, with_omitted=True) if each.name == name_of(shot))
    lines, film = panel.outline.lines, panel.shot
    spoken = iter(speeches(panel))
    words = [*accumulate((max(line.word_count, 1) for line in lines), initial=0)]
    frames: list[int] = []
    for index, line in enumerate(lines):
        begins = round(film.duration * words[index] / words[-1])
        if line.kind == "dialogue":
            begins = next(spoken).start
        else:
            actions = (action for action in film.character_actions if action.line_index == index)
            begins = min((cue.start for action in actions for cue in cues_of(action, film)), default=begins)
        low, high = frames[-1] + 1 if frames else 0, max(film.duration - (len(lines) - index), 0)
        frames.append(0 if index == 0 else max(low, min(begins, high)))
    return frames
