"""What the program wrote into a project, and whether it is still as it was written.

``outputs.jsonl`` has a line for every file: its name, the digest of its content, and how the disk described it (size,
times, inode). A file whose description is the same needs no reading; any other is read and its digest compared. So a
file that is gone, cut short or changed is noticed when it is wanted, and a file that a person made or changed is
never deleted. A file is on disk before its line is written; a line that is lost or torn only means that a file
counts as unknown.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import stat
import threading
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path, PurePosixPath
from typing import TypeVar

from storyblender.folder import Folder

Content = TypeVar("Content")

RECORD = "outputs.jsonl"
_LONGEST, _DEEPEST = 255, 16
"""Bytes of a part of a name, and its parts, at most."""
_SPARE = 1000
"""Lines of the record that say nothing any more, from which on it is written anew."""


@dataclass(frozen=True)
class _Entry:
    """What is known of a file.

    Attributes:
        digest: Of its content.
        description: How the disk describes it; empty until it has taken its place.
        former: Digest of what the program wrote before under the name: there still if the run was killed.
    """

    digest: str
    description: str
    former: str

    def line(self, name: str) -> str:
        """Return it as a line of the record."""
        return json.dumps({"name": name, **asdict(self)}, ensure_ascii=False) + "\n"


class Outputs:
    """The files that the program wrote into a folder. Safe to use from several threads.

    Args:
        files: The folder; the caller holds the project's lock.
    """

    def __init__(self, files: Folder) -> None:
        self._files = files
        self._lock = threading.Lock()
        self.recorded = files.path(RECORD).exists()
        """Whether there was a record; an earlier version kept none."""
        self._known = self._read()

    def write(self, name: str, content: str | bytes) -> Path:
        """Write a file and note it. Raises InputError as ``Folder.write``."""
        data = content.encode() if isinstance(content, str) else content
        digest = hashlib.sha256(data).hexdigest()
        self._put(name, digest)
        path = self._files.write(name, data)
        self._put(name, digest, _description(path))
        return path

    @contextmanager
    def writing(self, name: str) -> Iterator[Path]:
        """Let a library write a file, and note it. Raises InputError as ``Folder.writing``."""
        with self._files.writing(name) as part:
            yield part
            digest = digest_of(part)
            self._put(name, digest)
        self._put(name, digest, _description(self._files.path(name)))

    def note(self, name: str) -> None:
        """Note a file, or a folder of files, that was just written and is on disk."""
        path = self._files.path(name)
        self._put(name, digest_of(path), _description(path))

    def known(self, name: str) -> bool:
        """Return whether the program wrote a file of this name, whatever became of it."""
        return name in self._known

    def whole(self, name: str) -> bool:
        """Return whether a file, or a folder of files, is there just as the program wrote it."""
        if name not in self._known:
            return False
        path, entry = self._files.path(name), self._known[name]
        try:
            now = _description(path)
            if now != entry.description and entry.digest == digest_of(path):
                self._put(name, entry.digest, now)
                return True
            return now == entry.description
        except OSError:
            return False

    def changed(self, name: str) -> bool:
        """Return whether there is something in a file that the program did not write."""
        path = self._files.path(name)
        if not path.is_file() or not path.stat().st_size or self.whole(name):
            return False
        return name not in self._known or self._known[name].former != digest_of(path)

    def read(self, name: str, parse: Callable[[bytes], Content]) -> Content | None:
        """Return what is in a file, or None where it is not as it was written or not what ``parse`` can read.

        Args:
            name: The file.
            parse: Raises ValueError at what it cannot read.
        """
        try:
            return parse(self._files.path(name).read_bytes()) if self.whole(name) else None
        except (OSError, ValueError):
            return None

    def digest(self, name: str) -> str:
        """Return the digest of a file as it was written; empty if it is unknown."""
        return self._known[name].digest if name in self._known else ""

    def delete(self, name: str) -> None:
        """Delete a file that the program wrote; one that a person made or changed stays."""
        if self.whole(name):
            self._files.delete(name)
        self._forget(name)

    def keep_only(self, prefix: str, names: Collection[str]) -> None:
        """Delete files that the program wrote, but for some; whatever a person made or changed stays.

        Args:
            prefix: How the names of these files begin, for example ``frames/``.
            names: The files to keep.
        """
        for name in sorted(self._known):
            if name.startswith(prefix) and name not in names:
                self.delete(name)

    def copy_aside(self, name: str, now: datetime) -> Path | None:
        """Copy a file that is not as the program wrote it, before it is overwritten.

        Args:
            name: The file.
            now: Local time, for the name of the copy: ``story 2026-11-22 14.05.blend``.

        Returns:
            The copy; None where there is nothing to lose.
        """
        if not self.changed(name):
            return None
        path = self._files.path(name)
        stem = f"{path.stem} {now:%Y-%m-%d %H.%M}"
        copy, number = path.with_name(f"{stem}{path.suffix}"), 1
        while copy.exists() or copy.is_symlink():
            number += 1
            copy = path.with_name(f"{stem} ({number}){path.suffix}")
        with self._files.writing(self._files.name_of(copy)) as part:
            shutil.copyfile(path, part)
        return copy

    def _put(self, name: str, digest: str, description: str = "") -> None:
        """Note a file; without a description before it takes its place, so that a run killed there knows both."""
        with self._lock:
            before = self._known.get(name, _Entry("", "", ""))
            former = before.former if before.digest == digest else before.digest
            self._known[name] = entry = _Entry(digest, description, former)
            self._files.append(RECORD, entry.line(name))

    def _forget(self, name: str) -> None:
        with self._lock:
            if self._known.pop(name, None) is not None:
                self._files.append(RECORD, f"{json.dumps({'name': name}, ensure_ascii=False)}\n")

    def _read(self) -> dict[str, _Entry]:
        path = self._files.path(RECORD)
        text = path.read_text(encoding="utf-8", errors="replace") if path.is_file() else ""
        lines = text.splitlines()
        known: dict[str, _Entry] = {}
        for line in lines:
            _take(line, known)
        if len(lines) > 2 * len(known) + _SPARE or (text and not text.endswith("\n")):
            self._files.write(RECORD, "".join(entry.line(name) for name, entry in known.items()))
        return known


def _take(line: str, known: dict[str, _Entry]) -> None:
    """Take over what a line of the record says; one that is torn or of something else says nothing."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return
    match entry:
        case {"name": str(name), "digest": str(digest), "description": str(description)} if _is_inside(name):
            known[name] = _Entry(digest, description, str(entry.get("former", "")))
        case {"name": str(name)}:
            known.pop(name, None)


