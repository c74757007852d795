"""Previews: small pictures in the quickest look, seconds after an edit; they are never delivered."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from storyblender.memory.base import shot_name
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import frame_job

PREVIEW_WIDTH = 480
"""Pixels, at most."""


def preview_shots(run: Run, shots: Collection[ShotContext]) -> dict[str, Path]:
    """Draw previews of the board frames; one that is drawn already is taken from the cache.

    Args:
        run: With packs and cameras.
        shots: Those to draw.

    Returns:
        Shot name to picture.

    Raises:
        EngineError: A preview failed for good.
        Cancelled: The run is cancelled.
    """
    small = run.graph.format.model_copy(update={"width": min(PREVIEW_WIDTH, run.graph.format.width)})
    jobs = {shot_name(shot.scene_id, shot.shot_id): frame_job(run, shot, "fast", small) for shot in shots}
    drawing = {name: run.engine.render_frame(job) for name, job in jobs.items() if not run.outputs.whole(job.out)}
    for name, report in drawing.items():
        report.result()
        run.outputs.note(jobs[name].out)
    return {name: run.project.path(job.out) for name, job in jobs.items()}
