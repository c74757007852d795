"""``storyblender light`` and ``storyblender set``: hour, weather and light of a scene, and what its set is."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from storyblender.cli_options import Draw, Folder, Jobs, Json, LookOption, Quiet, edit_and_draw, examples, open_studio
from storyblender.shell import shown

if TYPE_CHECKING:
    from storyblender.memory.edits import Edit

_Scene = Annotated[str, typer.Argument(metavar="SCENE", help="Such as SC010.", show_default=False)]


def add_to(app: typer.Typer) -> None:
    """Add the commands to the command line."""
    app.command(
        epilog=examples(
            "light my_film.storyboard SC010 --hour dusk --weather rain",
            "light my_film.storyboard SC010 --warmth 1 --brightness -0.5 --quality dim --quality candlelight",
            "light my_film.storyboard SC020 --hdri sky.hdr",
            "light my_film.storyboard SC020 --hdri none",
        )
    )(light)
    app.command(
        "set",
        epilog=examples(
            "set my_film.storyboard SC010 --kit kitchen --period classic",
            "set my_film.storyboard SC010 --walls brick --ground parquet",
            "set my_film.storyboard SC010 --wall-texture textures/red_brick --texture-width 1.5",
            "set my_film.storyboard SC020 --snow --option trees --without fence",
        ),
    )(set_command)


def light(
    context: typer.Context,
    folder: Folder,
    scene: _Scene,
    hour: Annotated[str | None, typer.Option(help="dawn, morning, day, noon, afternoon, sunset ... night.")] = None,
    weather: Annotated[str | None, typer.Option(help="clear, cloudy, fog, rain, storm, snow.")] = None,
    quality: Annotated[
        list[str] | None, typer.Option(help="Its character: dim, harsh, candlelight ...; may be repeated.")
    ] = None,
    warmth: Annotated[float | None, typer.Option(help="-3, cooler than the crew's, to 3, warmer.")] = None,
    brightness: Annotated[float | None, typer.Option(help="Stops, -3 to 3.")] = None,
    contrast: Annotated[float | None, typer.Option(help="Stops between key and fill, -2 to 2.")] = None,
    key_side: Annotated[str | None, typer.Option(help="From where faces are lit: left or right.")] = None,
    hdri: Annotated[
        str | None, typer.Option(help="A panorama (.hdr, .exr) that lights it by day; none is the drawn sky.")
    ] = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Decide about the light of a scene; what you leave out stays the crew's. For single lamps see `lamp`.

    `unlock SCENE --part light` gives it back to the crew, `undo` takes it back.
    """
    said: dict[str, Any] = {
        "time_of_day": hour, "weather": weather, "qualities": quality or None, "warmth": warmth,
        "brightness": brightness, "contrast": contrast, "key_side": key_side,
    }  # fmt: skip
    with shown(quiet, json_lines) as terminal:
        if hdri == "none":
            said["panorama"] = hdri
        elif hdri is not None:
            with open_studio(terminal, project=folder).open(folder) as session:
                said["panorama"] = session.take_in_panorama(Path(hdri)).model_dump()
        edits = _decided("light", scene, said)
        edit_and_draw(context, terminal, folder, edits, draw=draw, look=look, jobs=jobs)


def set_command(
    context: typer.Context,
    folder: Folder,
    scene: _Scene,
    kit: Annotated[str | None, typer.Option(help="What it is: `storyblender catalog sets`.")] = None,
    walls: Annotated[str | None, typer.Option(help="Finish or material of the walls: brick, plaster_green ...")] = None,
    ground: Annotated[str | None, typer.Option(help="The same of the floor or the ground: parquet, gravel ...")] = None,
    period: Annotated[str | None, typer.Option(help="When it was furnished: past, classic, modern.")] = None,
    wall_texture: Annotated[
        str | None, typer.Option(help="A colour picture, or a folder with its maps, for the walls; none takes it off.")
    ] = None,
    ground_texture: Annotated[str | None, typer.Option(help="The same for the floor or the ground.")] = None,
    texture_width: Annotated[float | None, typer.Option(help="Metres that such a picture shows, else 2.")] = None,
    snow: Annotated[bool | None, typer.Option("--snow/--no-snow", help="Whether snow lies on the ground.")] = None,
    option: Annotated[list[str] | None, typer.Option(help="What of the kit is there; may be repeated.")] = None,
    without: Annotated[list[str] | None, typer.Option(help="What of the kit is not there; may be repeated.")] = None,
    width: Annotated[float | None, typer.Option(help="Metres from left to right.")] = None,
    depth: Annotated[float | None, typer.Option(help="Metres from front to back.")] = None,
    height: Annotated[float | None, typer.Option(help="Metres to the ceiling.")] = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Decide about the set of a place; every scene that plays there follows. What you leave out stays the crew's.

    `unlock SCENE --part set` gives it back to the crew, `undo` takes it back.
    """
    said: dict[str, Any] = {
        "kit": kit, "walls": walls, "ground": ground, "period": period, "snow": snow, "width": width, "depth": depth,
        "height": height, "options": {**dict.fromkeys(option or (), True), **dict.fromkeys(without or (), False)},
    }  # fmt: skip
    with shown(quiet, json_lines) as terminal:
        pictures = {"wall_texture": wall_texture, "ground_texture": ground_texture}
        files = {name: Path(file) for name, file in pictures.items() if file not in (None, "none")}
        said |= pictures
        if files:
            with open_studio(terminal, project=folder).open(folder) as session:
                taken = {name: session.take_in_texture(file, texture_width) for name, file in files.items()}
            said |= {name: texture.model_dump() for name, texture in taken.items()}
        edits = _decided("set", scene, said)
        edit_and_draw(context, terminal, folder, edits, draw=draw, look=look, jobs=jobs)


def _decided(kind: str, scene: str, said: dict[str, Any]) -> Sequence[Edit]:
    """Return the edit of what was said about a scene; None says nothing."""
    from storyblender.edits.words import edits_of

    decision = {name: value for name, value in said.items() if value is not None}
    return edits_of([{"kind": kind, "scene": scene, "decision": decision}])
