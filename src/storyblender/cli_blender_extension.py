"""The command that writes the Blender extension."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from storyblender.cli_options import Json, examples
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(epilog=examples("blender-extension", "blender-extension ~/storyblender-extension"))(blender_extension)


def blender_extension(
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Where it is written; made if it does not exist.")
    ] = Path("blender-extension"),
    json_lines: Json = False,
) -> None:
    """Write the extension for Blender 4.5 or newer: a panel to direct a storyboard from Blender (docs/blender.md).

    Drop the zip into Blender, or add the folder's index.json as a remote repository.
    """
    with shown(quiet=False, json_lines=json_lines) as terminal:
        from storyblender.extension_repository import INDEX, write_repository

        terminal.files(folder, write_repository(folder))
        if not json_lines:
            program = Path(sys.executable).with_name("storyblender")
            typer.echo(f"Drop the zip into Blender, or add {(folder.resolve() / INDEX).as_uri()} as a repository.")
            typer.echo(f"Program, in its preferences: {program if program.is_file() else 'storyblender'}")
