"""The commands for what was changed in Blender: take it over, and give motion by hand back to the crew."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Literal

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
from storyblender.shell import shown


class Side(StrEnum):
    """The two sides of a conflict."""

    BLENDER = "blender"
    PROJECT = "project"


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "pull my_film.storyboard",
            "pull my_film.storyboard --dry-run",
            "pull my_film.storyboard --take SC010_SH020.lens",
        )
    )(pull)
    app.command("by-hand", epilog=examples("by-hand my_film.storyboard SC010_SH020 rick"))(by_hand)


def pull(
    folder: Folder,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Only say what was changed.")] = False,
    prefer: Annotated[
        Side | None, typer.Option(help="Which side of all conflicts is taken; otherwise they wait, and yours stands.")
    ] = None,
    take: Annotated[list[str] | None, typer.Option(help="Id of a conflict that is taken from Blender.")] = None,
    leave: Annotated[list[str] | None, typer.Option(help="Id of a conflict that stays as the project has it.")] = None,
    render: Annotated[bool, typer.Option("--render/--no-render", help="Draw what that changes.")] = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Take over what you changed and saved in story.blend: places, cameras, motion, cuts (docs/blender.md).

    All of it is one undo. What was changed in the project as well is a conflict: it is shown with an id, and waits
    until you choose with --take, --leave or --prefer; until then the project stands.
    What no edit can express is kept in a dated copy of the file. `make` and `render` pull by themselves.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.pulling import Choice

        sides: dict[Side, Literal["blender", "project"]] = {Side.BLENDER: "blender", Side.PROJECT: "project"}
        studio = open_studio(terminal, None, folder)
        with studio.open(folder) as session:
            pulled = session.pull(
                apply=not dry_run,
                choice=Choice(
                    prefer=sides[prefer] if prefer else None, take=tuple(take or ()), leave=tuple(leave or ())
                ),
            )
            terminal.pulled(pulled)
            if render and pulled.applied is not None and (delivery := session.draw(pulled.applied)) is not None:
                terminal.files(delivery.folder, delivery.files, delivery.followed)


def by_hand(
    context: typer.Context,
    folder: Folder,
    shot: Annotated[str, typer.Argument(metavar="SHOT", help="Such as SC010_SH020.", show_default=False)],
    who: Annotated[str, typer.Argument(metavar="WHO", help="The person or the thing.", show_default=False)],
    motion: Annotated[
        str | None, typer.Option(help="Name of a file in the folder by_hand: that motion, as once pulled.")
    ] = None,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Let the crew act a person or a thing of a shot again that you animated in Blender; `undo` brings it back."""
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import edits_of

        edits = edits_of([{"kind": "by_hand", "shot": shot, "who": who, "motion": motion}])
        edit_and_draw(context, terminal, folder, edits, revision, draw=draw, look=look, jobs=jobs)
