"""``storyblender board``: the board as PDF, with another layout of its pages."""

from __future__ import annotations

from typing import Annotated

import typer

from storyblender.cli_options import Folder, Jobs, Json, Quiet, examples, open_studio
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "board my_film.storyboard --panels 4",
            "board my_film.storyboard --panels 9 --paper a3 --orientation portrait",
        )
    )(board)


def board(
    context: typer.Context,
    folder: Folder,
    panels: Annotated[int | None, typer.Option(help="Panels on a page: 1, 2, 3, 4, 6, 9 or 12.")] = None,
    paper: Annotated[str | None, typer.Option(help="a4, letter, a3, legal or tabloid.")] = None,
    orientation: Annotated[str | None, typer.Option(help="landscape or portrait.")] = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Write the board anew, board.pdf, in another layout; the project keeps it for the next time.

    What is left out stays as it is. Shots that look otherwise than their frames are drawn first.
    """
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(
            terminal, project=folder, ahead=context.obj, panels=panels, paper=paper, orientation=orientation, jobs=jobs
        )
        delivery = studio.print_board(folder)
        terminal.files(delivery.folder, delivery.files)
