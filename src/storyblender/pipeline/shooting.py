"""Frames and moving frames: only what changed is drawn, each picture named by the hash of what it depends on."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from concurrent.futures import Future
from pathlib import Path

from storyblender.agents.layout_artist.story_moment import board_frame
from storyblender.memory.base import scene_name, shot_name, staged_id
from storyblender.memory.coverage import filmed
from storyblender.memory.graph import ProjectFormat
from storyblender.memory.jobs import FrameJob, FrameReport, Look, MomentJob, MotionJob
from storyblender.memory.scene_context import Lighting
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.filming import figures_of
from storyblender.pipeline.run import Run

MOTION_WIDTH_STEP = 4
FILM_RECORD = "build/film.txt"
"""Names and lengths of the shots of the film, in its order."""


def light_of(run: Run, shot: ShotContext) -> Lighting:
    """Return the light plan that holds in a shot: the last change before it, or the scene's.

    Args:
        run: With the scene lit.
        shot: The shot; only its ids are used.
    """
    lighting = run.graph.scene(shot.scene_id).lighting
    for other in run.graph.shots_of(shot.scene_id):
        if other.shot_id <= staged_id(shot.shot_id) and other.lighting is not None:
            lighting = other.lighting
    assert lighting is not None, "the Lighting Arranger comes before the camera rolls"
    return lighting


def shoot_frames(run: Run, shots: Collection[ShotContext]) -> dict[str, FrameReport]:
    """Draw the board frames and commit the face lights they were solved with, a scene at a time.

    A run that is stopped in a scene finds them again in the records of its frames.

    Args:
        run: With packs and cameras.
        shots: Those to draw, scene by scene; frames that are drawn already are taken from the cache.

    Returns:
        Shot name to report; the pictures lie in ``frames/``.

    Raises:
        EngineError: A frame failed for good.
        Cancelled: The run is cancelled.
    """
    waiting: list[tuple[ShotContext, FrameJob, FrameReport | Future[FrameReport]]] = []
    for shot in shots:
        job = frame_job(run, shot, run.settings.look)
        drawn = run.outputs.whole(job.out)
        known = run.outputs.read(f"{job.out}.json", FrameReport.model_validate_json) if drawn else None
        waiting.append((shot, job, run.engine.render_frame(job) if known is None else known))
    reports: dict[str, FrameReport] = {}
    lit: list[ShotContext] = []
    for step, (shot, job, report) in enumerate(waiting):
        if lit and lit[-1].scene_id != shot.scene_id:
            _commit_lights(run, lit)
            lit = []
        name = shot_name(shot.scene_id, shot.shot_id)
        run.progress("frames", step, len(waiting), name)
        if isinstance(report, Future):
            report = report.result()
            run.outputs.note(job.out)
            run.outputs.write(f"{job.out}.json", report.model_dump_json())
        _place(run, job.out, f"frames/{name}.png")
        lit += _newly_lit(run, run.graph.shot(shot.scene_id, shot.shot_id), report)
        reports[name] = report
    _commit_lights(run, lit)
    run.progress("frames", len(waiting), len(waiting))
    return reports


def _newly_lit(run: Run, shot: ShotContext, report: FrameReport) -> list[ShotContext]:
    """Return the shot with the face lights of a new camera; drawing in another look, or after an undo, changes none."""
    if shot.lights and (run.settings.look != run.made_in_look or run.project.has_undone):
        return []
    return [shot.model_copy(update={"lights": report.lights})]


def _commit_lights(run: Run, shots: Sequence[ShotContext]) -> None:
    if shots:
        run.commit("lighting_arranger", f"face lights of {scene_name(shots[0].scene_id)}", *shots)


def drawn_shots(run: Run) -> list[ShotContext]:
    """Return the shots whose current version is drawn."""
    return [shot for shot in run.graph.cut if run.outputs.whole(frame_picture(run, shot))]


def undrawn_shots(run: Run) -> list[str]:
    """Return the names of the shots of the film whose current version is not drawn."""
    shots = (shot for shot in run.graph.cut if not run.outputs.whole(frame_picture(run, shot)))
    return [shot_name(shot.scene_id, shot.shot_id) for shot in shots]


def damaged_frames(run: Run, shots: Collection[ShotContext]) -> list[ShotContext]:
    """Return the shots whose frame was there once and is gone, or cannot be read.

    Args:
        run: Its project has the frames.
        shots: Those to look at.
    """
    names = [f"frames/{shot_name(shot.scene_id, shot.shot_id)}.png" for shot in shots]
    return [
        shot
        for shot, name in zip(shots, names, strict=True)
        if (run.outputs.known(name) or run.project.path(name).exists()) and not _is_sound(run, name)
    ]


def shoot_motion(run: Run, shots: Collection[ShotContext]) -> dict[str, list[Path]]:
    """Draw the moving frames.

    Args:
        run: With packs and cameras.
        shots: Those to draw; moving frames that are drawn already are taken from the cache.

    Returns:
        Shot name to its pictures in order.

    Raises:
        EngineError: A shot failed for good.
        Cancelled: The run is cancelled.
    """
    waiting: list[tuple[str, str]] = []
    drawing: dict[str, Future[int]] = {}
    for shot in shots:
        folder = _motion_folder(run, shot)
        waiting.append((shot_name(shot.scene_id, shot.shot_id), folder))
        if folder not in drawing and not run.outputs.whole(folder):
            drawing[folder] = run.engine.render_motion(_motion_job(run, shot, folder))
    clips: dict[str, list[Path]] = {}
    for step, (name, folder) in enumerate(waiting):
        run.progress("motion", step, len(waiting), name)
        if folder in drawing:
            drawing.pop(folder).result()
            run.outputs.note(folder)
        clips[name] = sorted(run.project.path(folder).iterdir())
    run.progress("motion", len(waiting), len(waiting))
    return clips


def shots_not_in_film(run: Run) -> list[str]:
    """Return the names of the shots that look otherwise than when the film was shot."""
    return [
        shot_name(shot.scene_id, shot.shot_id)
        for shot in run.graph.cut
        if not run.outputs.whole(_motion_folder(run, shot))
    ]


def is_cut_otherwise(run: Run) -> bool:
    """Return whether the film has other shots, or another order, than the graph, and can be cut without shooting."""
    known = run.outputs.read(FILM_RECORD, bytes)
    film = known is not None and (run.project.folder / "animatic.mp4").exists()
    return film and known != cut_record(run) and not shots_not_in_film(run)


def cut_record(run: Run) -> bytes:
    """Return what is kept beside a film of the order of its shots."""
    shots = (filmed(run.graph, shot) for shot in run.graph.cut)
    names = (f"{shot_name(shot.scene_id, shot.shot_id)} {shot.duration}" for shot in shots)
    return "\n".join(names).encode()


def prune(run: Run, shots: Collection[ShotContext]) -> None:
    """Delete pictures, moving frames and packs of ours that no shot of the story uses any more.

    Args:
        run: With packs and cameras.
        shots: All shots of the story.
    """
    kept = {name for pack in run.packs.values() for name in (pack.path, pack.record, figures_of(pack))}
    for shot in shots:
        job = frame_job(run, shot, run.settings.look)
        name = shot_name(shot.scene_id, shot.shot_id)
        kept |= {job.out, f"{job.out}.json", f"{job.out}.review.json", _motion_folder(run, shot)}
        pack, start = run.packs[shot.scene_id], run.packs[shot.scene_id].start_of(shot.shot_id)
        kept |= {MomentJob(pack=pack, frame=frame).out for frame in range(start, start + shot.duration)}
        kept |= {f"frames/{name}.png", f"frames/slate_{name}.png"}
        kept |= {name for picture in pictures_of_takes(run, shot).values() for name in (picture, f"{picture}.json")}
    folders = ("frames", "motion", "moments", "scenes", "figures", "light")
    for folder in (*(f"build/{name}/" for name in folders), "frames/"):
        run.outputs.keep_only(folder, kept)


def pictures_of_takes(run: Run, shot: ShotContext) -> dict[int, str]:
    """Return the names of the pictures of a shot's other takes, drawn or not, by number of the take.

    Args:
        run: With the packs.
        shot: A take whose camera has to be set anew has no picture.
    """
    return {take.number: frame_picture(run, shot.showing(take)) for take in shot.takes if take.camera is not None}


def frame_picture(run: Run, shot: ShotContext) -> str:
    """Return the name in the project of the picture of a shot's current version, drawn or not.

    Args:
        run: With the packs.
        shot: With its camera.
    """
    return frame_job(run, shot, run.settings.look).out


def frame_job(
    run: Run, shot: ShotContext, look: Look, form: ProjectFormat | None = None, *, draft: bool = False
) -> FrameJob:
    """Return what the engine is asked for a shot's frame; its picture is named by all that it depends on.

    Args:
        run: With the packs.
        shot: With its camera.
        look: How it is drawn.
        form: Size and shape of the picture; the story's if not given.
        draft: Whether it is drawn in half the time.
    """
    shot = filmed(run.graph, shot)
    job = FrameJob(
        pack=run.packs[shot.scene_id],
        shot=shot,
        lighting=light_of(run, shot),
        format=form or run.graph.format,
        look=look,
        frame=board_frame(shot, run.packs[shot.scene_id].played(shot.shot_id)),
        out="",
        draft=draft,
    )
    return job.model_copy(update={"out": f"build/frames/{job.digest}.png"})


def _motion_job(run: Run, shot: ShotContext, folder: str) -> MotionJob:
    width = run.settings.animatic_width // MOTION_WIDTH_STEP * MOTION_WIDTH_STEP
    return MotionJob(
        pack=run.packs[shot.scene_id],
        shot=filmed(run.graph, run.graph.shot(shot.scene_id, shot.shot_id)),
        lighting=light_of(run, shot),
        format=run.graph.format,
        width=width,
        step=2 if run.settings.on_twos else 1,
        folder=folder,
    )


def _motion_folder(run: Run, shot: ShotContext) -> str:
    return f"build/motion/{_motion_job(run, shot, '').digest}"


def _place(run: Run, picture: str, name: str) -> None:
    """Give a picture its name for people; a copy, so that an artist may paint on it.

    What is painted stays until the shot looks otherwise.
    """
    if run.outputs.digest(name) == run.outputs.digest(picture) and _is_sound(run, name):
        return
    content, target = run.project.path(picture).read_bytes(), run.project.path(name)
    if target.is_file() and target.read_bytes() == content:
        run.outputs.note(name)
    else:
        run.copy_aside(name)
        run.outputs.write(name, content)


def _is_sound(run: Run, name: str) -> bool:
    """Return whether a frame is as it was written, or a readable picture that a person changed."""
    if run.outputs.whole(name):
        return True
    if not run.outputs.changed(name):  # gone, empty, or the one before, where a run was stopped
        return False
    from PIL import Image

    try:
        for read in ("verify", "load"):  # check sums, then pixels; the first leaves nothing to read
            with Image.open(run.project.path(name)) as picture:
                getattr(picture, read)()
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError):
        return False
    return True
