"""The command that opens a folder to agents."""

from __future__ import annotations

import os
import secrets
import sys
from pathlib import Path
from typing import Annotated

import typer

from storyblender.cli_options import examples
from storyblender.errors import InputError
from storyblender.shell import shown

_TOKEN = "STORYBLENDER_TOKEN"


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(epilog=examples("mcp", "mcp stories --http 8765"))(mcp)


def mcp(
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Where the scripts and projects are; nothing else is touched.")
    ] = Path(),
    http: Annotated[
        int | None, typer.Option(metavar="PORT", help="Serve over HTTP on this machine only, not over standard input.")
    ] = None,
) -> None:
    """Let an agent work with storyboards: a server of the Model Context Protocol (docs/agents.md).

    Over standard input and output by default, as most agents start it. Over HTTP it asks for a token: the one in
    STORYBLENDER_TOKEN, else a new one, which it prints.
    """
    with shown(quiet=True, json_lines=False):
        if not folder.is_dir():
            raise InputError("is not a folder", mend="name the folder of your scripts", path=folder)
        try:
            from storyblender.mcp_server.serve import serve
        except ImportError as error:
            raise InputError("the extra mcp is not installed", mend='pip install "storyblender[mcp]"') from error
        token = os.environ.get(_TOKEN) or secrets.token_urlsafe(24)
        if http is not None and not os.environ.get(_TOKEN):
            sys.stderr.write(f"token: {token}\n")
        serve(folder, http, token)
