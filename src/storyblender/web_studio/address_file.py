"""Where programs on this machine find the studio: a private file in the project that it holds open."""

from __future__ import annotations

import json
import os
import stat
from contextlib import suppress
from pathlib import Path

from storyblender.errors import InputError
from storyblender.folder import Folder

LOOPBACK = "127.0.0.1"
ADDRESS_FILE = ".studio.json"
"""Its name in the project. Only the user who runs the studio can read it; it is gone when the project is closed."""


def left_behind(project: Path) -> tuple[int, str] | None:
    """Return port and key of a studio that was killed while it held a project open; None if there is none.

    A file that others can read, such as one that came with a project from elsewhere, is not believed.

    Args:
        project: Its folder.
    """
    path = project / ADDRESS_FILE
    try:
        seen = path.lstat()
        if not stat.S_ISREG(seen.st_mode) or seen.st_mode & 0o077 or seen.st_uid != os.getuid():
            return None
        told = json.loads(path.read_bytes())
        return int(told["address"].rpartition(":")[2]), str(told["key"])
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


class AddressFile:
    """The file, which follows the open project.

    Args:
        address: Of the studio, such as ``http://127.0.0.1:8765``.
        key: That a program names with every call.
    """

    def __init__(self, address: str, key: str) -> None:
        self._address, self._key = address, key
        self._project: Path | None = None

    def follow(self, project: Path | None) -> None:
        """Lie in the project that is open now; nowhere if there is none.

        Raises:
            InputError: The project's disk cannot take it.
        """
        if self._project is not None:
            with suppress(InputError):  # a project that was taken away meanwhile
                Folder(self._project).delete(ADDRESS_FILE)
        self._project = project
        if project is not None:
            told = {"address": self._address, "key": self._key, "project": str(project.resolve())}
            Folder(project).write(ADDRESS_FILE, json.dumps(told), private=True)
