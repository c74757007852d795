"""Previews, seconds after an edit: small pictures in the quickest look, and moments in 3D; they are never delivered."""

from __future__ import annotations

from pathlib import Path

from storyblender.agents.layout_artist.story_moment import board_frame
from storyblender.memory.jobs import MomentJob
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.rehearsing import CamerasToMatch, rehearse, with_camera_in_rehearsal
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import frame_job
from storyblender.pipeline.updating import bring_scene_up_to_date

PREVIEW_WIDTH = 512
"""Pixels, at most; heights are in fours, and 16:9 of this is exact, so that a preview fills the place of its frame."""


def preview_shot(run: Run, shot: ShotContext, matching: CamerasToMatch) -> Path:
    """Draw a preview of a shot's board frame; one that is drawn already is taken from the cache.

    The scene of the shot is rehearsed, and its camera is set if it is not yet: only this shot of it, and nothing of
    that is kept. Packing the scene and setting all cameras of it may follow.

    Args:
        run: Of a made project; the scene of the shot is brought up to date.
        shot: The shot.
        matching: What its camera has to match where others of the scene are not set yet.

    Returns:
        The picture.

    Raises:
        EngineError: It failed for good.
        Cancelled: The run is cancelled.
    """
    bring_scene_up_to_date(run, shot.scene_id)
    front = run.in_front()
    rehearse(front, shot)
    shot = with_camera_in_rehearsal(front, run.graph.shot(shot.scene_id, shot.shot_id), matching)
    small = run.graph.format.model_copy(update={"width": min(PREVIEW_WIDTH, run.graph.format.width)})
    job = frame_job(front, shot, "fast", small, draft=True)
    if not run.outputs.whole(job.out):
        front.engine.render_frame(job).result()
        run.outputs.note(job.out)
    return run.project.path(job.out)


def moment_of(run: Run, shot: ShotContext, frame: int | None) -> tuple[Path, int]:
    """Return the scene at one moment of a shot as glTF, and the moment's frame from the start of the shot.

    Args:
        run: With the shot rehearsed; a file that is written already is taken from the cache.
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
