"""``storyblender asset``: the things of a story are listed, made from something else, sized, turned, chosen anew."""

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
)
from storyblender.errors import InputError
from storyblender.shell import shown

_COLUMNS: dict[str, Callable[[Any], str]] = {
    "thing": lambda card: card.asset,
    "name": lambda card: card.name,
    "made from": lambda card: card.told,
    "": lambda card: ", ".join(["you decided"] * card.decided + ["locked"] * card.locked),
}


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "asset my_film.storyboard",
            'asset my_film.storyboard piano --model "white piano"',
            "asset my_film.storyboard chair --file chairs/red.glb",
            "asset my_film.storyboard chair --front right --top top",
            "asset my_film.storyboard table --height 0.9",
            "asset my_film.storyboard lamp --another",
        )
    )(asset)


def asset(
    context: typer.Context,
    folder: Folder,
    thing: Annotated[
        str | None, typer.Argument(metavar="THING", help="Which; left out, all are listed.", show_default=False)
    ] = None,
    model: Annotated[
        str | None, typer.Option(help='What it is made from, as the library calls it: "red bench".')
    ] = None,
    file: Annotated[
        str | None, typer.Option(help="A model, by its path inside your folder of models (without that folder's name).")
    ] = None,
    another: Annotated[bool, typer.Option("--another", help="The crew makes it from something else.")] = False,
    width: Annotated[float | None, typer.Option(help="Metres; one side alone keeps the proportions.")] = None,
    depth: Annotated[float | None, typer.Option(help="Metres.")] = None,
    height: Annotated[float | None, typer.Option(help="Metres.")] = None,
    front: Annotated[
        str | None, typer.Option(help="Which side of your model is its front: front, back, left, right, top, bottom.")
    ] = None,
    top: Annotated[str | None, typer.Option(help="Which is its top, likewise.")] = None,
    name: Annotated[str | None, typer.Option(help="What it is called on board and lists.")] = None,
    revision: Revision = None,
    draw: Draw = True,
    look: LookOption = None,
    jobs: Jobs = None,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Change what a thing of the story is made from, its size, or its front and top; without a name, list them.

    `unlock` gives it back to the crew, `undo` takes it back. What is changed is one undo.
    """
    with shown(quiet, json_lines) as terminal:
        from storyblender.edits.words import edits_of
        from storyblender.memory.asset_sheet import ModelSide

        if thing is None:
            from storyblender.project import read_project_graph
            from storyblender.workplace.cast import cards_of

            things = [card for card in cards_of(read_project_graph(folder)) if card.sort == "thing"]
            terminal.listed("assets", things, _COLUMNS)
            return
        size = {side: given for side, given in (("width", width), ("depth", depth), ("height", height)) if given}
        pose = model_pose(get_args(ModelSide), front=front, top=top)
        said: dict[str, dict[str, object]] = {"replace": {"model": model} if model else {"file": file} if file else {}}
        said |= {"regenerate": {"thing": thing} if another else {}, "turn": {"pose": pose} if pose else {}}
        said |= {"resize": {"dimension": size} if size else {}, "rename": {"name": name} if name else {}}
        about = {"kind": "asset", "thing": thing}
        edits = [{**about, "action": action, **values} for action, values in said.items() if values]
        if not edits or (model and file) or (another and (model or file)):
            mend = "give --model, --file or --another, a size, --front with --top, or --name"
            raise InputError(f"it is not clear what becomes of {thing}", mend=mend)
        edit_and_draw(context, terminal, folder, edits_of(edits), revision, draw=draw, look=look, jobs=jobs)
