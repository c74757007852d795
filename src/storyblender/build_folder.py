"""``build/`` on another disk: which folder may take its place.

A project from another person may name any folder, so a folder is used only if a file in it names this project.
"""

from __future__ import annotations

from pathlib import Path

from storyblender.errors import InputError
from storyblender.folder import Folder

MARK = "storyblender-project.txt"
"""File in the folder with the path of the project that it belongs to."""


def check_build_folder(build: Path, project: Path, *, take: bool) -> None:
    """Make sure that a folder belongs to a project.

    Args:
        build: The folder.
        project: The project folder, without links in its path.
        take: The user named it: an empty one, or one whose project is gone, is given to this project.

    Raises:
        InputError: It belongs to another project, or holds something else.
    """
    owner = _owner(build)
    if owner == str(project):
        return
    free = not build.exists() or (build.is_dir() and not any(build.iterdir()))
    if not take or not (free or (owner is not None and not Path(owner).exists())):
        mend = "name an empty folder as `build` in storyblender.toml, then run `storyblender make SCRIPT`"
        raise InputError("is not the build folder of this project", mend=mend, path=build)
    Folder(build).write(MARK, str(project))


def _owner(build: Path) -> str | None:
    try:
        return (build / MARK).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None
