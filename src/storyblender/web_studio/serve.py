"""Runs the studio on this machine, and opens it in the browser."""

from __future__ import annotations

import secrets
import signal
import socket
import webbrowser
from collections.abc import Callable
from pathlib import Path

import uvicorn

from storyblender.web_studio.access import Door
from storyblender.web_studio.address_file import LOOPBACK, AddressFile, left_behind
from storyblender.web_studio.app import LARGEST_CALL, build_app
from storyblender.web_studio.hub import Hub


def serve(folder: Path, begin: str, port: int, say: Callable[[str], None], *, browser: bool) -> None:
    """Serve until the process is ended; the open project is closed then.

    Args:
        folder: Of scripts and projects; nothing outside it is read or written.
        begin: A project, opened at once, or a script, opened as its project or made into one; nothing if empty.
        port: 0 for any that is free.
        say: Hears the address with its key.
        browser: Whether the page is opened.

    Raises:
        InputError: No such project or script.
        ProjectLocked: Another program has it open.
    """
    former = left_behind(folder / begin) if begin else None
    with socket.socket() as listening:
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        _bind(listening, port, former[0] if former is not None else 0)
        listening.listen()
        origin = f"http://{LOOPBACK}:{listening.getsockname()[1]}"
        token, key = secrets.token_urlsafe(24), former[1] if former is not None else secrets.token_urlsafe(24)
        hub = Hub(folder, AddressFile(origin, key).follow)
        signal.signal(signal.SIGTERM, signal.default_int_handler)  # the project is closed as after Ctrl-C
        try:
            if begin:
                hub.open(begin) if (folder / begin).is_dir() else hub.begin(begin)
            door = Door(build_app(hub), token, origin, key)
            hub.invite = lambda: f"{origin}/?token={door.admit()}"
            config = uvicorn.Config(door, log_level="warning", ws_max_size=LARGEST_CALL, lifespan="off")
            say(f"{origin}/?token={token}")
            if browser:
                webbrowser.open(f"{origin}/?token={token}")
            uvicorn.Server(config).run([listening])
        finally:
            hub.close()


def _bind(listening: socket.socket, port: int, former: int) -> None:
    """Listen on the port that was asked for, else on that of a killed studio, whose pages wait there, else on any."""
    if port or not former:
        listening.bind((LOOPBACK, port))
        return
    try:
        listening.bind((LOOPBACK, former))
    except OSError:
        listening.bind((LOOPBACK, 0))
