"""``storyblender shot``: the commands that list shots, change the cut, write notes and approve."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from storyblender.cli_options import Folder, Json, Quiet, examples, open_studio
from storyblender.shell import shown

if TYPE_CHECKING:
    from storyblender.web_studio.messages import PanelCard

Shot = Annotated[str, typer.Argument(metavar="SHOT", help="A shot, such as SC010_SH020.", show_default=False)]
Shots = Annotated[list[str], typer.Argument(metavar="SHOT...", help="Shots, such as SC010_SH020.", show_default=False)]
Draw = Annotated[
    bool, typer.Option("--render/--no-render", help="Draw what changed at once, and write board, lists and page anew.")
]
app = typer.Typer(
    no_args_is_help=True,
    rich_markup_mode="rich",
    help="List shots, change the cut, write notes and approve; `undo` takes it back.",
)


@app.command(name="list", epilog=examples("shot list my_film.storyboard"))
def list_shots(folder: Folder, json_lines: Json = False) -> None:
    """List all shots with what you should know of them: stale, omitted, locked, approved, notes, takes, what to check.

    `--json` tells all of every shot, as the studio's board and inspector show it.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.deliver.panel import panels
        from storyblender.web_studio.board import board_of
        from storyblender.workplace.values import details_of

        with open_studio(terminal, project=folder).open(folder) as session:
            stale = session.stale_frames() if session.made and not session.delivered else []
            board = board_of(session, stale, {})
            shots = [details_of(panel, session.graph) for panel in panels(session.graph, with_omitted=True)]
        if json_lines:
            told = {"board": board.model_dump(mode="json"), "shots": [shot.model_dump(mode="json") for shot in shots]}
            typer.echo(json.dumps(told))
            return
        for card in (card for scene in board.scenes for card in scene.shots):
            typer.echo(f"{card.shot}  {card.seconds:5.1f} s  {card.facts:44}  {', '.join(_known_of(card))}".rstrip())


def _known_of(card: PanelCard) -> list[str]:
    """Return what a person should know of a shot, a word or two each."""
    counted = {"note": card.notes, "take": card.takes if card.takes > 1 else 0}
    said = {"not drawn": card.state == "none", "stale": card.state == "stale", "omitted": card.omitted}
    said |= {"approved": card.approved, "locked": card.locked and not card.approved}
    words = [word for word, holds in said.items() if holds]
    words += [f"{n} {word}{'s' if n > 1 else ''}" for word, n in counted.items() if n]
    return words + ([f"{card.problems} to check"] if card.problems else [])


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
        "shot take my_film.storyboard SC010_SH020",
        "shot take my_film.storyboard SC010_SH020 --of blocking --choose 1",
        "shot take my_film.storyboard SC010 --of layout",
    )
)
def take(
    folder: Folder,
    shot: Annotated[
        str,
        typer.Argument(
            metavar="SHOT", help="A shot; for a layout the scene, such as SC010, or a shot of it.", show_default=False
        ),
    ],
    of: Annotated[str, typer.Option(help="camera, blocking (where people are, what they do) or layout.")] = "camera",
    choose: Annotated[int | None, typer.Option(help="Number of the take that the film is to show.")] = None,
    drop: Annotated[int | None, typer.Option(help="Number of a take to drop.")] = None,
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Keep camera, blocking or layout as a take and go on with the next one; or choose a take, or drop one."""
    done = {"choose": choose, "drop": drop}
    edits = [{"action": action, "number": number} for action, number in done.items() if number is not None]
    takes = [{"kind": "take", "shot": shot, "of": of, **each} for each in edits or [{"action": "keep"}]]
    _apply(folder, takes, draw, quiet, json_lines)


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


@app.command(
    epilog=examples(
        "shot split my_film.storyboard SC010_SH020 --line 2", "shot split my_film.storyboard SC010_SH020 --seconds 1.5"
    )
)
def split(
    folder: Folder,
    shot: Shot,
    line: Annotated[int | None, typer.Option(help="Number of the line that the second shot begins with.")] = None,
    seconds: Annotated[float | None, typer.Option(help="Seconds from the start of the shot.")] = None,
    frames: Annotated[int | None, typer.Option(help="Frames from the start of the shot.")] = None,
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Split a shot in two; the second gets a number in between and begins with the same camera."""
    edit = {"kind": "split", "shot": shot, "line": line, "seconds": seconds, "frames": frames}
    _apply(folder, [edit], draw, quiet, json_lines)


@app.command(epilog=examples("shot join my_film.storyboard SC010_SH020 SC010_SH030"))
def join(
    folder: Folder,
    shot: Shot,
    other: Annotated[str, typer.Argument(metavar="OTHER", help="The shot before or after it.", show_default=False)],
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Join two neighbours of one scene: the first goes on for the time of the second, with its own camera."""
    _apply(folder, [{"kind": "join", "shot": shot, "other": other}], draw, quiet, json_lines)


@app.command(
    epilog=examples(
        "shot add my_film.storyboard SC010_SH020 --size CU --on Ilsa",
        "shot add my_film.storyboard SC010_SH020 --kind insert --on letter --seconds 1.5",
    )
)
def add(
    folder: Folder,
    shot: Shot,
    on: Annotated[list[str] | None, typer.Option(help="Whom or what it shows; may be given again.")] = None,
    kind: Annotated[str | None, typer.Option(help="Kind of picture: single, insert, reaction ...")] = None,
    size: Annotated[str | None, typer.Option(help="How much is seen: EWS WS FS MWS MS MCU CU ECU.")] = None,
    angle: Annotated[str | None, typer.Option(help="eye-level, high angle, low angle ...")] = None,
    at: Annotated[float | None, typer.Option(help="Seconds from the start of SHOT at which it begins.")] = None,
    seconds: Annotated[float | None, typer.Option(help="Length; 2 if left out.")] = None,
    draw: Draw = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Add a shot after another one: a further camera on the same moment, such as an insert or a reaction."""
    said = {"focus_on_ids": on, "kind": kind, "size": size, "angle": angle}
    words = {field: word for field, word in said.items() if word}
    edit = {"kind": "add_shot", "shot": shot, "decision": words, "at": at, "seconds": seconds}
    _apply(folder, [edit], draw, quiet, json_lines)


def _apply(folder: Path, edits: list[dict[str, Any]], draw: bool, quiet: bool, json_lines: bool) -> None:
    """Apply edits as one batch, and show what they did; a decision is given as a person words it."""
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import camera_decision, edits_of

        edits = [
            {key: camera_decision(value) if key == "decision" else value for key, value in each.items()}
            for each in edits
        ]
        studio = open_studio(terminal, project=folder, animatic=False)
        applied, delivery = studio.edit(folder, edits_of(edits), draw=draw)
        terminal.applied(applied)
        if delivery is not None:
            terminal.files(delivery.folder, delivery.files, delivery.followed)
