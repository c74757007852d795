"""``storyblender propose``: several stagings of a scene side by side, to choose among."""

from __future__ import annotations

from typing import Annotated

import typer

from storyblender.cli_options import Folder, Jobs, Json, LookOption, Quiet, examples, open_studio
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "propose my_film.storyboard SC010 --takes 3",
            "propose my_film.storyboard SC010_SH020",
            "propose my_film.storyboard SC010 --choose 2",
        )
    )(propose)


def propose(
    context: typer.Context,
    folder: Folder,
    where: Annotated[
        str, typer.Argument(metavar="WHERE", help="A scene (SC010), or one shot of it.", show_default=False)
    ],
    takes: Annotated[int, typer.Option(help="How many stagings.")] = 3,
    choose: Annotated[int | None, typer.Option(help="Take the staging of this number, and draw it.")] = None,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Try other stagings of a scene, without a fault of physics, and show them on one sheet; nothing is changed.

    `--choose` takes one of them, which `undo` takes back.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import edits_of
        from storyblender.proposing import propose_stagings

        studio = open_studio(terminal, project=folder, ahead=context.obj, look=look, jobs=jobs, animatic=False)
        if choose is not None:
            scene = where.partition("_")[0]
            edits = edits_of([{"kind": "layout", "scene": scene, "staging": choose}])
            applied, delivery = studio.edit(folder, edits)
            terminal.applied(applied)
            terminal.files(folder, delivery.files if delivery is not None else [])
            return
        with studio.open(folder) as session:
            found = propose_stagings(session, where, takes)
            frames = {
                f"staging {each.number}: {shot}": picture for each in found for shot, picture in each.pictures.items()
            }
            sheet = session.keep_sheet("stagings.jpg", frames) if frames else ""
        terminal.stagings({each.number: each.words for each in found})
        terminal.files(folder, [sheet] if sheet else [])
