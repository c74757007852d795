"""A running studio is asked for an address that opens it in one more browser."""

from __future__ import annotations

import json
from collections.abc import Iterable
from contextlib import suppress
from http.client import HTTPConnection, HTTPException
from pathlib import Path

from storyblender.errors import InputError
from storyblender.web_studio.access import PROGRAMS
from storyblender.web_studio.address_file import ADDRESS_FILE, LOOPBACK, left_behind

_NO_ANSWER = (OSError, HTTPException, ValueError, KeyError, TypeError)
"""What asking a studio that was killed raises, or something else that has its port now."""
_SECONDS = 60.0
"""How long the answer may take: the studio finishes the call before it."""


def address_for_one_more(place: Path) -> str:
    """Return a fresh address of the studio that has a project open; its key works once.

    Args:
        place: The project, its script, or the folder of both.

    Raises:
        InputError: No studio of this user has it open.
    """
    for project in _projects(place):
        with suppress(*_NO_ANSWER):
            return _asked(project)
    raise InputError("no studio has it open", mend="start one with `storyblender studio`, without --link", path=place)


def _projects(place: Path) -> Iterable[Path]:
    if place.is_file():
        return (place.with_suffix(".storyboard"),)
    if (place / ADDRESS_FILE).exists():
        return (place,)
    return (path.parent for path in sorted(place.glob(f"*/{ADDRESS_FILE}")))


def _asked(project: Path) -> str:
    """Return what the studio of a project answers. Raises what is in ``_NO_ANSWER``."""
    found = left_behind(project)
    if found is None:
        raise ValueError("nothing tells of a studio")
    port, key = found
    with_key = {"Authorization": f"Bearer {key}"}
    connection = HTTPConnection(LOOPBACK, port, timeout=_SECONDS)
    try:
        connection.request("POST", PROGRAMS, json.dumps({"id": 1, "call": "link"}), with_key)
        return str(json.loads(connection.getresponse().read())["value"]["address"])
    finally:
        connection.close()
