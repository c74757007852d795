"""How the extension reaches the program: a studio that holds the project open, or the command line."""

from __future__ import annotations

import json
import os
import stat
import subprocess
import time
from collections.abc import Sequence
from http.client import HTTPConnection, HTTPException
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

ADDRESS_FILE = ".studio.json"
"""In a project that a studio holds open: its address, and the key for calls of programs."""
LOOPBACK = "127.0.0.1"
_LONGEST = 3600.0
"""Seconds that a call may take: drawing a feature takes long, and the panel stays free."""
_OFTEN = 0.3
"""Seconds between two questions how far work is."""
_NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)


class NotDone(Exception):
    """Why something was not done, in one sentence."""


class Studio:
    """A running studio with the project open.

    Args:
        host: This machine, with a port.
        key: That every call names.
    """

    words = "studio"
    """How the panel calls it."""

    def __init__(self, host: str, key: str) -> None:
        self._host, self._key = host, key

    def story(self, seen: str) -> dict[str, Any]:
        """Return the board, and all that is known of every shot: nothing if that is of the revision that was seen."""
        board = self._call("board")
        return {"board": board, "shots": [] if board["revision"] == seen else self._call("shots")}

    def edit(self, edits: Sequence[dict[str, Any]], revision: str) -> None:
        """Make edits as one undo; refused if what they touch has changed since the revision."""
        self._call("apply", edits=list(edits), revision=revision or None)

    def undo(self) -> None:
        """Take the last change of the story back."""
        self._call("undo")

    def pull(self) -> dict[str, Any]:
        """Take over what was saved in Blender; return what became of it."""
        return self._call("pull")

    def draw(self, shot: str) -> None:
        """Draw the frame of a shot."""
        self._call("draw", shot=shot)

    def push(self) -> None:
        """Draw what is stale, and write story.blend from the story; the studio's pages show how far it is."""
        self._call("write", what="all")
        while (status := self._call("places")["status"])["busy"]:
            time.sleep(_OFTEN)
        if status["error"]:
            raise NotDone(status["error"])

    def _call(self, call: str, **values: Any) -> Any:
        body = json.dumps({"id": 1, "call": call, **values})
        connection = HTTPConnection(self._host, timeout=_LONGEST)
        try:
            connection.request("POST", "/calls", body, {"Authorization": f"Bearer {self._key}"})
            response = connection.getresponse()
            text = response.read().decode(errors="replace")
        except (OSError, HTTPException) as error:
            raise NotDone("the studio does not answer: start it again, or end it to go on without it") from error
        finally:
            connection.close()
        if response.status != 200:
            raise NotDone("the studio refused the key of this project: press Refresh, or start the studio again")
        answer = json.loads(text)
        if not answer["ok"]:
            raise NotDone(answer["error"])
        return answer["value"]


class Program:
    """The command line, run once for each call, while no studio has the project open.

    Args:
        path: Of the executable.
        project: The project folder.
    """

    words = "alone"
    """How the panel calls it."""

    def __init__(self, path: str, project: Path) -> None:
        self._path, self._project = path, project

    def story(self, seen: str) -> dict[str, Any]:
        """Return the board, and all that is known of every shot, whatever was seen."""
        return self._told("board", "shot", "list", str(self._project))

    def edit(self, edits: Sequence[dict[str, Any]], revision: str) -> None:
        """Make edits as one undo; refused if what they touch has changed since the revision."""
        seen = ["--revision", revision] if revision else []
        self._run("edit", str(self._project), "--batch", "-", "--no-render", *seen, text=json.dumps(list(edits)))

    def undo(self) -> None:
        """Take the last change of the story back."""
        self._run("undo", str(self._project))

    def pull(self) -> dict[str, Any]:
        """Take over what was saved in Blender; return what became of it."""
        return self._told("understood", "pull", str(self._project), "--no-render")

    def draw(self, shot: str) -> None:
        """Draw the frame of a shot."""
        self._run("render", str(self._project), "--shot", shot)

    def push(self) -> None:
        """Draw what is stale, and write story.blend from the story."""
        self._run("render", str(self._project))

    def _told(self, key: str, *words: str) -> dict[str, Any]:
        return next(told for told in self._run(*words) if key in told)

    def _run(self, *words: str, text: str = "") -> list[dict[str, Any]]:
        """Run a command and return what it told, line by line."""
        command = [self._path, *words, "--json"]
        try:
            done = subprocess.run(
                command, input=text, capture_output=True, encoding="utf-8", errors="replace", check=False,
                timeout=_LONGEST, creationflags=_NO_WINDOW,
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            raise NotDone(f"{self._path} cannot be run: set Program in the extension's preferences") from error
        told = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
        if done.returncode != 0:
            said = next((line["error"] for line in reversed(told) if "error" in line), "")
            raise NotDone(said or f"`storyblender {words[0]}` failed: {done.stderr.strip()[-200:]}")
        return told


def reach(project: Path, program: str) -> Studio | Program:
    """Return the studio that holds a project open; the command line if there is none.

    Args:
        project: The project folder.
        program: Path of the executable; empty if it is not known.

    Raises:
        NotDone: There is neither.
    """
    studio = _studio(project)
    if studio is not None:
        return studio
    if not program:
        raise NotDone("no studio has this project open, and Program is not set in the extension's preferences")
    return Program(program, project)


def _studio(project: Path) -> Studio | None:
    """Return the studio whose address is in a project; None where nobody answers there, or it is not to be trusted."""
    file = project / ADDRESS_FILE
    try:
        if os.name == "posix" and stat.S_IMODE(file.stat().st_mode) & 0o077:
            return None  # not as a studio writes it
        told = json.loads(file.read_text(encoding="utf-8"))
        address = urlsplit(str(told["address"]))
        if not project.samefile(told["project"]) or address.hostname != LOOPBACK:
            return None  # copied with its project, or of another machine
        connection = HTTPConnection(address.netloc, timeout=2.0)
        connection.connect()
        connection.close()
        return Studio(address.netloc, str(told["key"]))
    except (OSError, ValueError, KeyError, TypeError, HTTPException):
        return None  # none, or one that was killed
