"""The film as a timeline: its shots with their lengths, and who speaks when."""

from __future__ import annotations

from collections.abc import Collection

from storyblender.deliver.panel import cue_of, panels
from storyblender.deliver.speech import speeches
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.web_studio.messages import Cut, CutShot, CutSpeech


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
                fixed="duration" in panel.shot.locked,
                speech=tuple(
                    CutSpeech(start=each.start, end=each.end, speaker=cue_of(each.line), words=each.line.text)
                    for each in speeches(panel)
                ),
            )
            for panel in panels(graph)
        ),
        stale=tuple(sorted(stale)),
    )
