"""Previews, seconds after an edit: small pictures in the quickest look, and moments in 3D; they are never delivered."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from storyblender.agents.layout_artist.story_moment import board_frame
from storyblender.memory.base import shot_name
from storyblender.memory.jobs import MomentJob
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


def moment_of(run: Run, shot: ShotContext, frame: int | None) -> tuple[Path, int]:
    """Return the scene at one moment of a shot as glTF, and the moment's frame from the start of the shot.

    Args:
        run: With packs; a file that is written already is taken from the cache.
        shot: The shot.
        frame: From its start, at most its last; None for the one that the board shows.

    Raises:
        EngineError: It could not be written.
        Cancelled: The run is cancelled.
    """
    pack = run.packs[shot.scene_id]
    moment = board_frame(shot, pack.played(shot.shot_id)) if frame is None else min(frame, shot.duration - 1)
    job = MomentJob(pack=pack, frame=pack.start_of(shot.shot_id) + moment)
    if not run.outputs.whole(job.out):
        run.engine.write_moment(job).result()
        run.outputs.note(job.out)
    return run.project.path(job.out), moment
