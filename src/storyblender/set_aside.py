"""Undone changes that the crew has worked on since: they lie in ``history/undone`` so that redo still finds them.

Undo leads to a state that the crew may not have finished, such as a shot whose camera is not set. What it commits there
would take the place of the undone commits, so those are set aside: one file each, named by the digest of the commit
that it was made on. The commits form a tree then, and ``next_redo`` walks it. Only a change of a person ends it.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from pydantic import ValidationError

from storyblender.folder import Folder
from storyblender.memory.history import CAUSED_BY_PERSON, Commit

UNDONE = "history/undone"


class SetAside:
    """The undone commits of a project that are not in line with the current one.

    Args:
        files: Of the project.
    """

    def __init__(self, files: Folder) -> None:
        self._files = files

    def keep(self, commit: Commit) -> None:
        """Keep a commit that another one takes the place of."""
        self._files.write(_name(commit), commit.model_dump_json())

    def forget(self, *commits: Commit) -> None:
        """Delete commits, all of them if none is given; the last ones first, so that no others are left behind."""
        names = [_name(commit) for commit in commits] or [f"{UNDONE}/{path.name}" for path in self._paths()]
        for name in reversed(names):
            self._files.delete(name)

    def after(self, parent: str, *, by_person: bool) -> Commit | None:
        """Return what a person, or the crew, did next; None where that is not kept, or cannot be read.

        Args:
            parent: Digest of the commit that it was made on.
            by_person: Whose.
        """
        path = self._files.path(_file(parent, by_person=by_person))
        try:
            commit = Commit.model_validate_json(path.read_bytes())
        except (FileNotFoundError, ValidationError):
            return None
        return commit if commit.intact and commit.parent == parent else None

    def step(self, parent: str) -> list[Commit]:
        """Return a person's next change with the crew's work on it; nothing where none is kept.

        Args:
            parent: Digest of the commit that it was made on.
        """
        first = self.after(parent, by_person=True)
        return [first, *self.crew_after(first.digest)] if first is not None else []

    def crew_after(self, parent: str) -> Iterator[Commit]:
        """Yield the crew's commits that were made one after the other on a commit.

        Args:
            parent: Its digest.
        """
        while (commit := self.after(parent, by_person=False)) is not None:
            yield commit
            parent = commit.digest

    def _paths(self) -> list[Path]:
        folder = self._files.path(UNDONE)
        return sorted(folder.glob("*.json")) if folder.is_dir() else []


def _name(commit: Commit) -> str:
    return _file(commit.parent, by_person=commit.author in CAUSED_BY_PERSON)


def _file(parent: str, *, by_person: bool) -> str:
    return f"{UNDONE}/{parent or 'start'}-{'person' if by_person else 'crew'}.json"
