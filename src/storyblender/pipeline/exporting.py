"""Exports on demand: scenes for other 3D programs, the timeline for other editors."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.deliver.timeline import EXTRA_FORMATS, write_extra
from storyblender.errors import InputError
from storyblender.memory.base import scene_name
from storyblender.memory.jobs import ExportJob
from storyblender.pipeline.compiling import STORY, file_of
from storyblender.pipeline.delivery import timeline_media, warn_of_works_to_keep
from storyblender.pipeline.run import Run
from storyblender.pipeline.shown import note_shown

EXPORT = "export"


def export(run: Run, kinds: Sequence[str]) -> list[str]:
    """Write exchange files and return their names in the project.

    Args:
        run: With the story compiled.
        kinds: ``glb``, ``usd``, ``edl`` or ``fcpxml``.

    Raises:
        InputError: The project has no story.blend yet, or an adapter is missing.
    """
    files: list[str] = []
    for kind in kinds:
        if kind in EXTRA_FORMATS:
            files.append(f"timeline{EXTRA_FORMATS[kind]}")
            with run.delivering(files[-1]) as part:
                write_extra(timeline_media(run), part, kind)
        else:
            files += _export_scenes(run, kind)
    warn_of_works_to_keep(run, [name for name in files if name.startswith(f"{EXPORT}/")])
    for name in files:
        note_shown(run.outputs, run.graph, name)
    return files


def _export_scenes(run: Run, kind: str) -> list[str]:
    if not (run.project.folder / STORY).exists():
        raise InputError("has no story.blend yet", mend="run `storyblender make` first", path=run.project.folder)
    jobs = [
        ExportJob(
            story=file_of(run.graph, scene.scene_id),
            scene_id=scene.scene_id,
            format="glb" if kind == "glb" else "usd",
            out=f"{EXPORT}/{scene_name(scene.scene_id)}.{'glb' if kind == 'glb' else 'usdc'}",
        )
        for scene in run.graph.scenes
    ]
    for job in jobs:
        run.copy_aside_if_known(job.out)
    waiting = [run.engine.export_scene(job) for job in jobs]
    files: list[str] = []
    run.progress("export", 0, len(jobs), kind)
    for step, future in enumerate(waiting, start=1):
        files.append(future.result())
        run.outputs.note(files[-1])
        run.progress("export", step, len(jobs), files[-1])
    return files
