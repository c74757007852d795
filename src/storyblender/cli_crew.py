"""The command for those who answer in place of a model: list what waits, check what was answered."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from storyblender.cli_options import Json, Quiet, examples
from storyblender.shell import shown

Asked = Annotated[
    Path, typer.Argument(metavar="FOLDER", help="The folder that `--crew ask:FOLDER` names.", show_default=False)
]


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(epilog=examples("answer questions"))(answer)


def answer(folder: Asked, quiet: Quiet = False, json_lines: Json = False) -> None:
    """List the requests of the crew that wait for an answer, and check the answers that are there.

    With `make SCRIPT --crew ask:FOLDER` each role of the crew writes what it asks into the folder: NAME.request.md, a
    page that any chat model or a person can answer, and the pictures that belong to it. Write the answer, JSON of the
    form that the page ends with, to NAME.answer.json beside it, and run `make` again: it goes on from there.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.language_crew import check_answers

        checked = check_answers(folder)
        terminal.answers(checked)
    if any(each.problem for each in checked):
        raise typer.Exit(1)
