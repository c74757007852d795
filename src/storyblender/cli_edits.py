"""The commands that change a finished project: edit, place, instruct, lock, unlock, undo, redo."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from storyblender.cli_options import (
    Draw,
    Folder,
    Jobs,
    Json,
    LookOption,
    Quiet,
    Revision,
    edit_and_draw,
    examples,
    open_studio,
)
from storyblender.errors import InputError
from storyblender.shell import shown

Names = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="SHOT...", help="Shots, such as SC010_SH020; one change for all of them.", show_default=False
    ),
]
Targets = Annotated[
    list[str],
    typer.Argument(
        metavar="NAME...", help="Shots (SC010_SH020), scenes (SC010), or ids of people and things.", show_default=False
    ),
]
Parts = Annotated[
    list[str] | None,
    typer.Option(
        "--part",
        help="Only this: camera, blocking or duration of a shot; layout, light or set of a scene. May be repeated.",
    ),
]
_SIZES = "How much is seen, from extreme wide to extreme close-up: EWS WS FS MWS MS MCU CU ECU."


def add_to(app: typer.Typer) -> None:
    """Add the commands to the command line."""
    app.command(
        epilog=examples(
            "edit my_film.storyboard SC010_SH020 --size CU --lens 85",
            'edit my_film.storyboard SC010_SH020 --move "push in" --seconds 4',
            "edit my_film.storyboard SC010_SH020 --f-number 2 --focus ilsa --focus-to rick",
            "edit my_film.storyboard SC010_SH020 --kind ots --on ilsa --over rick",
            "edit my_film.storyboard SC010_SH020 --at 2,-3,1.6 --look-at 0,0,1.4 --to 1,-2,1.6",
            "edit my_film.storyboard --batch edits.json",
        )
    )(edit)
    app.command(
        epilog=examples(
            "place my_film.storyboard SC010 armchair --at 1.2,0.5 --turn 90",
            "place my_film.storyboard SC010 letter --at -0.8,1.1 --height 0.75",
            "place my_film.storyboard SC010_SH020 rick --at 1,2 --turn 45 --to -1,0.5",
            "place my_film.storyboard SC010_SH020 rick --via 0,1.5 --via -0.5,1",
        )
    )(place)
    app.command(
        epilog=examples(
            'instruct my_film.storyboard "SC010_SH020: closer, shallow focus"',
            'instruct my_film.storyboard "SC010: 35 mm, low angle"',
            'instruct my_film.storyboard "SC010: warmer, after sunset"',
            'instruct my_film.storyboard "SC010: replace the sofa by a red bench"',
            'instruct my_film.storyboard "SC010_SH020: lonelier, as if the room had grown" --crew google',
        )
    )(instruct)
    app.command(
        epilog=examples("lock my_film.storyboard SC010_SH020 --part camera", "lock my_film.storyboard SC010 rick")
    )(lock)
    app.command(epilog=examples("unlock my_film.storyboard SC010_SH020 --part camera"))(unlock)
    app.command()(undo)
    app.command()(redo)


def edit(
    context: typer.Context,
    folder: Folder,
    shots: Names = None,
    size: Annotated[str | None, typer.Option(help=_SIZES)] = None,
    angle: Annotated[str | None, typer.Option(help="eye-level, high angle, low angle, bird's-eye, dutch ...")] = None,
    lens: Annotated[float | None, typer.Option(help="Focal length in mm: 24 is wide, 85 is long.")] = None,
    move: Annotated[str | None, typer.Option(help="Camera move: static, pan left, tilt up, push in ...")] = None,
    kind: Annotated[
        str | None, typer.Option(help="Kind of picture: single, two-shot, group, ots, pov, insert, establishing ...")
    ] = None,
    on: Annotated[list[str] | None, typer.Option("--on", help="Who or what it shows; may be repeated.")] = None,
    over: Annotated[str | None, typer.Option(help="Over whose shoulder (kind ots).")] = None,
    pov: Annotated[str | None, typer.Option(help="Through whose eyes (kind pov).")] = None,
    f_number: Annotated[float | None, typer.Option(help="2 blurs the background, 32 keeps nearly all sharp.")] = None,
    focus: Annotated[str | None, typer.Option(help="Who or what is sharp.")] = None,
    focus_to: Annotated[str | None, typer.Option(help="Rack focus: who or what is sharp at the end.")] = None,
    at: Annotated[str | None, typer.Option(help="Place the camera yourself: X,Y,Z in metres, Z up.")] = None,
    look_at: Annotated[str | None, typer.Option(help="What a placed camera looks at: X,Y,Z.")] = None,
    to: Annotated[str | None, typer.Option(help="Where a placed camera travels: X,Y,Z.")] = None,
    to_look_at: Annotated[str | None, typer.Option(help="What it looks at there; as before if not given.")] = None,
    seconds: Annotated[float | None, typer.Option(help="Length of the shot in seconds.")] = None,
    frames: Annotated[int | None, typer.Option(help="Length of the shot in frames.")] = None,
    batch: Annotated[
        Path | None, typer.Option(help="A JSON list of edits (docs/edits.md) instead; - reads it from standard input.")
    ] = None,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Change the camera or the length of shots, and draw again what that changes. The crew keeps to what you set.

    `unlock` gives it back to the crew; `undo` takes the whole command back.
    """
    words: dict[str, Any] = {
        "size": size, "angle": angle, "lens": lens, "movement": move, "kind": kind, "focus_on_ids": on or None,
        "over_id": over, "pov_id": pov, "f_number": f_number, "focus": focus, "focus_to": focus_to,
    }  # fmt: skip
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import camera_decision, placed_camera, read_edits
        from storyblender.memory.edits import CameraEdit, DurationEdit, Edit

        said = {name: value for name, value in words.items() if value is not None}
        if at or look_at or to or to_look_at:
            said["placed"] = placed_camera(at, look_at, to, to_look_at)
        edits: list[Edit] = list(read_edits(batch)) if batch is not None else []
        decision = camera_decision(said)
        for shot in shots or []:
            edits += [CameraEdit(shot=shot, decision=decision)] if said else []
            if seconds is not None or frames is not None:
                edits.append(DurationEdit(shot=shot, seconds=seconds, frames=None if seconds is not None else frames))
        if not edits:
            raise InputError("there is nothing to change", mend="see `storyblender edit --help`")
        edit_and_draw(context, terminal, folder, edits, revision, draw=draw, look=look, jobs=jobs)


