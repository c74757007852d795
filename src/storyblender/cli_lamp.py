"""``storyblender lamp``: the lamps of a scene are listed, added, moved, made brighter or of another colour, removed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

import typer

from storyblender.cli_options import Draw, Folder, Jobs, Json, LookOption, Quiet, edit_and_draw, examples
from storyblender.shell import shown

_COLUMNS: dict[str, Callable[[Any], str]] = {
    "lamp": lambda lamp: lamp.name,
    "kind": lambda lamp: lamp.kind.lower(),
    "watts": lambda lamp: f"{lamp.power:g}",
    "at": lambda lamp: ", ".join(f"{value:.2f}" for value in lamp.location),
    "color": lambda lamp: ", ".join(f"{value:.2f}" for value in lamp.color),
}


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "lamp my_film.storyboard SC010",
            "lamp my_film.storyboard SC010 table_lamp --power 20 --color 1,0.6,0.3",
            "lamp my_film.storyboard SC010 backlight --kind spot --at 2,2,2.4 --point-at 0,0,1.4 --power 300",
            "lamp my_film.storyboard SC010 table_lamp --remove",
        )
    )(lamp)


def lamp(
    context: typer.Context,
    folder: Folder,
    scene: Annotated[str, typer.Argument(metavar="SCENE", help="Such as SC010.", show_default=False)],
    name: Annotated[
        str | None, typer.Argument(metavar="LAMP", help="Which; left out, they are listed.", show_default=False)
    ] = None,
    at: Annotated[str | None, typer.Option(help="Where it is: X,Y,Z in metres, Z up.")] = None,
    point_at: Annotated[str | None, typer.Option(help="Where it points: X,Y,Z.")] = None,
    power: Annotated[float | None, typer.Option(help="Watts, as in Blender; of a sun watts a square metre.")] = None,
    color: Annotated[str | None, typer.Option(help="R,G,B, each 0 to 1.")] = None,
    size: Annotated[float | None, typer.Option(help="Metres; a larger lamp gives softer shadows.")] = None,
    cone: Annotated[float | None, typer.Option(help="Of a spot, degrees.")] = None,
    kind: Annotated[str | None, typer.Option(help="Adds one: point, spot, area or sun.")] = None,
    remove: Annotated[bool, typer.Option("--remove", help="Take it away.")] = False,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Change a lamp of a scene, add one, or take one away; without a name, list them.

    The crew keeps to it; `unlock SCENE --part light` gives it back, `undo` takes it back.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import lamp_edit

        if name is None:
            from storyblender.edits.targets import scene_named
            from storyblender.project import read_project_graph

            lighting = scene_named(read_project_graph(folder), scene).lighting
            terminal.listed("lamps", lighting.lights if lighting is not None else (), _COLUMNS)
            return
        said = {"location": at, "target": point_at, "power": power, "color": color, "size": size, "cone": cone}
        edit = lamp_edit(scene, name, {**said, "kind": kind}, remove=remove)
        edit_and_draw(context, terminal, folder, [edit], draw=draw, look=look, jobs=jobs)
