"""Frames and moving frames: only what changed is drawn, each picture named by the hash of what it depends on."""

from __future__ import annotations

import shutil
from collections.abc import Collection
from concurrent.futures import Future
from pathlib import Path

from storyblender.agents.layout_artist.camera_scene import story_moment
from storyblender.memory.base import shot_name
from storyblender.memory.jobs import FrameJob, FrameReport, Look, MotionJob
from storyblender.memory.scene_context import Lighting
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.run import Run
from storyblender.project import write_atomic

MOTION_WIDTH_STEP = 4


def light_of(run: Run, shot: ShotContext) -> Lighting:
    """Return the light plan that holds in a shot: the last change before it, or the scene's."""
    lighting = run.graph.scene(shot.scene_id).lighting
    for other in run.graph.shots_of(shot.scene_id):
        if other.shot_id <= shot.shot_id and other.lighting is not None:
            lighting = other.lighting
    assert lighting is not None, "the Lighting Arranger comes before the camera rolls"
    return lighting


def shoot_frames(run: Run, shots: Collection[ShotContext]) -> dict[str, FrameReport]:
    """Draw the board frames and commit the face lights they were solved with.

    Returns:
        Shot name to report; the pictures lie in ``frames/``.
    """
    waiting: list[tuple[ShotContext, FrameJob, Future[FrameReport] | None]] = []
    for shot in shots:
        job = _frame_job(run, shot, run.settings.look)
        known = run.project.path(f"{job.out}.json").exists() and run.project.path(job.out).exists()
        waiting.append((shot, job, None if known else run.engine.render_frame(job)))
    reports: dict[str, FrameReport] = {}
    for step, (shot, job, future) in enumerate(waiting):
        name = shot_name(shot.scene_id, shot.shot_id)
        run.progress("frames", step, len(waiting), name)
        record = run.project.path(f"{job.out}.json")
        if future is not None:
            write_atomic(record, future.result().model_dump_json())
        report = FrameReport.model_validate_json(record.read_bytes())
        _place(run.project.path(job.out), run.project.path("frames", f"{name}.png"))
        current = run.graph.shot(shot.scene_id, shot.shot_id)
        run.commit("lighting_arranger", f"face lights of {name}", current.model_copy(update={"lights": report.lights}))
        reports[name] = report
    run.progress("frames", len(waiting), len(waiting))
    return reports


def shoot_motion(run: Run, shots: Collection[ShotContext]) -> dict[str, list[Path]]:
    """Draw the moving frames.

    Returns:
        Shot name to its pictures in order.
    """
    waiting: list[tuple[str, Path]] = []
    drawing: dict[Path, tuple[Path, Future[int]]] = {}
    for shot in shots:
        folder = f"build/motion/{_motion_job(run, shot, '').digest}"
        done = run.project.path(folder)
        waiting.append((shot_name(shot.scene_id, shot.shot_id), done))
        if not done.is_dir() and done not in drawing:
            part = run.project.path(f"{folder}.part")
            shutil.rmtree(part, ignore_errors=True)
            drawing[done] = part, run.engine.render_motion(_motion_job(run, shot, f"{folder}.part"))
    clips: dict[str, list[Path]] = {}
    for step, (name, done) in enumerate(waiting):
        run.progress("motion", step, len(waiting), name)
        if done in drawing:
            part, future = drawing.pop(done)
            future.result()
            part.rename(done)
        clips[name] = sorted(done.iterdir())
    run.progress("motion", len(waiting), len(waiting))
    return clips


def shots_not_in_film(run: Run) -> list[str]:
    """Return the names of the shots that look otherwise than when the film was shot."""
    return [
        shot_name(shot.scene_id, shot.shot_id)
        for shot in run.graph.shots
        if not (run.project.folder / f"build/motion/{_motion_job(run, shot, '').digest}").is_dir()
    ]


def prune(run: Run, shots: Collection[ShotContext]) -> None:
    """Delete pictures, moving frames and packs that no shot of the story uses any more."""
    kept = {pack.path for pack in run.packs.values()} | {f"{pack.path[:-6]}.json" for pack in run.packs.values()}
    for shot in shots:
        job = _frame_job(run, shot, run.settings.look)
        kept |= {job.out, f"{job.out}.json", f"build/motion/{_motion_job(run, shot, '').digest}"}
    names = {f"frames/{shot_name(shot.scene_id, shot.shot_id)}.png" for shot in shots}
    root = run.project.folder
    for folder in ("build/frames", "build/motion", "build/scenes", "frames"):
        for path in sorted((root / folder).glob("*")):
            name = path.relative_to(root).as_posix()
            if name in kept or name in names or path.name.startswith("slate_"):
                continue
            shutil.rmtree(path) if path.is_dir() else path.unlink()


def _frame_job(run: Run, shot: ShotContext, look: Look) -> FrameJob:
    job = FrameJob(
        pack=run.packs[shot.scene_id],
        shot=shot,
        lighting=light_of(run, shot),
        format=run.graph.format,
        look=look,
        frame=story_moment(shot),
        out="",
    )
    return job.model_copy(update={"out": f"build/frames/{job.digest}.png"})


def _motion_job(run: Run, shot: ShotContext, folder: str) -> MotionJob:
    width = run.settings.animatic_width // MOTION_WIDTH_STEP * MOTION_WIDTH_STEP
    return MotionJob(
        pack=run.packs[shot.scene_id],
        shot=run.graph.shot(shot.scene_id, shot.shot_id),
        lighting=light_of(run, shot),
        format=run.graph.format,
        width=width,
        step=2 if run.settings.on_twos else 1,
        folder=folder,
    )


def _place(source: Path, target: Path) -> None:
    """Give the picture its name for people; a copy, so that an artist may paint on it."""
    if not target.exists() or target.read_bytes() != source.read_bytes():
        write_atomic(target, source.read_bytes())
