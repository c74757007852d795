"""Where the user's library lies."""

from __future__ import annotations

import os
from pathlib import Path


def library_folder() -> Path:
    """Return the folder of the user's library, which need not exist.

    ``STORYBLENDER_LIBRARY`` names it; else it is ``storyblender/library`` in ``XDG_DATA_HOME`` or ``~/.local/share``.
    """
    if told := os.environ.get("STORYBLENDER_LIBRARY"):
        return Path(told).expanduser()
    data = os.environ.get("XDG_DATA_HOME")
    return (Path(data) if data else Path.home() / ".local" / "share") / "storyblender" / "library"
