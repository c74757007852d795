"""``storyblender paint``: a material of a thing, a person, a scene or the whole story looks otherwise."""

from __future__ import annotations

from typing import Annotated

import typer

from storyblender.cli_options import Draw, Folder, Jobs, Json, LookOption, Quiet, edit_and_draw, examples
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "paint my_film.storyboard sofa --color '#8a2f2a'",
            "paint my_film.storyboard --material wood --color 0.1,0.2,0.4 --scene SC010",
            "paint my_film.storyboard wall_back --scene SC010 --material wall_tile --finish brick",
            "paint my_film.storyboard sofa --remove",
        )
    )(paint)


def paint(
    context: typer.Context,
    folder: Folder,
    thing: Annotated[
        str | None,
        typer.Argument(metavar="THING", help="A thing or a person; left out, all that has it.", show_default=False),
    ] = None,
    material: Annotated[
        str | None, typer.Option(help="Which material, as in `catalog materials`; else the one that covers most.")
    ] = None,
    scene: Annotated[str | None, typer.Option(help="Only in this scene; THING may be a piece of its set.")] = None,
    color: Annotated[str | None, typer.Option(help="#RRGGBB, or R,G,B, linear, each 0 to 1.")] = None,
    roughness: Annotated[float | None, typer.Option(help="0 is a mirror, 1 is chalk.")] = None,
    metallic: Annotated[float | None, typer.Option(help="1 is metal.")] = None,
    finish: Annotated[str | None, typer.Option(help="A material of the catalogue in its place.")] = None,
    plain: Annotated[bool, typer.Option("--plain", help="Take its pattern away.")] = False,
    remove: Annotated[bool, typer.Option("--remove", help="Take the paint off.")] = False,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Paint a material: of a thing or a person, of a scene, or of the whole story. The crew keeps to it."""
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import paint_edit

        said = {"roughness": roughness, "metallic": metallic, "finish": finish, "plain": plain or None}
        edit = paint_edit(thing, material, scene, {**said, "color": color}, remove=remove)
        edit_and_draw(context, terminal, folder, [edit], draw=draw, look=look, jobs=jobs)