def place(
    context: typer.Context,
    folder: Folder,
    where: Annotated[
        str, typer.Argument(metavar="WHERE", help="SC010 for a thing, SC010_SH020 for a person.", show_default=False)
    ],
    what: Annotated[str, typer.Argument(metavar="WHAT", help="The thing or the person.", show_default=False)],
    at: Annotated[str | None, typer.Option(help="Floor point X,Y in metres; of a person as the shot begins.")] = None,
    turn: Annotated[float | None, typer.Option(help="Degrees counter-clockwise; 0 faces -Y, the audience.")] = None,
    height: Annotated[
        float | None, typer.Option(help="Of a thing: metres above the floor; otherwise it is dropped on what is below.")
    ] = None,
    scale: Annotated[float | None, typer.Option(help="Factor on the size of a thing, in all its scenes.")] = None,
    to: Annotated[str | None, typer.Option(help="Where a person ends the shot: X,Y; they walk there.")] = None,
    to_turn: Annotated[float | None, typer.Option(help="Degrees that a person faces at the end.")] = None,
    via: Annotated[
        list[str] | None, typer.Option(help="X,Y that a person walks through; may be repeated. `crew` frees the way.")
    ] = None,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Move, turn or scale a thing of a scene, or set where a person stands in a shot, and draw again what that changes.

    What stands on a thing goes with it. The crew keeps to it; `unlock` gives it back, `undo` takes it back.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import place_edit

        edit = place_edit(where, what, (at, turn), (to, to_turn), height, scale, via=via)
        edit_and_draw(context, terminal, folder, [edit], revision, draw=draw, look=look, jobs=jobs)


def instruct(
    context: typer.Context,
    folder: Folder,
    words: Annotated[
        str,
        typer.Argument(
            metavar="WORDS",
            help='Shots or scenes and what you want: "SC010_SH020: closer", "all: warmer".',
            show_default=False,
        ),
    ],
    crew: Annotated[str | None, typer.Option(help="Who understands it: rules, or a model as for `make`.")] = None,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Say in words what to change of cameras, lengths, light, sets and things; only what that changes is drawn.

    Rules know the words that film people use (docs/edits.md lists them); a language model knows the rest.
    """
    with shown(quiet, json_lines) as terminal:
        settings: dict[str, Any] = dict(crew=crew, look=look, jobs=jobs, animatic=False)
        studio = open_studio(terminal, project=folder, ahead=context.obj, **settings)
        applied, delivery = studio.instruct(folder, words, revision, draw=draw)
        terminal.applied(applied)
        if delivery is not None:
            terminal.files(delivery.folder, delivery.files, delivery.followed)


def lock(folder: Folder, names: Targets, part: Parts = None, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Keep shots, scenes, people or things as they are: neither the crew nor an edit changes what is locked."""
    _lock_or_unlock("lock", folder, names, part or [], quiet, json_lines)


def unlock(folder: Folder, names: Targets, part: Parts = None, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Lift locks, and give back to the crew what you set with `edit`. Nothing changes until the crew works on it."""
    _lock_or_unlock("unlock", folder, names, part or [], quiet, json_lines)


def _lock_or_unlock(kind: str, folder: Path, names: list[str], parts: list[str], quiet: bool, json_lines: bool) -> None:
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import edits_of

        edits = edits_of([{"kind": kind, "target": name, "parts": parts} for name in names])
        applied, _ = open_studio(terminal).edit(folder, edits, draw=False)
        terminal.applied(applied)


def undo(folder: Folder, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Take back the last change of a project. `render` then draws only what that changes."""
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal)
        terminal.commits("undone", studio.undo(folder))


def redo(folder: Folder, quiet: Quiet = False, json_lines: Json = False) -> None:
    """Make the change again that was undone last."""
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal)
        terminal.commits("redone", studio.redo(folder))
