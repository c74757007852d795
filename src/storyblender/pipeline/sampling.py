"""A story that was written by hand, staged and drawn: what the pictures of the catalogue show."""

from __future__ import annotations

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.pipeline.filming import film
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import shoot_frames
from storyblender.pipeline.staging import stage


def draw_story(run: Run, story: ContinuityMemoryGraph, reason: str) -> None:
    """Stage and draw a story in an empty project.

    Args:
        run: On the project.
        story: Scenes and shots as a Director plans them.
        reason: For the history.
    """
    run.project.commit(story, "user", reason)
    materialize(run)
    stage(run)
    pack_scenes(run)
    film(run)
    shoot_frames(run, run.graph.shots)
