"""What the commands of several modules share: arguments, options, examples, and the studio they open."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from storyblender.errors import InputError
from storyblender.terminal import Terminal

if TYPE_CHECKING:
    from storyblender.engine.worker import Worker
    from storyblender.memory.edits import Edit
    from storyblender.studio import Studio

Folder = Annotated[
    Path, typer.Argument(metavar="FOLDER", help="A project folder, NAME.storyboard.", show_default=False)
]
LookOption = Annotated[
    str | None,
    typer.Option(
        help="How frames are drawn: board (lit and inked, the default), fast (quicker light), pencil, "
        "or render (Blender's Cycles, minutes a frame)."
    ),
]
Aspect = Annotated[str | None, typer.Option(help="Width over height of the picture: 2.39, 1.85, 16:9, 9:16 ...")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing but errors.")]
Json = Annotated[bool, typer.Option("--json", help="For programs: events, results and errors as JSON, one a line.")]
Jobs = Annotated[int | None, typer.Option(help="Blender processes; by default one for each processor, two at most.")]

Draw = Annotated[bool, typer.Option("--render/--no-render", help="Draw what changed at once.")]
Revision = Annotated[
    str | None, typer.Option(help="What you looked at, as --json told it; refused if that changed since.")
]

Services = Annotated[
    str | None,
    typer.Option(
        help="Where assets may come from beside your folders and the built-in library, with commas: poly_haven, "
        "sketchfab, an image model (openai, gemini) with what makes 3D models of images (hunyuan3d, trellis, meshy). "
        "Off by default."
    ),
]


def model_pose(sides: Sequence[str], **given: str | None) -> dict[str, str]:
    """Return which sides of a model were said to be its front and top, as an edit has them.

    Args:
        sides: That it may be.
        given: What stands behind ``--front`` and ``--top``; None where it was left out.

    Raises:
        InputError: It is no side.
    """
    pose = {option: side for option, side in given.items() if side}
    for option, side in pose.items():
        if side not in sides:
            mend = f"it is {', '.join(sides[:-1])} or {sides[-1]}"
            raise InputError(f"--{option} cannot be {side!r}", mend=mend)
    return pose


def examples(*lines: str) -> str:
    """Return what stands below the help of a command: one line each."""
    return "\n\n".join(["[bold]Examples[/bold]", *(f"  storyblender {line}" for line in lines)])


def open_studio(
    terminal: Terminal,
    script: Path | None = None,
    project: Path | None = None,
    ahead: Worker | None = None,
    **overrides: Any,
) -> Studio:
    """Open the studio. Imported here, because its crew takes a second to load and ``--help`` needs none of it.

    Args:
        terminal: Shows the events.
        script: The settings beside it are read.
        project: Its folder; without a script, the settings that it was made with are read.
        ahead: A Blender worker of the project that comes up already.
        overrides: Settings of the command line; None means not given.

    Raises:
        InputError: A setting is unknown or out of range.
    """
    from storyblender.settings import Settings
    from storyblender.studio import Studio

    return Studio(Settings.load(script, project, **overrides), terminal.show, ahead)


def edit_and_draw(
    context: typer.Context,
    terminal: Terminal,
    folder: Path,
    edits: Sequence[Edit],
    revision: str | None = None,
    *,
    draw: bool = True,
    look: str | None = None,
    jobs: int | None = None,
) -> None:
    """Apply edits to a project, draw what they made stale, and tell both.

    Args:
        context: Of the command; it holds the Blender worker that comes up already.
        terminal: Shows what was done.
        folder: The project.
        edits: In order; one undo takes all of them back.
        revision: What they were made on; None for the present one.
        draw: Whether to draw at once.
        look: How frames are drawn; None for as the project was made.
        jobs: Blender processes; None for the usual number.

    Raises:
        InputError: No such project, or an edit that cannot be.
        StaleEdit: What they touch has changed since that revision.
    """
    settings: dict[str, Any] = dict(look=look, jobs=jobs, animatic=False)
    studio = open_studio(terminal, project=folder, ahead=context.obj, **settings)
    applied, delivery = studio.edit(folder, edits, revision, draw=draw)
    terminal.applied(applied)
    if delivery is not None:
        terminal.files(delivery.folder, delivery.files, delivery.followed)
