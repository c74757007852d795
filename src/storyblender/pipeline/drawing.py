"""Shots are drawn, poor ones taken again, and what is delivered is written."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.memory.base import content_hash
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.compiling import Compilation
from storyblender.pipeline.retaking import retake_poor_frames
from storyblender.pipeline.reviewing import FrameReview
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import damaged_frames, is_cut_otherwise, prune, shoot_frames, shoot_motion

DELIVERED = "build/delivered"
"""Name of the record of the story that the deliverables show: its hash."""


def draw_frames(run: Run, shots: Sequence[ShotContext]) -> None:
    """Draw the frames of shots and take poor ones again; nothing is delivered.

    Args:
        run: With packs and cameras.
        shots: Those to draw.
    """
    shoot_frames(run, shots)
    retake_poor_frames(run, shots)


def draw_shots(run: Run, shots: Sequence[ShotContext]) -> tuple[list[str], dict[str, FrameReview]]:
    """Draw shots, take poor ones again, and deliver; the film has every shot moving, whichever are named.

    Args:
        run: With packs and cameras.
        shots: Those to draw.

    Returns:
        Names of the files in the project, in the order people open them, and the reviews of the frames by shot name.
    """
    asked = {(shot.scene_id, shot.shot_id) for shot in shots}
    film = run.graph.cut
    others = [shot for shot in film if (shot.scene_id, shot.shot_id) not in asked]
    shoot_frames(run, [*shots, *damaged_frames(run, others)])
    reviews = retake_poor_frames(run, shots)
    story = Compilation(run)
    from storyblender.pipeline.delivery import deliver

    clips = shoot_motion(run, film) if run.settings.animatic or is_cut_otherwise(run) else None
    if len(shots) >= len(film):
        prune(run, run.graph.shots)
    files = deliver(run, clips, story)
    run.outputs.write(DELIVERED, content_hash(run.graph))
    return files, reviews
