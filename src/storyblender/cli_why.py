"""The command that says why a shot is as it is."""

from __future__ import annotations

from typing import Annotated

import typer

from storyblender.cli_options import Folder, Json, Quiet, examples, open_studio
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(epilog=examples("why my_film.storyboard SC010_SH020"))(why)


def why(
    folder: Folder,
    shot: Annotated[str, typer.Argument(metavar="SHOT", help="A shot, such as SC010_SH020.", show_default=False)],
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Say why a shot is as it is: who decided what, how it was judged, and what was taken from which words."""
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal, None, folder)
        with studio.open(folder) as session:
            terminal.shot_reasons(session.why(shot))
