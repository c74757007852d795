"""The project folder on disk: graph, history, trace, frames. Atomic writes, one writer, resume after a kill.

A commit is written as ``history/NNNNNN.json`` and then made current by ``history/HEAD``; ``graph.json`` is a
checkpoint brought up to HEAD on opening. Killed at any instant, the folder opens at the last whole commit.
``history_files`` reads all three.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from contextlib import suppress
from datetime import datetime
from functools import cached_property
from pathlib import Path
from types import TracebackType

from filelock import FileLock, Timeout

from storyblender import history_files
from storyblender.catalog.motions import MOTIONS
from storyblender.errors import InputError, ProjectLocked, Rejected
from storyblender.folder import Folder
from storyblender.history_files import GRAPH, HEAD, HISTORY, Saved, commit_name
from storyblender.memory.base import content_hash
from storyblender.memory.gatekeeper import Gatekeeper
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import CAUSED_BY_PERSON, TRIAL, Commit, apply, changes_between
from storyblender.outputs import Outputs
from storyblender.set_aside import SetAside
from storyblender.trace import Event

TRACE, DRAFTS = "trace.jsonl", "drafts.jsonl"
"""What the crew proposed and how it scored, and the drafts themselves by digest."""
SCRIPTS = "history/scripts"
"""A copy of each script that was planned, and of its corrected reading, named by the plan's digest."""
KEPT_READING = "reading.json"
"""The corrected reading that a project was made with."""


