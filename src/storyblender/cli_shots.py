"""``storyblender shot``: the commands that change the cut, write notes and approve; each is one edit for each name."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from storyblender.cli_options import Folder, Json, Quiet, examples, open_studio
from storyblender.shell import shown

Shot = Annotated[str, typer.Argument(metavar="SHOT", help="A shot, such as SC010_SH020.", show_default=False)]
Shots = Annotated[list[str], typer.Argument(metavar="SHOT...", help="Shots, such as SC010_SH020.", show_default=False)]
Draw = Annotated[
    bool, typer.Option("--render/--no-render", help="Draw what changed at once, and write board, lists and page anew.")
]
app = typer.Typer(
    no_args_is_help=True, rich_markup_mode="rich", help="Write notes on shots and approve them; `undo` takes it back."
)


@app.command(
    epilog=examples(
        'shot note my_film.storyboard SC010_SH020 "Too slow, cut on the look" --author Ilsa',
        "shot note my_film.storyboard SC010_SH020 --resolve 1",
    )
)
def note(
    folder: Folder,
    shot: Shot,
    text: Annotated[str | None, typer.Argument(metavar="TEXT", help="The note.", show_default=False)] = None,
    author: Annotated[str, typer.Option(help="Who writes it.")] = "",
    resolve: Annotated[int | None, typer.Option(help="Number of a note that is done.")] = None,
    reopen: Annotated[int | None, typer.Option(help="Number of a note that is not done after all.")] = None,
    remove: Annotated[int | None, typer.Option(help="Number of a note to take away.")] = None,
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Write a note on a shot, or say that one is done; board, page and shot list show it."""
    done = {"resolve": resolve, "reopen": reopen, "remove": remove}
    edits: list[dict[str, Any]] = [
        {"action": action, "number": number} for action, number in done.items() if number is not None
    ]
    if text is not None or not edits:
        edits.append({"text": text, "author": author})
    _apply(folder, [{"kind": "note", "shot": shot, **each} for each in edits], draw, quiet, json_lines)


@app.command(
    epilog=examples(
        "shot approve my_film.storyboard SC010_SH010 SC010_SH020",
        "shot approve my_film.storyboard SC010_SH020 --withdraw",
    )
)
def approve(
    folder: Folder,
    shots: Shots,
    withdraw: Annotated[bool, typer.Option("--withdraw", help="Withdraw the approval instead.")] = False,
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Approve shots: all of them is locked, and marked on board, page and shot list."""
    edits = [{"kind": "approve", "shot": shot, "approved": not withdraw} for shot in shots]
    _apply(folder, edits, draw, quiet, json_lines)


def _apply(folder: Path, edits: list[dict[str, Any]], draw: bool, quiet: bool, json_lines: bool) -> None:
    """Apply edits as one batch, and show what they did."""
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import edits_of

        studio = open_studio(terminal, project=folder, animatic=False)
        applied, delivery = studio.edit(folder, edits_of(edits), draw=draw)
        terminal.applied(applied)
        if delivery is not None:
            terminal.files(delivery.folder, delivery.files)
