"""From the graph and the pictures to what people open: board, list, timeline, film, page, Blender file."""

from __future__ import annotations

import filecmp
from collections.abc import Mapping, Sequence
from pathlib import Path

from storyblender.deliver import slate
from storyblender.deliver.animatic import write_animatic
from storyblender.deliver.board import write_board
from storyblender.deliver.checklist import Check, checklist
from storyblender.deliver.contact_sheet import write_contact_sheets
from storyblender.deliver.page import write_page
from storyblender.deliver.panel import frame_of, panels
from storyblender.deliver.shot_list import write_shot_list
from storyblender.deliver.timeline import write_timeline
from storyblender.pipeline.compiling import Compilation
from storyblender.pipeline.prints import make_prints
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import shots_not_in_film
from storyblender.project import write_atomic
from storyblender.trace import Event

SEGMENTS = "build/film"
CLIPS = "clips"


def frame_paths(run: Run) -> dict[str, Path]:
    """Return shot name to frame, for the frames there are."""
    paths = {panel.name: run.project.folder / "frames" / f"{panel.name}.png" for panel in panels(run.graph)}
    return {name: path for name, path in paths.items() if path.exists()}


def clip_paths(run: Run) -> dict[str, Path]:
    """Return shot name to moving picture, for those there are: they show the shots as they are."""
    paths = {panel.name: run.project.folder / CLIPS / f"{panel.name}.mp4" for panel in panels(run.graph)}
    return {name: path for name, path in paths.items() if path.exists()}


def deliver(run: Run, clips: Mapping[str, Sequence[Path]] | None, story: Compilation) -> list[str]:
    """Write every deliverable; Blender compiles its file meanwhile.

    Args:
        run: With all frames drawn.
        clips: Shot name to moving frames; None where no film is wanted.
        story: The .blend; it is done before the page that links to it.

    Returns:
        Names of what was written, in the order people open them.
    """
    graph, folder = run.graph, run.project.folder
    frames = frame_paths(run)
    steps = 6
    run.progress("deliver", 0, steps, "board.pdf")
    prints = make_prints(run, _with_slates(run, frames) if run.settings.slate else frames)
    write_board(graph, prints.small, folder / "board.pdf")
    write_board(graph, prints.large, folder / "board_single.pdf", "single")
    run.progress("deliver", 2, steps, "shots.csv")
    write_shot_list(graph, folder / "shots.csv", run.settings.start_timecode)
    sheets = write_contact_sheets(prints.small, folder / "contact_sheet.jpg")
    run.progress("deliver", 3, steps, "animatic.mp4")
    film = folder / "animatic.mp4"
    if clips is not None and frames:
        kept = run.project.path(SEGMENTS)
        _place_clips(run, write_animatic(graph, clips, frames, film, kept, run.engine.processes))
    elif film.exists() and (stale := shots_not_in_film(run)):
        told = f"still shows {', '.join(stale)} as before; `storyblender render --animatic` shoots it again"
        run.tell(Event(kind="warning", role="animatic.mp4", message=told))
        _place_clips(run, {name: path for name, path in clip_paths(run).items() if name not in stale})
    write_timeline(graph, frames, clip_paths(run), folder / "timeline.otio", run.settings.start_timecode)
    run.progress("deliver", 5, steps, "story.blend")
    story.finish()
    write_page(graph, frames, folder / "index.html", checks_of(run), prints.small)
    run.progress("deliver", steps, steps)
    names = [
        "index.html", "story.blend", "frames/", "board.pdf", "board_single.pdf", *(sheet.name for sheet in sheets),
        "animatic.mp4", "animatic.srt", "clips/", "shots.csv", "timeline.otio", "graph.json",
    ]  # fmt: skip
    return [name for name in names if (folder / name).exists()]


def _place_clips(run: Run, clips: Mapping[str, Path]) -> None:
    """Give the shots of the film their names for editors, and take away those of shots that look otherwise now."""
    names = {f"{CLIPS}/{name}.mp4": path for name, path in clips.items()}
    for name, path in names.items():
        target = run.project.path(name)
        if target != path and not (target.exists() and filecmp.cmp(path, target, shallow=False)):
            write_atomic(target, path.read_bytes())
    for path in run.project.path(CLIPS).glob("SC*_SH*.mp4"):
        if f"{CLIPS}/{path.name}" not in names:
            path.unlink()


def checks_of(run: Run) -> list[Check]:
    """Return what a person should check: unsure readings, staging problems, pictures with flaws."""
    staged = [flaw for _, pack in sorted(run.packs.items()) for flaw in pack.problems]
    return checklist(run.graph, staged, run.project.folder.name)


def _with_slates(run: Run, frames: Mapping[str, Path]) -> dict[str, Path]:
    slated = {}
    first = frame_of(run.settings.start_timecode, run.graph.format.fps)
    for panel in panels(run.graph):
        if panel.name in frames:
            slated[panel.name] = run.project.path("frames", f"slate_{panel.name}.png")
            slate.burn_in(frames[panel.name], panel, slated[panel.name], first)
    return slated
