"""The command that takes over what was changed in Blender."""

from __future__ import annotations

from typing import Annotated

import typer

from storyblender.cli_options import Folder, Json, Quiet, examples, open_studio
from storyblender.shell import shown


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(epilog=examples("pull my_film.storyboard", "pull my_film.storyboard --dry-run"))(pull)


def pull(
    folder: Folder,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Only say what was changed.")] = False,
    render: Annotated[bool, typer.Option("--render/--no-render", help="Draw what that changes.")] = True,
    quiet: Quiet = False,
    json_lines: Json = False,
) -> None:
    """Take over what you changed and saved in story.blend: places, sizes, cameras, lenses, cuts (docs/blender.md).

    All of it is one undo. What was changed in the project as well is a conflict: it is shown, and the project's stands.
    What no edit can express is kept in a dated copy of the file. `make` and `render` pull by themselves.
    """
    with shown(quiet, json_lines) as terminal:
        studio = open_studio(terminal, None, folder)
        with studio.open(folder) as session:
            pulled = session.pull(apply=not dry_run)
            terminal.pulled(pulled)
            if render and pulled.applied is not None and (delivery := session.draw(pulled.applied)) is not None:
                terminal.files(delivery.folder, delivery.files)
