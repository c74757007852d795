"""The command that opens a folder to agents."""

from __future__ import annotations

import os
import secrets
import socket
import sys
from pathlib import Path
from typing import Annotated

import typer

from storyblender.cli_options import examples
from storyblender.errors import InputError
from storyblender.shell import shown

_TOKEN = "STORYBLENDER_TOKEN"
_LOOPBACK = "127.0.0.1"


def add_to(app: typer.Typer) -> None:
    """Add the command to the command line."""
    app.command(epilog=examples("mcp", "mcp stories --http 8765"))(mcp)


def mcp(
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Where the scripts and projects are; nothing else is touched.")
    ] = Path(),
    http: Annotated[
        int | None,
        typer.Option(
            metavar="PORT", min=1, max=65535, help="Serve over HTTP on this machine only, not over standard input."
        ),
    ] = None,
) -> None:
    """Let an agent work with storyboards: a server of the Model Context Protocol (docs/agents.md).

    Over standard input and output by default: an agent starts it and talks to it. Over HTTP you start it, and it prints
    its address and the token to give to the agent: that in STORYBLENDER_TOKEN, else a new one.
    """
    with shown(quiet=True, json_lines=False):
        if not folder.is_dir():
            raise InputError("is not a folder", mend="name the folder of your scripts", path=folder)
        try:
            from storyblender.mcp_server.serve import serve
        except ImportError as error:
            raise InputError("the extra mcp is not installed", mend='pip install "storyblender[mcp]"') from error
        given = os.environ.get(_TOKEN)
        token = given or secrets.token_urlsafe(24)
        if http is not None:
            _check_free(http)
            said = f"that in {_TOKEN}" if given else token
            sys.stderr.write(f"address: http://{_LOOPBACK}:{http}/mcp\ntoken: {said}\n")
        serve(folder, http, token)


def _check_free(port: int) -> None:
    """Raise InputError if nobody may listen at a port, or another program does."""
    with socket.socket() as probe:
        if os.name == "posix":
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # a server that just ended does not count
        try:
            probe.bind((_LOOPBACK, port))
        except OSError as error:
            raise InputError(f"port {port} cannot be used ({error.strerror})", mend="take another one") from error
