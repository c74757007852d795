"""The command that opens the studio in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from storyblender.cli_options import examples
from storyblender.errors import InputError
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(
        epilog=examples(
            "studio",
            "studio my_film.fountain",
            "studio my_film.storyboard",
            "studio stories --port 8080",
            "studio my_film.storyboard --link",
        )
    )(studio)


def studio(
    place: Annotated[
        Path,
        typer.Argument(metavar="PLACE", help="A script, a project, or a folder of scripts and projects."),
    ] = Path(),
    port: Annotated[int, typer.Option(min=0, max=65535, help="Of the page; any that is free if not given.")] = 0,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Only print the address.")] = False,
    link: Annotated[
        bool, typer.Option("--link", help="Print a new address of the studio that has it open, for one more browser.")
    ] = False,
) -> None:
    """Open the studio: the board in your browser, to look at and to change (docs/studio.md).

    A script that has no storyboard yet is made into one, while you watch.

    The page is served on this machine only, under an address with a key that works once; --link makes another. Ctrl-C
    ends it.
    """
    with shown(quiet=True, json_lines=False):
        if not place.exists():
            raise InputError("is not there", mend="name a script, a project, or the folder of your scripts", path=place)
        try:
            from storyblender.web_studio.link import address_for_one_more
            from storyblender.web_studio.serve import serve
        except ImportError as error:
            raise InputError("the extra studio is not installed", mend='pip install "storyblender[studio]"') from error
        here = place.resolve()
        if link:
            typer.echo(address_for_one_more(here))
            return
        opens = here.is_file() or (here / "graph.json").exists()
        folder, begin = (here.parent, here.name) if opens else (here, "")
        serve(folder, begin, port, lambda address: typer.echo(address, err=True), browser=not no_browser)
