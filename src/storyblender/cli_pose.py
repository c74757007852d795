"""``storyblender pose``, ``motion``, ``line``: how a person is in a shot, what they do, and when they say a line."""

from __future__ import annotations

from typing import Annotated

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
)
from storyblender.errors import InputError
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the commands to the command line."""
    app.command(
        epilog=examples(
            "pose my_film.storyboard SC010_SH020 rick --posture sit --on sofa",
            "pose my_film.storyboard SC010_SH020 rick --look-at letter --hold glass --at-end",
            "pose my_film.storyboard SC010_SH020 ilsa --posture stand --empty-hands",
        )
    )(pose)
    app.command(
        epilog=examples(
            "motion my_film.storyboard SC010_SH020 rick wave --to ilsa --at 1.5",
            "motion my_film.storyboard SC010_SH020 rick walk --at 0.5",
            "motion my_film.storyboard SC010_SH020 rick nod --remove",
        )
    )(motion)
    app.command(
        epilog=examples(
            "line my_film.storyboard SC010_SH020 rick 2 --at 3.5",
            "line my_film.storyboard SC010_SH020 rick 2 --crew",
        )
    )(line)


def pose(
    context: typer.Context,
    folder: Folder,
    shot: Annotated[str, typer.Argument(metavar="SHOT", help="Such as SC010_SH020.", show_default=False)],
    person: Annotated[str, typer.Argument(metavar="PERSON", help="Who is there.", show_default=False)],
    posture: Annotated[str | None, typer.Option(help="stand, sit, lie, kneel, crouch or lean.")] = None,
    on: Annotated[str | None, typer.Option(help="The seat, bed or rail; the nearest one if left out.")] = None,
    look_at: Annotated[
        str | None, typer.Option(help="A person, a thing, or left, right, up, down or camera, as the viewer has it.")
    ] = None,
    hold: Annotated[list[str] | None, typer.Option(help="A thing in their hand; once more for the other.")] = None,
    empty_hands: Annotated[bool, typer.Option("--empty-hands", help="They hold nothing.")] = False,
    at_end: Annotated[bool, typer.Option("--at-end", help="As the shot ends, not as it begins.")] = False,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Decide how a person is in a shot: posture, look, hands. They go on from there until the script changes it.

    `unlock` gives it back to the crew; `undo` takes it back. Where they stand is said with `place`.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import pose_edit

        if hold and empty_hands:
            raise InputError("hands are empty or hold something", mend="leave --hold or --empty-hands out")
        holding = hold or ([] if empty_hands else None)
        said = {"posture": posture, "on": on, "looking_at": look_at, "holding": holding}
        given = {name: value for name, value in said.items() if value is not None}
        edit = pose_edit(shot, person, given, at_end=at_end)
        edit_and_draw(context, terminal, folder, [edit], revision, draw=draw, look=look, jobs=jobs)


def motion(
    context: typer.Context,
    folder: Folder,
    shot: Annotated[str, typer.Argument(metavar="SHOT", help="Such as SC010_SH020.", show_default=False)],
    person: Annotated[str, typer.Argument(metavar="PERSON", help="Who does it.", show_default=False)],
    what: Annotated[str, typer.Argument(metavar="MOTION", help="As `catalog motions` lists them.", show_default=False)],
    at: Annotated[float | None, typer.Option(help="Second of the shot from which it begins.")] = None,
    seconds: Annotated[float | None, typer.Option(help="Its length, of motions that can have another one.")] = None,
    to: Annotated[str | None, typer.Option(help="The person or thing that it is aimed at.")] = None,
    prop: Annotated[str | None, typer.Option("--with", help="The thing in hand.")] = None,
    remove: Annotated[bool, typer.Option("--remove", help="They do not do it.")] = False,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Add a motion to a shot, give one another time, or take it away; walks and turns that it needs come by themselves.

    `unlock SHOT --part blocking` gives it back to the crew; `undo` takes it back.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import motion_edit

        said = {"at": at, "seconds": seconds, "target": to, "prop": prop}
        edit = motion_edit(shot, person, what, said, remove=remove)
        edit_and_draw(context, terminal, folder, [edit], draw=draw, look=look, jobs=jobs)


def line(
    context: typer.Context,
    folder: Folder,
    shot: Annotated[str, typer.Argument(metavar="SHOT", help="Such as SC010_SH020.", show_default=False)],
    person: Annotated[str, typer.Argument(metavar="PERSON", help="Who says it.", show_default=False)],
    number: Annotated[int, typer.Argument(metavar="LINE", help="Number of the line in the shot.", show_default=False)],
    at: Annotated[float | None, typer.Option(help="Second of the shot from which it is said.")] = None,
    seconds: Annotated[float | None, typer.Option(help="Its length.")] = None,
    crew: Annotated[bool, typer.Option("--crew", help="The crew has it again.")] = False,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Decide when a line of a shot is said, and for how long; what is said after it follows, and the shot grows.

    `--crew` gives it back to the crew; `undo` takes it back.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import line_edit

        said = {name: value for name, value in {"at": at, "seconds": seconds}.items() if value is not None}
        if bool(said) == crew:
            raise InputError("a line has a second, a length, or is the crew's", mend="give --at, --seconds or --crew")
        edit = line_edit(shot, person, number, said)
        edit_and_draw(context, terminal, folder, [edit], draw=draw, look=look, jobs=jobs)
