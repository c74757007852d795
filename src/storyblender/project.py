"""The project folder on disk: graph, history, trace, frames. Atomic writes, one writer, resume after a kill.

A commit is written as ``history/NNNNNN.json`` and then made current by ``history/HEAD``; ``graph.json`` is a
checkpoint brought up to HEAD on opening. Killed at any instant, the folder opens at the last whole commit.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any

from filelock import FileLock, Timeout
from pydantic import ValidationError

from storyblender.errors import InputError, ProjectLocked
from storyblender.folder import Folder
from storyblender.memory.gatekeeper import Gatekeeper
from storyblender.memory.graph import SCHEMA_VERSION, ContinuityMemoryGraph
from storyblender.memory.history import Commit, apply, changes_between
from storyblender.trace import Event

_RESTORE = "restore it from a copy, or delete the folder and make it again"

UPGRADES: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}
"""From schema version n to n + 1; kept forever, so that every saved project opens."""


class Project:
    """An open project. Use as a context manager: it holds the folder's lock.

    Args:
        folder: ``NAME.storyboard``; made if it does not exist.

    Raises:
        ProjectLocked: Another run has it open.
        InputError: The folder holds something else, or a graph that cannot be read.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder.resolve()
        self.files = Folder(self.folder)
        """The only way to write and delete here."""
        try:
            self._refuse_foreign()
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(
                f"cannot make the folder ({error.strerror})", mend="give another --out", path=folder
            ) from error
        self._lock = FileLock(self.folder / ".lock", timeout=0)
        try:
            self._lock.acquire()
        except Timeout as error:
            raise ProjectLocked(f"{folder}: another run is writing here; wait for it or give another --out") from error
        try:
            self.graph, self.revision = self._load()
        except InputError:
            self._lock.release()
            raise

    def __enter__(self) -> Project:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self.checkpoint()
        self._lock.release()

    def path(self, *parts: str) -> Path:
        """Return a path inside the folder, with its parent made. Raises InputError if it would leave the folder."""
        path = self.folder.joinpath(*parts).resolve()
        if not path.is_relative_to(self.folder):
            raise InputError(f"{'/'.join(parts)!r} leaves the project folder")
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def commit(self, graph: ContinuityMemoryGraph, author: str, reason: str) -> Commit | None:
        """Write ``graph`` as the next revision if the Gatekeeper lets it in; None where nothing changed.

        Raises:
            Rejected: V(o_new, S_exist) = 0.
        """
        changes = changes_between(self.graph, graph)
        if not changes:
            return None
        Gatekeeper(self.graph).admit(graph, changes)
        self._forget_undone()
        commit = Commit(revision=self.revision + 1, author=author, reason=reason, changes=changes)
        write_atomic(self._commit_path(commit.revision), commit.model_dump_json())
        self._move_head(commit.revision, graph)
        return commit

    def undo(self) -> Commit | None:
        """Step back one commit and return it; None at the beginning."""
        if self.revision == 0:
            return None
        commit = self._read_commit(self.revision)
        self._move_head(self.revision - 1, apply(self.graph, commit, backwards=True))
        return commit

    def redo(self) -> Commit | None:
        """Step forward again; None where nothing was undone."""
        commit = self.next_commit()
        if commit is None:
            return None
        self._move_head(commit.revision, apply(self.graph, commit))
        return commit

    def next_commit(self) -> Commit | None:
        """Return the commit that ``redo`` would make again, if any."""
        known = self._commit_path(self.revision + 1).exists()
        return self._read_commit(self.revision + 1) if known else None

    def log(self) -> list[Commit]:
        """Return every commit up to the current revision, oldest first."""
        return [self._read_commit(revision) for revision in range(1, self.revision + 1)]

    def checkpoint(self) -> None:
        """Write ``graph.json`` at the current revision."""
        body = {"revision": self.revision, **self.graph.model_dump(mode="json")}
        write_atomic(self.path("graph.json"), json.dumps(body, indent=1, ensure_ascii=False))

    def record(self, event: Event) -> None:
        """Append an event to ``trace.jsonl``."""
        with self.path("trace.jsonl").open("a", encoding="utf-8") as file:
            file.write(event.model_dump_json(exclude_defaults=True) + "\n")

    def _refuse_foreign(self) -> None:
        """Refuse a file, and a folder of something else, before a lock is put there."""
        if not self.folder.exists():
            return
        if not self.folder.is_dir():
            raise InputError("is a file, not a project folder", mend="give another --out", path=self.folder)
        ours = any((self.folder / name).exists() for name in ("graph.json", "history"))
        if not ours and any(item.name != ".lock" for item in self.folder.iterdir()):
            raise InputError("is not empty and not a project", mend="give another --out", path=self.folder)

    def _load(self) -> tuple[ContinuityMemoryGraph, int]:
        path = self.folder / "graph.json"
        graph, revision = ContinuityMemoryGraph(), 0
        if path.exists():
            graph, revision = _read_graph(path)
        (self.folder / "history").mkdir(exist_ok=True)  # from here on a project, even if killed before its first commit
        head = self._head()
        while revision < head:
            graph, revision = apply(graph, self._read_commit(revision + 1)), revision + 1
        while revision > head:
            graph, revision = apply(graph, self._read_commit(revision), backwards=True), revision - 1
        return graph, revision

    def _forget_undone(self) -> None:
        """A new commit ends what could be redone. Latest first, and only once no checkpoint needs the way back."""
        undone = [path for path in self._history() if int(path.stem) > self.revision]
        if undone:
            self.checkpoint()
        for path in reversed(undone):
            path.unlink()

    def _history(self) -> list[Path]:
        return sorted((self.folder / "history").glob("[0-9]*.json"))

    def _head(self) -> int:
        path = self.folder / "history" / "HEAD"
        try:
            return int(path.read_bytes()) if path.exists() else 0
        except ValueError as error:
            raise InputError("the history is damaged here", mend=_RESTORE, path=path) from error

    def _move_head(self, revision: int, graph: ContinuityMemoryGraph) -> None:
        write_atomic(self.path("history", "HEAD"), str(revision))
        self.graph, self.revision = graph, revision  # at once: a run that is stopped here writes its checkpoint

    def _commit_path(self, revision: int) -> Path:
        return self.path("history", f"{revision:06d}.json")

    def _read_commit(self, revision: int) -> Commit:
        path = self._commit_path(revision)
        try:
            return Commit.model_validate_json(path.read_bytes())
        except (OSError, ValidationError) as error:
            raise InputError("the history is damaged here", mend=_RESTORE, path=path) from error


