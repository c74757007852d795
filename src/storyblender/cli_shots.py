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
    no_args_is_help=True,
    rich_markup_mode="rich",
    help="Change the cut, write notes on shots and approve them; `undo` takes it back.",
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


Targets = Annotated[
    list[str],
    typer.Argument(metavar="NAME...", help="Shots (SC010_SH020) or scenes (SC010).", show_default=False),
]


@app.command(epilog=examples("shot omit my_film.storyboard SC010_SH020", "shot omit my_film.storyboard SC030"))
def omit(folder: Folder, names: Targets, draw: Draw = True, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Leave shots or scenes out of film, board and timeline; their numbers stay, as on a set, and nothing is lost."""
    _apply(folder, [{"kind": "omit", "target": name} for name in names], draw, quiet, json_lines)


@app.command(epilog=examples("shot restore my_film.storyboard SC010_SH020"))
def restore(folder: Folder, names: Targets, draw: Draw = True, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Bring back shots or scenes that were omitted."""
    _apply(folder, [{"kind": "restore", "target": name} for name in names], draw, quiet, json_lines)


@app.command(
    epilog=examples(
        "shot move my_film.storyboard SC010_SH040 --before SC010_SH020",
        "shot move my_film.storyboard SC020 --after SC030",
    )
)
def move(
    folder: Folder,
    name: Annotated[
        str, typer.Argument(metavar="NAME", help="A shot (SC010_SH020) or a scene (SC010).", show_default=False)
    ],
    before: Annotated[str | None, typer.Option(help="The shot or scene that it comes before.")] = None,
    after: Annotated[str | None, typer.Option(help="The shot or scene that it comes after.")] = None,
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Move a shot in its scene, or a scene in the film; names stay as they are, and no frame is drawn."""
    _apply(folder, [{"kind": "reorder", "target": name, "before": before, "after": after}], draw, quiet, json_lines)


def _apply(folder: Path, edits: list[dict[str, Any]], draw: bool, quiet: bool, json_lines: bool) -> None:
    """Apply edits as one batch, and show what they did."""
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import edits_of

        studio = open_studio(terminal, project=folder, animatic=False)
        applied, delivery = studio.edit(folder, edits_of(edits), draw=draw)
        terminal.applied(applied)
        if delivery is not None:
            terminal.files(delivery.folder, delivery.files)
