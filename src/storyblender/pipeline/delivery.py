"""From the graph and the pictures to what people open: board, list, timeline, film, page, Blender file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from pathlib import Path

from storyblender.deliver import slate
from storyblender.deliver.animatic import write_animatic
from storyblender.deliver.board import write_board
from storyblender.deliver.checklist import Check, checklist
from storyblender.deliver.contact_sheet import write_contact_sheet
from storyblender.deliver.page import write_page
from storyblender.deliver.panel import panels
from storyblender.deliver.shot_list import write_shot_list
from storyblender.deliver.timeline import write_timeline
from storyblender.memory.jobs import StoryJob
from storyblender.pipeline.run import Run


def compile_blend(run: Run) -> Future[str]:
    """Start compiling ``story.blend``; it needs the frames' lights, so it comes after them."""
    graph = run.graph
    return run.engine.compile_story(
        StoryJob(
            title=graph.title,
            format=graph.format,
            outline=graph.outline,
            assets=graph.assets,
            scenes=graph.scenes,
            shots=graph.shots,
            packs=tuple(run.packs[scene.scene_id] for scene in graph.scenes if scene.scene_id in run.packs),
            out="story.blend",
        )
    )


def frame_paths(run: Run) -> dict[str, Path]:
    """Return shot name to frame, for the frames there are."""
    paths = {panel.name: run.project.folder / "frames" / f"{panel.name}.png" for panel in panels(run.graph)}
    return {name: path for name, path in paths.items() if path.exists()}


def deliver(run: Run, clips: Mapping[str, Sequence[Path]] | None) -> list[str]:
    """Write every deliverable.

    Args:
        run: With all frames drawn.
        clips: Shot name to moving frames; None where no film is wanted.

    Returns:
        Names of what was written, in the order people open them.
    """
    graph, folder = run.graph, run.project.folder
    frames = frame_paths(run)
    steps = 6
    run.progress("deliver", 0, steps, "board.pdf")
    shown = _with_slates(run, frames) if run.settings.slate else frames
    write_board(graph, shown, folder / "board.pdf")
    write_board(graph, shown, folder / "board_single.pdf", "single")
    run.progress("deliver", 2, steps, "shots.csv")
    write_shot_list(graph, folder / "shots.csv")
    write_timeline(graph, frames, folder / "timeline.otio")
    write_contact_sheet(frames, folder / "contact_sheet.jpg")
    run.progress("deliver", 3, steps, "animatic.mp4")
    if clips is not None and frames:
        write_animatic(graph, clips, frames, folder / "animatic.mp4")
    run.progress("deliver", 5, steps, "index.html")
    write_page(graph, frames, folder / "index.html", checks_of(run))
    run.progress("deliver", steps, steps)
    names = [
        "index.html", "story.blend", "frames/", "board.pdf", "board_single.pdf", "contact_sheet.jpg", "animatic.mp4",
        "animatic.srt", "shots.csv", "timeline.otio", "graph.json",
    ]  # fmt: skip
    return [name for name in names if (folder / name).exists()]


def checks_of(run: Run) -> list[Check]:
    """Return what a person should check: unsure readings, staging problems, pictures with flaws."""
    staged = [flaw for _, pack in sorted(run.packs.items()) for flaw in pack.problems]
    return checklist(run.graph, staged, run.project.folder.name)


def _with_slates(run: Run, frames: Mapping[str, Path]) -> dict[str, Path]:
    slated = {}
    for panel in panels(run.graph):
        if panel.name in frames:
            slated[panel.name] = run.project.path("frames", f"slate_{panel.name}.png")
            slate.burn_in(frames[panel.name], panel, slated[panel.name])
    return slated