def read_project_graph(folder: Path) -> ContinuityMemoryGraph:
    """Read the graph of a project without locking it, for tools that only look.

    Raises:
        InputError: There is no project in the folder, or one that was killed before it was made.
    """
    path = folder / "graph.json"
    if not path.is_file() and (folder / "history").is_dir():
        mend = "run the same `storyblender make` again: it goes on where it was stopped"
        raise InputError("was stopped before it was made", mend=mend, path=folder)
    if not path.is_file():
        raise InputError("is not a StoryBlender project", mend="make one with `storyblender make SCRIPT`", path=folder)
    return _read_graph(path)[0]


def write_atomic(path: Path, content: str | bytes) -> None:
    """Write a file whole or not at all: a temporary neighbour is flushed, then renamed over it."""
    temporary = path.with_name(f".{path.name}.part")
    data = content.encode() if isinstance(content, str) else content
    try:
        with temporary.open("wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except OSError:
        temporary.unlink(missing_ok=True)
        raise


def _read_graph(path: Path) -> tuple[ContinuityMemoryGraph, int]:
    try:
        body: dict[str, Any] = json.loads(path.read_bytes())
        revision = int(body.pop("revision", 0))
        version = int(body.get("schema_version", 0))
        if version > SCHEMA_VERSION:
            raise InputError("was written by a newer StoryBlender", mend="update StoryBlender", path=path)
        while version < SCHEMA_VERSION:
            body = UPGRADES[version](body)
            version += 1
        return ContinuityMemoryGraph.model_validate(body), revision
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError("cannot be read as a project graph", mend=_RESTORE, path=path) from error
