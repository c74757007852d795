"""Where programs on this machine find the studio: a private file in the project that it holds open."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path

from storyblender.errors import InputError
from storyblender.folder import Folder

ADDRESS_FILE = ".studio.json"
"""Its name in the project. Only the user who runs the studio can read it; it is gone when the project is closed."""


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
