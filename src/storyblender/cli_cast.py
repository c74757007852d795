"""``storyblender cast``: how people look is listed and changed: body, hair, clothes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, get_args

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
    model_pose,
    open_studio,
)
from storyblender.errors import InputError
from storyblender.shell import shown

_COLUMNS: dict[str, Callable[[Any], str]] = {
    "person": lambda card: card.asset,
    "name": lambda card: card.name,
    "looks": lambda card: card.told,
    "": lambda card: ", ".join(["you decided"] * card.decided + ["locked"] * card.locked),
}


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "cast my_film.storyboard",
            'cast my_film.storyboard rick --wear "red coat" --take-off tie',
            "cast my_film.storyboard ilsa --hair bob --hair-color black --age 30",
            "cast my_film.storyboard ilsa --face 2",
            "cast my_film.storyboard rick --file cast/knight.glb",
            "cast my_film.storyboard rick --make --services gemini,hunyuan3d",
        )
    )(cast)


def cast(
    context: typer.Context,
    folder: Folder,
    person: Annotated[
        str | None, typer.Argument(metavar="PERSON", help="Who; left out, all are listed.", show_default=False)
    ] = None,
    wear: Annotated[
        list[str] | None,
        typer.Option(help='What they put on: "red coat". May be repeated.'),
    ] = None,
    take_off: Annotated[list[str] | None, typer.Option(help="What they take off; may be repeated.")] = None,
    hair: Annotated[str | None, typer.Option(help="Their hair, as `catalog hair` lists it: bob.")] = None,
    hair_color: Annotated[str | None, typer.Option(help="Its colour: black, or #6b4a30.")] = None,
    facial_hair: Annotated[str | None, typer.Option(help="none, stubble, moustache or beard.")] = None,
    glasses: Annotated[bool | None, typer.Option("--glasses/--no-glasses", help="Whether they wear any.")] = None,
    skin: Annotated[str | None, typer.Option(help="pale, light, tan, brown or dark.")] = None,
    age: Annotated[float | None, typer.Option(help="Years.")] = None,
    sex: Annotated[str | None, typer.Option(help="female or male.")] = None,
    build: Annotated[str | None, typer.Option(help="slim, average, athletic, stocky or heavy.")] = None,
    height: Annotated[float | None, typer.Option(help="Metres.")] = None,
    face: Annotated[int | None, typer.Option(help="Another number, another face.")] = None,
    file: Annotated[
        str | None,
        typer.Option(help="A humanoid model, by its path inside your folder of models (without that folder's name)."),
    ] = None,
    make: Annotated[
        bool,
        typer.Option("--make", help="Have services make a model of them: a picture of how they look, a model of that."),
    ] = False,
    services: Annotated[
        str | None,
        typer.Option(
            help="With --make: one service that draws (gemini, openai) and one that makes models of pictures "
            "(hunyuan3d, trellis, meshy), with commas; those that the storyboard was made with if not given."
        ),
    ] = None,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="With --make: only say what it would cost.")] = False,
    front: Annotated[
        str | None,
        typer.Option(
            help="Which side of the model of --file or --make is its front: front, back, left, right, top, bottom."
        ),
    ] = None,
    top: Annotated[str | None, typer.Option(help="Which side of that model is its top, likewise.")] = None,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Change how a character looks, in all scenes that show them; without a name, list the cast.

    It stays when the script changes. `lock` keeps it against further edits, `unlock` gives
    it back to the crew, `undo` takes it back.
    """
    said: dict[str, Any] = {
        "hair": hair, "hair_color": hair_color, "facial_hair": facial_hair, "glasses": glasses, "skin": skin,
        "age": age, "gender": sex, "build": build, "stature": height, "face": face,
    }  # fmt: skip
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.look_words import look_edit
        from storyblender.edits.targets import person_named
        from storyblender.edits.words import edits_of
        from storyblender.memory.asset_sheet import ModelSide
        from storyblender.project import read_project_graph

        graph = read_project_graph(folder)
        looks = bool(wear or take_off or any(value is not None for value in said.values()))
        if person is None:
            if looks or make or dry_run or services or file or front or top:
                raise InputError("nobody is named", mend="`storyblender cast FOLDER PERSON` and then the options")
            from storyblender.workplace.cast import cards_of

            people = [card for card in cards_of(graph) if card.sort == "person"]
            terminal.listed("cast", people, _COLUMNS)
            return
        person = person_named(graph, person)
        if make:
            if file or looks:
                mend = "change the look first, then have the model made of it" if looks else "leave one of the two out"
                raise InputError(f"--make goes without {'a change of look' if looks else '--file'}", mend=mend)
            studio = open_studio(terminal, project=folder, services=services)
            if dry_run:
                terminal.expected(studio.expect_person(folder, person))
                return
            file = studio.make_person(folder, person)
        elif dry_run or services:
            raise InputError("--dry-run and --services are for --make", mend="add --make, or leave them out")
        about = {"kind": "asset", "thing": person}
        model: list[dict[str, object]] = [{**about, "action": "replace", "file": file}] if file else []
        pose = model_pose(get_args(ModelSide), front=front, top=top)
        model += [{**about, "action": "turn", "pose": {"top": "top", **pose}}] if pose else []
        edits = list(edits_of(model))
        if not edits or looks:
            edits.append(look_edit(person, said, wear or (), take_off or ()))
        edit_and_draw(context, terminal, folder, edits, revision, draw=draw, look=look, jobs=jobs)
