"""The record of files that the program wrote into a project, and whether they are still unchanged.

``outputs.jsonl`` has a line for every file: its name, the digest of its content, and how the disk described it (size,
times, inode). A file whose description is the same need not be read; any other is read and its digest compared. So
a missing, truncated or changed file is noticed when it is needed, and a file that a person made or changed is never
deleted. A file is on disk before its line is written; if a line is lost or torn, the file counts as unknown.
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
"""Number of obsolete lines from which the record is rewritten."""


@dataclass(frozen=True)
class _Entry:
    """The record of one file.

    Attributes:
        digest: Of its content.
        description: Size, times and inode; empty until the file is in place.
        former: Digest of the version before; that is still in place if the run was killed.
    """

    digest: str
    description: str
    former: str

    def line(self, name: str) -> str:
        """Return the entry as a line of ``outputs.jsonl``."""
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
        """Whether the project has a record; projects of early versions have none."""
        self._known = self._read()
        self._digests: dict[str, tuple[str, str]] = {}
        """Of files that were written by others: the description at which each was read, and its digest."""

    def write(self, name: str, content: str | bytes) -> Path:
        """Write a file and note it; takes, returns and raises what ``Folder.write`` does."""
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
        """Return whether the program ever wrote a file of this name."""
        return name in self._known

    def whole(self, name: str) -> bool:
        """Return whether a file, or a folder of files, exists unchanged since the program wrote it."""
        if name not in self._known:
            return False
        path, entry = self._files.path(name), self._known[name]
        try:
            now = _description(path)
            if now != entry.description and entry.digest == self._digest_at(now, name, path):
                self._put(name, entry.digest, now)
                return True
            return now == entry.description
        except OSError:
            return False

    def changed(self, name: str) -> bool:
        """Return whether a file exists whose content the program did not write."""
        path = self._files.path(name)
        if not path.is_file() or not path.stat().st_size or self.whole(name):
            return False
        return name not in self._known or self._known[name].former != self._digest_at(_description(path), name, path)

    def read(self, name: str, parse: Callable[[bytes], Content]) -> Content | None:
        """Return the parsed content of a file, or None if the file was changed or cannot be parsed.

        Args:
            name: The file.
            parse: Turns bytes into content; raises ValueError if it cannot.
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
        """Delete files under a prefix that the program wrote, except some; what a person made or changed stays.

        Args:
            prefix: How the names of these files begin, for example ``frames/``.
            names: The files to keep.
        """
        for name in sorted(self._known):
            if name.startswith(prefix) and name not in names:
                self.delete(name)

    def copy_aside(self, name: str, now: datetime) -> Path | None:
        """Copy a file with changes by a person, before it is overwritten.

        Args:
            name: The file.
            now: Local time, for the name of the copy: ``story 2026-11-22 14.05.blend``.

        Returns:
            The copy; None if there are no such changes.
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
        """Record a file; without a description until it is in place, so that a killed run knows both versions."""
        with self._lock:
            before = self._known.get(name, _Entry("", "", ""))
            former = before.former if before.digest == digest else before.digest
            self._known[name] = entry = _Entry(digest, description, former)
            self._files.append(RECORD, entry.line(name))

    def _digest_at(self, description: str, name: str, path: Path) -> str:
        """Return the digest of a file, which is read again only where its description is another one."""
        read_at, digest = self._digests.get(name, ("", ""))
        if read_at != description:
            digest = digest_of(path)
            self._digests[name] = description, digest
        return digest

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
            _add_line(line, known)
        if len(lines) > 2 * len(known) + _SPARE or (text and not text.endswith("\n")):
            self._files.write(RECORD, "".join(entry.line(name) for name, entry in known.items()))
        return known


def _add_line(line: str, known: dict[str, _Entry]) -> None:
    """Apply a line of the record to the known entries; a torn or foreign line is ignored."""
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
    """Return whether a name is that of a possible file inside the folder."""
    parts = PurePosixPath(name).parts
    try:
        long = any(len(part.encode()) > _LONGEST for part in parts) or len(parts) > _DEEPEST
    except UnicodeEncodeError:
        return False
    return bool(parts) and not long and not {"/", ".."}.intersection(parts) and "\0" not in name


def _files_of(path: Path) -> list[tuple[Path, os.stat_result]]:
    """Return a file, or every file in a folder in order, each with its stat result.

    Raises:
        OSError: It is missing, or holds something other than regular files.
    """
    paths = [path]
    if stat.S_ISDIR(path.lstat().st_mode):
        paths = sorted(Path(folder, name) for folder, _, names in os.walk(path) for name in names)
    files = [(file, file.lstat()) for file in paths]
    if not all(stat.S_ISREG(seen.st_mode) for _, seen in files):
        raise OSError(f"{path} holds something else than files")
    return files


def _description(path: Path) -> str:
    """Return size, times and inode of a file, or a digest of those of a folder; any write changes them."""
    files = _files_of(path)
    stats = [f"{seen.st_size} {seen.st_mtime_ns} {seen.st_ctime_ns} {seen.st_ino}" for _, seen in files]
    return _joined(path, files, stats)


def digest_of(path: Path) -> str:
    """Return the digest of a file, or of all in a folder and their names."""
    files = _files_of(path)
    digests: list[str] = []
    for file, _ in files:
        with file.open("rb") as content:
            digests.append(hashlib.file_digest(content, "sha256").hexdigest())
    return _joined(path, files, digests)


def _joined(path: Path, files: list[tuple[Path, os.stat_result]], texts: list[str]) -> str:
    """Return the text of a single file, or for a folder one digest of the names and texts of all its files."""
    if [file for file, _ in files] == [path]:
        return texts[0]
    names = [file.relative_to(path).as_posix() for file, _ in files]
    return hashlib.sha256(json.dumps([names, texts]).encode()).hexdigest()