def _is_inside(name: str) -> bool:
    """Return whether a name may be one of ours: of a file in the folder that a disk can have."""
    parts = PurePosixPath(name).parts
    try:
        long = any(len(part.encode()) > _LONGEST for part in parts) or len(parts) > _DEEPEST
    except UnicodeEncodeError:
        return False
    return bool(parts) and not long and not {"/", ".."}.intersection(parts) and "\0" not in name


def _files_of(path: Path) -> list[tuple[Path, os.stat_result]]:
    """Return a file, or every file in a folder in order, each with what the disk says of it.

    Raises:
        OSError: It is gone, or something else than files.
    """
    paths = [path]
    if stat.S_ISDIR(path.lstat().st_mode):
        paths = sorted(Path(folder, name) for folder, _, names in os.walk(path) for name in names)
    files = [(file, file.lstat()) for file in paths]
    if not all(stat.S_ISREG(seen.st_mode) for _, seen in files):
        raise OSError(f"{path} holds something else than files")
    return files


def _description(path: Path) -> str:
    """Return how the disk describes a file, or all in a folder: who writes to a file changes that."""
    files = _files_of(path)
    told = [f"{seen.st_size} {seen.st_mtime_ns} {seen.st_ctime_ns} {seen.st_ino}" for _, seen in files]
    return _one(path, files, told)


def digest_of(path: Path) -> str:
    """Return the digest of a file, or of all in a folder and their names."""
    files = _files_of(path)
    digests: list[str] = []
    for file, _ in files:
        with file.open("rb") as content:
            digests.append(hashlib.file_digest(content, "sha256").hexdigest())
    return _one(path, files, digests)


def _one(path: Path, files: list[tuple[Path, os.stat_result]], told: list[str]) -> str:
    """Return what is told of a file; for a folder, a digest of what is told of all in it."""
    if [file for file, _ in files] == [path]:
        return told[0]
    names = [file.relative_to(path).as_posix() for file, _ in files]
    return hashlib.sha256(json.dumps([names, told]).encode()).hexdigest()