class Project:
    """An open project. Use as a context manager: it holds the folder's lock.

    Args:
        folder: ``NAME.storyboard``; made if it does not exist.
        build: Where names below ``build/`` lie instead.

    Raises:
        ProjectLocked: Another run has it open.
        InputError: The folder holds something else, or a graph that cannot be read.
    """

    def __init__(self, folder: Path, build: Path | None = None) -> None:
        self.folder = folder.resolve()
        self.files = Folder(self.folder, build)
        """The only way to write and delete here."""
        try:
            self._refuse_foreign()
            self.files.make()
            self.files.path(".lock")  # refuses a link
        except OSError as error:
            mend = "give another --out, or mend that, then run the same command again to go on"
            raise InputError(f"cannot make the folder ({error.strerror})", mend=mend, path=folder) from error
        self._lock = FileLock(self.folder / ".lock", timeout=0, thread_local=False)  # any thread may close it
        try:
            self._lock.acquire()
        except Timeout as error:
            raise ProjectLocked(
                f"{folder}: the studio or another run has it open; use it there, close that, or wait for it"
            ) from error
        except OSError as error:
            raise InputError(f"cannot be locked ({error.strerror})", mend="give another --out", path=folder) from error
        try:
            saved = history_files.load(self.folder)
            self.files.clear_parts()
            self.files.make_folder(HISTORY)  # from here on a project, even if killed before its first commit
        except BaseException:
            self._lock.release()
            raise
        self.graph, self.revision, self._digest = saved.graph, saved.revision, saved.digest
        self._redoable = True
        """There may be undone commits: to look for them takes longer the longer the history is."""
        self._drafts: set[str] = set()
        self.notices = saved.notices
        """What a person should know about how the project was found, one sentence each."""
        if self.notices:
            self._move_head(saved)

    def __enter__(self) -> Project:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        try:
            self.checkpoint()
        except InputError:
            if error is None:  # else that error is the one to hear of, and the history has all
                raise
        finally:
            self._lock.release()

    @cached_property
    def outputs(self) -> Outputs:
        """What the program wrote here, but for the graph and its history."""
        return Outputs(self.files)

    @cached_property
    def set_aside(self) -> SetAside:
        """Undone commits whose place in the line has been taken."""
        return SetAside(self.files)

    @property
    def version(self) -> str:
        """The revision with the digest of its commit: after an undo, other commits may have the same numbers."""
        return f"{self.revision}.{self._digest[:8]}"

    def path(self, *parts: str) -> Path:
        """Return where a file lies. Raises InputError if that is outside the folder or behind a link."""
        return self.files.path(*parts)

    def commit(self, graph: ContinuityMemoryGraph, author: str, reason: str) -> Commit | None:
        """Write ``graph`` as the next revision if the Gatekeeper lets it in; None where nothing changed.

        Args:
            graph: The whole new state.
            author: Name of the role, ``user`` or ``sync``.
            reason: What was done, for the history.

        Raises:
            Rejected: The new state cannot be, V(o_new, S_exist) = 0; the graph stays as it was.
        """
        changes = changes_between(self.graph, graph)
        if not changes:
            return None
        commit = Commit(
            revision=self.revision + 1, author=author, reason=reason, changes=changes, parent=self._digest
        ).sealed()
        try:
            graph = apply(self.graph, commit)  # as it will be read again
        except ValueError as error:
            raise Rejected((str(error),)) from error
        Gatekeeper(self.graph, MOTIONS).admit(graph, changes, author)
        self._end_undone(author)
        self.files.write(commit_name(commit.revision), commit.model_dump_json())
        self._move_head(Saved(graph, commit.revision, commit.digest))
        return commit

    def go_to(self, revision: int) -> None:
        """Undo or redo as many commits as lie between, all or none.

        Raises:
            InputError: A commit between is missing or damaged.
        """
        self._redoable = True
        saved = history_files.moved(self._saved, revision, self.folder)
        if saved.graph.plan_digest not in ("", self.graph.plan_digest):
            self._restore_sources(saved.graph.plan_digest)
        self._move_head(saved)

    def drop(self, revision: int) -> None:
        """Take commits back for good, as if they had never been made; what could be redone before them can be again.

        Args:
            revision: To go back to.
        """
        self.go_to(revision)
        self._cut_off()

    def bring_back(self, base: int, commits: Sequence[Commit]) -> None:
        """Put undone commits that were set aside in the place of what the crew did since.

        Args:
            base: Revision that the first of them was made on.
            commits: In order.
        """
        self.drop(base)
        for commit in commits:
            self.files.write(commit_name(commit.revision), commit.model_dump_json())
        self.go_to(commits[-1].revision)
        self.set_aside.forget(*commits)

    def log(self) -> list[Commit]:
        """Return every commit up to the current revision, oldest first."""
        return [*self.backwards()][::-1]

    @property
    def has_undone(self) -> bool:
        """Whether the commit after the current one is there, undone; what was set aside is not in line."""
        return (self.folder / commit_name(self.revision + 1)).exists()

    def forwards(self) -> Iterator[Commit]:
        """Yield every commit that was undone, the next one first."""
        revision = self.revision + 1
        while (self.folder / commit_name(revision)).exists():
            yield history_files.read_commit(self.folder, revision)
            revision += 1

    def backwards(self) -> Iterator[Commit]:
        """Yield every commit from the current revision back, reading only as many as are taken."""
        for revision in range(self.revision, 0, -1):
            yield history_files.read_commit(self.folder, revision)

    def checkpoint(self) -> None:
        """Write ``graph.json`` at the current revision."""
        self.files.write(GRAPH, history_files.graph_text(self._saved))

    @property
    def _saved(self) -> Saved:
        return Saved(self.graph, self.revision, self._digest)

    def record(self, event: Event) -> None:
        """Append an event to ``trace.jsonl``, and its draft, once, to ``drafts.jsonl``."""
        if event.draft:
            digest = content_hash(event.draft)
            if digest not in self._drafts:
                self.files.append(DRAFTS, json.dumps({"digest": digest, "draft": event.draft}) + "\n")
                self._drafts.add(digest)
            event = event.model_copy(update={"draft": digest})
        self.files.append(TRACE, event.model_dump_json(exclude_defaults=True) + "\n")

    def _refuse_foreign(self) -> None:
        """Refuse a file, and a folder of something else, before a lock is put there."""
        if not self.folder.exists():
            return
        if not self.folder.is_dir():
            raise InputError("is a file, not a project folder", mend="give another --out", path=self.folder)
        ours = any((self.folder / name).exists() for name in (GRAPH, HISTORY))
        if not ours and any(item.name != ".lock" for item in self.folder.iterdir()):
            raise InputError("is not empty and not a project", mend="give another --out", path=self.folder)

    def _end_undone(self, author: str) -> None:
        """Forget what could be redone for a person's commit; for another one, set it aside where it is in the way."""
        if author in CAUSED_BY_PERSON and author != TRIAL:
            if self._redoable:
                self.set_aside.forget()
                self._cut_off()
                self._redoable = False
        elif self.has_undone:
            with suppress(InputError):  # one that cannot be read cannot be redone either
                for commit in self.forwards():
                    self.set_aside.keep(commit)
            self._cut_off()

    def _cut_off(self) -> None:
        """Delete the commits after the current one: latest first, and only once no checkpoint needs the way back."""
        later = [revision for revision in history_files.commit_revisions(self.folder) if revision > self.revision]
        if later:
            self.checkpoint()
        for revision in reversed(later):
            self.files.delete(commit_name(revision))

    def _restore_sources(self, plan_digest: str) -> None:
        """Put the script of a plan, and its corrected reading if it has one, back beside the graph."""
        former, now = (self.folder / reading_copy(digest) for digest in (self.graph.plan_digest, plan_digest))
        kept = self.path(KEPT_READING)
        if former.is_file() and not now.is_file() and kept.is_file() and kept.read_bytes() == former.read_bytes():
            self.files.delete(KEPT_READING)
        for copy in sorted((self.folder / SCRIPTS).glob(f"{plan_digest}.*")):
            if copy.is_file():
                name = KEPT_READING if copy.name == now.name else f"script{copy.suffix}"
                if self.outputs.known(name):
                    self.outputs.copy_aside(name, datetime.now())
                self.outputs.write(name, self.path(f"{SCRIPTS}/{copy.name}").read_bytes())

    def _move_head(self, saved: Saved) -> None:
        self.files.write(HEAD, history_files.head_text(saved.revision, saved.digest))
        # At once: a run that is stopped here writes its checkpoint.
        self.graph, self.revision, self._digest = saved.graph, saved.revision, saved.digest


def reading_copy(plan_digest: str) -> str:
    """Return the name of the copy of a plan's corrected reading."""
    return f"{SCRIPTS}/{plan_digest}.{KEPT_READING}"


def read_project_graph(folder: Path) -> ContinuityMemoryGraph:
    """Read the graph of a project without locking it, for tools that only look.

    Raises:
        InputError: There is no project in the folder, or one that was killed before it was made.
    """
    if not any((folder / name).exists() for name in (GRAPH, HISTORY)):
        raise InputError("is not a StoryBlender project", mend="make one with `storyblender make SCRIPT`", path=folder)
    saved = history_files.load(folder)
    if saved.revision == 0:
        mend = "run the same `storyblender make` again: it goes on where it was stopped"
        raise InputError("was stopped before it was made", mend=mend, path=folder)
    return saved.graph
