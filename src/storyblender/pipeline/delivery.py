"""From the graph and the pictures to what people open: board, list, timeline, film, page, Blender file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from storyblender.deliver import slate
from storyblender.deliver.animatic import film_segments, write_animatic, write_subtitles
from storyblender.deliver.asset_list import ASSETS_FILE, write_asset_list
from storyblender.deliver.board import write_board
from storyblender.deliver.checklist import CHECKLIST_FILE, Check, checklist, write_checklist
from storyblender.deliver.contact_sheet import sheet_name, sheet_pages, shown_by, write_contact_sheet
from storyblender.deliver.credits import CREDITS_FILE, credited_works, says_what_to_keep, works_to_keep, write_credits
from storyblender.deliver.page import write_page
from storyblender.deliver.panel import frame_of, panels
from storyblender.deliver.segments import encode_segments
from storyblender.deliver.shot_list import write_shot_list
from storyblender.deliver.timeline import write_timeline
from storyblender.deliver.timeline_media import TimelineMedia
from storyblender.memory.base import content_hash
from storyblender.memory.shot_context import Flaw
from storyblender.pipeline.compiling import Compilation
from storyblender.pipeline.filming import with_cuts_judged
from storyblender.pipeline.prints import Prints, make_prints
from storyblender.pipeline.reviewing import kept_reviews
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import FILM_RECORD, cut_record, shots_not_in_film
from storyblender.pipeline.shown import FILM, note_old, note_shown
from storyblender.trace import Event

CLIPS = "clips"
BOARD, BOARD_SINGLE = "board.pdf", "board_single.pdf"
SMALL_PANELS = 6
"""Panels on a page from which small prints are sharp enough."""


def frame_paths(run: Run) -> dict[str, Path]:
    """Return shot name to frame, for the frames there are."""
    paths = {panel.name: run.project.folder / "frames" / f"{panel.name}.png" for panel in panels(run.graph)}
    return {name: path for name, path in paths.items() if path.exists()}


def clip_paths(run: Run) -> dict[str, Path]:
    """Return shot name to moving picture, for those there are: they show the shots as they are."""
    paths = {panel.name: run.project.folder / CLIPS / f"{panel.name}.mp4" for panel in panels(run.graph)}
    return {name: path for name, path in paths.items() if path.exists()}


def timeline_media(run: Run) -> TimelineMedia:
    """Return what the timeline formats are written from."""
    return TimelineMedia(run.graph, frame_paths(run), clip_paths(run), run.project.folder, run.settings.start_timecode)


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
    run.progress("deliver", 0, steps, BOARD)
    prints = write_boards(run, frames)
    run.progress("deliver", 2, steps, "shots.csv")
    with run.delivering("shots.csv") as part:
        write_shot_list(graph, part, run.settings.start_timecode)
    with run.delivering(ASSETS_FILE) as part:
        write_asset_list(graph, part)
    checks = checks_of(run)
    with run.delivering(CHECKLIST_FILE) as part:
        write_checklist(checks, part)
    if not says_what_to_keep(graph, folder / CREDITS_FILE):
        warn_of_works_to_keep(run, ["story.blend"])
    if credited_works(graph):
        with run.delivering(CREDITS_FILE) as part:
            write_credits(graph, part)
    else:
        run.outputs.keep_only(CREDITS_FILE, ())
    sheets = _contact_sheets(run, prints.small)
    run.progress("deliver", 3, steps, FILM)
    film = folder / FILM
    if clips is not None and frames:
        segments = encode_segments(
            film_segments(graph, clips, frames),
            run.project.files,
            run.outputs,
            run.engine.processes,
            lambda done, of: run.progress("encode", done, of),
        )
        with run.delivering(FILM) as part:
            write_animatic(graph, segments, part)
        with run.delivering("animatic.srt") as part:
            write_subtitles(graph, part)
        run.outputs.write(FILM_RECORD, cut_record(run))
        note_shown(run.outputs, graph, FILM)
        _place_clips(run, {panel.name: path for panel, path in zip(panels(graph), segments, strict=True)})
    elif film.exists() and (stale := shots_not_in_film(run)):
        told = f"still shows {', '.join(stale)} as before; `storyblender render --animatic` shoots it again"
        run.tell(Event(kind="warning", role="delivery", subject=FILM, message=told))
        note_old(run.outputs, FILM)
        _place_clips(run, {name: path for name, path in clip_paths(run).items() if name not in stale})
    elif film.exists():
        note_shown(run.outputs, graph, FILM)
    with run.delivering("timeline.otio") as part:
        write_timeline(timeline_media(run), part)
    run.progress("deliver", 5, steps, "story.blend")
    story.finish()
    with run.delivering("index.html") as part:
        write_page(graph, frames, part, folder, checks, prints.small)
    run.progress("deliver", steps, steps)
    names = [
        "index.html", "story.blend", "story/", "frames/", BOARD, BOARD_SINGLE, *sheets,
        FILM, "animatic.srt", "clips/", "shots.csv", ASSETS_FILE, CHECKLIST_FILE, CREDITS_FILE, "timeline.otio",
        "graph.json",
    ]  # fmt: skip
    return [name for name in names if (folder / name).exists()]


def warn_of_works_to_keep(run: Run, files: Sequence[str]) -> None:
    """Say in one sentence which works in files with models must not be passed on.

    Args:
        run: Its story has the works.
        files: Names in the project that hold models.
    """
    works = works_to_keep(run.graph)
    if not works or not files:
        return
    told = ", ".join(f"{' and '.join(names)} ({work.license}, {work.author})" for work, names in works.items())
    message = f"keep {', '.join(files)} to yourself: the licence forbids passing on the models in it of {told}"
    run.tell(Event(kind="warning", role="delivery", message=f"{message}; frames, board and film are free"))


def write_boards(run: Run, frames: Mapping[str, Path]) -> Prints:
    """Write the board in the layout of the settings, and with one panel a page; return the prints in it.

    Args:
        run: The run.
        frames: Shot name to picture.
    """
    prints = make_prints(run, _with_slates(run, frames) if run.settings.slate else frames)
    layout = run.settings.board_layout
    pictures = prints.small if layout.panels >= SMALL_PANELS else prints.large
    with run.delivering(BOARD) as part:
        write_board(run.graph, pictures, part, layout)
    with run.delivering(BOARD_SINGLE) as part:
        write_board(run.graph, prints.large, part, layout.model_copy(update={"panels": 1}))
    return prints


def _place_clips(run: Run, clips: Mapping[str, Path]) -> None:
    """Give the shots of the film their names for editors, and take away those of shots that look otherwise now."""
    names = {f"{CLIPS}/{name}.mp4": path for name, path in clips.items()}
    for name, path in names.items():
        segment = run.project.files.name_of(path)
        if name != segment:
            run.place(segment, name)
    run.outputs.keep_only(f"{CLIPS}/", names)


def checks_of(run: Run) -> list[Check]:
    """Return what a person should check: unsure readings, staging problems, pictures with flaws."""
    staged = [flaw for _, pack in sorted(run.packs.items()) for flaw in pack.problems]
    poor = [review for review in kept_reviews(run, run.graph.cut).values() if review.verdict != "pass"]
    faults = [
        Flaw(kind=fault.kind, subject=fault.subject, weight=fault.severity, message=fault.message, shot=review.shot)
        for review in poor
        for fault in review.faults
    ]
    return checklist(with_cuts_judged(run), staged, faults, run.project.folder.name)


def _with_slates(run: Run, frames: Mapping[str, Path]) -> dict[str, Path]:
    slated = {}
    first = frame_of(run.settings.start_timecode, run.graph.format.fps)
    for panel in panels(run.graph):
        if panel.name in frames:
            name = f"frames/slate_{panel.name}.png"
            with run.delivering(name) as part:
                slate.burn_in(frames[panel.name], panel, part, first)
            slated[panel.name] = run.project.path(name)
    return slated


def _contact_sheets(run: Run, frames: Mapping[str, Path]) -> list[str]:
    """Write the contact sheets that show something new, delete those that a longer story had, and return all names."""
    names: list[str] = []
    for number, page in enumerate(sheet_pages(frames), start=1):
        names.append(sheet_name(number))
        shows = content_hash({name: run.outputs.digest(run.project.files.name_of(path)) for name, path in page.items()})
        if run.outputs.whole(names[-1]) and shown_by(run.project.path(names[-1])) == shows:
            continue
        with run.delivering(names[-1]) as part:
            write_contact_sheet(page, part, shows)
    run.outputs.keep_only("contact_sheet", names)
    return names
