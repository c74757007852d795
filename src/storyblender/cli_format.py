"""``storyblender format``: the shape of the picture, and the sensor that every lens of the film sees with."""

from __future__ import annotations

from typing import Annotated

import typer

from storyblender.cli_options import Aspect, Draw, Folder, Jobs, Json, LookOption, Quiet, edit_and_draw, examples
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        "format",
        epilog=examples(
            "format my_film.storyboard --aspect 2.39",
            "format my_film.storyboard --aspect 4:3 --sensor 'Super 16'",
            "format my_film.storyboard --sensor 24.9",
        ),
    )(format_command)


def format_command(
    context: typer.Context,
    folder: Folder,
    aspect: Aspect = None,
    sensor: Annotated[
        str | None, typer.Option(help="Its width in mm, or Super 16, Super 35, full frame, 65 mm film.")
    ] = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Give the film a picture of another shape, or another sensor; its cameras are set for it anew, and all is drawn.

    Cameras that you locked stay. It holds until you say otherwise, here or with `make --aspect`; `undo` takes it back.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import format_edit

        edit_and_draw(context, terminal, folder, [format_edit(aspect, sensor)], draw=draw, look=look, jobs=jobs)
