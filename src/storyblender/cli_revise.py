"""The command that takes over a revised script, and first says what it would change."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from storyblender.cli_options import Folder, Json, Quiet, examples, open_studio
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    epilog = examples(
        "revise my_film.storyboard my_film_v2.fountain", "revise my_film.storyboard my_film_v2.fountain --apply"
    )
    app.command(epilog=epilog)(revise)


def revise(
    folder: Folder,
    script: Annotated[Path, typer.Argument(metavar="SCRIPT", help="The revised script.", show_default=False)],
    apply: Annotated[bool, typer.Option("--apply", help="Take it over, and make what it changes.")] = False,
    reading: Annotated[Path | None, typer.Option(help="A reading of it that you corrected.")] = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """List the shots that a revised script makes new, changes, moves or omits; with --apply, take it over.

    What you decided stays with the words of its shot, and what cannot stay is listed. `undo` takes a revision back.
    """
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal, script, folder)
        with studio.open(folder) as session:
            terminal.changes(session.compare(script, reading))
            if apply:
                delivery = session.make(script, reading)
                terminal.files(delivery.folder, delivery.files)
