"""The one way to write and delete files of a project, in the client and in the workers.

Nothing outside the project is touched: a name never leaves the folder, and no link is followed. A file appears whole
or not at all: it is written as a part file private to this process, flushed to disk, then renamed. A library
that writes files itself gets a path in a private folder from ``Folder.writing``; call that path ``part``, then
``tests/unit/test_folder_is_the_only_writer.py`` lets it pass.
"""

from __future__ import annotations

import errno
import os
import re
import shutil
import stat
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from io import FileIO
from itertools import count
from pathlib import Path, PurePosixPath
from typing import BinaryIO

from storyblender.errors import InputError, StoryBlenderError

BUILD = "build"
"""First part of the names that may lie on another disk."""
_PART = ".part"
_LEFT = re.compile(r"\..+\.\d+-\d+\.part")
"""Name of a part file: hidden, with the file's name, the process and a number."""
_NO_LINK = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)
_TROUBLE = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EIO)
"""What a disk says when it cannot take a file, whichever library was writing."""
_LITTLE = 32 * 1024**2
"""Bytes. A library that fails with less than this left on the disk failed for want of room."""
_DEPTH = 2
"""Folders below each other in which files are written one by one; a folder further down is written as a whole."""
_SYNCS = 16
"""Files that are flushed side by side."""
_numbers = count(1)

FileState = tuple[int, int]
"""Time of the last change in ns, and size in bytes."""


class Folder:
    """A project folder that is written to.

    Every name is relative to the folder, with ``/`` between its parts.

    Args:
        root: The project folder.
        build: Where names below ``build/`` lie instead, for example on a larger disk.
    """

    def __init__(self, root: Path, build: Path | None = None) -> None:
        self.root = root.resolve()
        self.build = self.root / BUILD if build is None else build.resolve()

    def path(self, *names: str) -> Path:
        """Return where a file lies; it need not exist.

        Raises:
            InputError: The name leaves the folder, or a part of it is a link.
        """
        parts = PurePosixPath("/".join(names)).parts
        if not parts or "/" in parts or ".." in parts or any("\0" in part for part in parts):
            raise InputError(f"{'/'.join(names)!r} leaves the project folder")
        place = self.root
        if parts[0] == BUILD and self.build != self.root / BUILD:
            place, parts = self.build, parts[1:]
        for part in parts:
            place /= part
            try:
                linked = stat.S_ISLNK(place.lstat().st_mode)
            except (FileNotFoundError, NotADirectoryError):
                continue
            except OSError as error:
                raise InputError(f"cannot be read ({error.strerror})", mend="mend that", path=place) from error
            if linked:
                mend = "put a real file or folder in its place; `build` in the settings may name another disk"
                raise InputError("is a link, and nothing is written or deleted through links", mend=mend, path=place)
        return place

    def name_of(self, path: Path) -> str:
        """Return the name of a path in the folder; the other way round than ``path``."""
        if path.is_relative_to(self.build):
            return (PurePosixPath(BUILD) / path.relative_to(self.build).as_posix()).as_posix()
        return path.relative_to(self.root).as_posix()

    def write(self, name: str, content: str | bytes, *, private: bool = False) -> Path:
        """Write a file whole or not at all, text as UTF-8; on disk when this returns.

        Args:
            name: Of the file; folders above it are made.
            content: All of it.
            private: Whether only the user who runs the program can read it.

        Raises:
            InputError: The name leads out of the folder, or the disk cannot take the file.
        """
        place = self._with_parent(name)
        with _explained(place):
            part, file = _new_part(place, 0o600 if private else 0o666)
            try:
                with file:
                    file.write(content.encode() if isinstance(content, str) else content)
                    file.flush()
                    os.fsync(file.fileno())
                _take_place(part, place)
            except BaseException:
                part.unlink(missing_ok=True)
                raise
        return place

    @contextmanager
    def writing(self, name: str) -> Iterator[Path]:
        """Write a file through a library: yield a path in a private folder, renamed to ``name`` at the end.

        What else the library leaves beside it is deleted.

        Raises:
            InputError: The name leads out of the folder, or the disk cannot take the file.
        """
        with self.writing_tree(name, lone=True) as room:
            yield room / PurePosixPath(name).name

    @contextmanager
    def writing_tree(self, name: str, *, lone: bool = False, flush: bool = True) -> Iterator[Path]:
        """Write a folder of files: yield a private folder that is renamed to ``name`` at the end.

        Args:
            name: Of the folder; an existing one is replaced.
            lone: Move only the file called like ``name`` out of the private folder, in place of the folder itself.
            flush: False for what is checked by digest and can be made again: a power cut may damage it.

        Raises:
            InputError: The name leads out of the folder, or the disk cannot take the files.
        """
        place = self._with_parent(name)
        with _explained(place):
            room = _new_room(place)
        made = room / place.name if lone else room
        try:
            with _explained(place, body=True):
                yield room
            with _explained(place):
                if flush:
                    _sync_tree(made)
                if not lone and place.is_dir():
                    shutil.rmtree(place)
                _take_place(made, place)
        finally:
            shutil.rmtree(room, ignore_errors=True)

    def append(self, name: str, text: str) -> None:
        """Add text at the end of a file, made if it does not exist; not flushed to disk.

        Args:
            name: Of the file.
            text: Written as UTF-8, with the line ends that it has.

        Raises:
            InputError: As ``write``.
        """
        with self.log(name) as file, _explained(self.path(name)):
            left = text.encode()
            while left:
                left = left[file.write(left) or 0 :]

    def log(self, name: str) -> FileIO:
        """Open a file to add to, made if it does not exist, unbuffered.

        Raises:
            InputError: As ``write``.
        """
        place = self._with_parent(name)
        with _explained(place):
            file = _regular(place, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
            if os.fstat(file.fileno()).st_nlink == 1:
                return file
            file.close()  # a file of two names: the other one may lie anywhere, so this one becomes a file of its own
            self.write(name, place.read_bytes())
            return _regular(place, os.O_WRONLY | os.O_APPEND)

    def empty(self, name: str) -> None:
        """Truncate a file, if it exists; a process that has it open keeps writing to the same file.

        Raises:
            InputError: As ``write``.
        """
        place = self.path(name)
        if place.exists():
            with self.log(name) as file, _explained(place):
                os.ftruncate(file.fileno(), 0)

    def delete(self, name: str) -> None:
        """Delete a file or a folder with all in it, if there is one; links in it are deleted and not followed.

        Raises:
            InputError: The name leads out of the folder, or the disk refuses.
        """
        place = self.path(name)
        with _explained(place, "deleted"):
            if place.is_dir():
                shutil.rmtree(place)
            else:
                place.unlink(missing_ok=True)

    def state(self, name: str) -> FileState | None:
        """Return when a file was last written, in ns, and its size in bytes; None where there is none."""
        try:
            seen = self.path(name).stat()
        except FileNotFoundError:
            return None
        return seen.st_mtime_ns, seen.st_size

    def move(self, name: str, to: str) -> None:
        """Rename a file or a folder that is on disk; nothing of the new name may be there.

        Args:
            name: Of the file or the folder.
            to: Its new name; folders above it are made.

        Raises:
            InputError: As ``write``.
        """
        made, place = self.path(name), self._with_parent(to)
        with _explained(place):
            _take_place(made, place)

    def refuse_change(self, name: str, former: FileState | None) -> None:
        """Refuse to go on if a file was saved after its state was taken.

        Args:
            name: Of the file.
            former: What ``state`` returned then; None where there was no file.

        Raises:
            InputError: The file was saved.
        """
        if self.state(name) != former:
            mend = "run the same command again: it keeps a dated copy first"
            raise InputError("was saved while it was being written anew", mend=mend, path=self.path(name))

    def make_folder(self, name: str) -> Path:
        """Make a folder with its parents, if it does not exist, and return its path.

        Raises:
            InputError: As ``write``.
        """
        place = self.path(name)
        with _explained(place):
            _make(place)
        return place

    def make(self) -> None:
        """Make the project folder itself, if it does not exist.

        Raises:
            OSError: The disk refuses.
        """
        _make(self.root)

    def clear_parts(self) -> None:
        """Delete unfinished part files of killed runs. Call it only while holding the project's lock.

        Raises:
            InputError: The disk does not let a file be deleted.
        """
        for top in {self.root, self.build}:
            for folder, folders, names in os.walk(top):
                left = set(filter(_LEFT.fullmatch, (*folders, *names)))
                for name in sorted(left):
                    self.delete(self.name_of(Path(folder, name)))
                deep = len(Path(folder).relative_to(top).parts) == _DEPTH
                folders[:] = [] if deep else [name for name in folders if name not in left]

    def _with_parent(self, name: str) -> Path:
        place = self.path(name)
        with _explained(place):
            _make(place.parent)
        return place


@contextmanager
def _explained(place: Path, deed: str = "written", *, body: bool = False) -> Iterator[None]:
    """Turn what the disk says into one sentence.

    Args:
        place: The file.
        deed: What could not be done to it.
        body: The block runs a library: only errors of the disk are converted.
    """
    try:
        yield
    except StoryBlenderError:
        raise
    except OSError as error:
        if body and error.errno not in _TROUBLE and not (error.errno is None and _is_full(place)):
            raise
        raise _refusal(place, deed, error.strerror or "the disk is full", error.errno or errno.ENOSPC) from error
    except Exception as error:
        if not body or not _is_full(place):
            raise
        raise _refusal(place, deed, "the disk is full", errno.ENOSPC) from error


def _is_full(place: Path) -> bool:
    return shutil.disk_usage(place.parent).free < _LITTLE


def _refusal(place: Path, deed: str, reason: str, number: int | None) -> InputError:
    mend = "free some room on this disk" if number in (errno.ENOSPC, errno.EDQUOT) else "mend that"
    return InputError(
        f"cannot be {deed} ({reason})", mend=f"{mend}, then run the same command again to go on", path=place
    )


def _part_of(place: Path) -> Path:
    return place.with_name(f".{place.name}.{os.getpid()}-{next(_numbers)}{_PART}")


def _new_part(place: Path, mode: int) -> tuple[Path, BinaryIO]:
    """Open a part file that was not there before; ``mode`` says who may read and write it."""
    while True:
        part = _part_of(place)
        try:
            return part, os.fdopen(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL | _NO_LINK, mode), "wb")
        except FileExistsError:  # of a killed process that had our number
            continue


def _new_room(place: Path) -> Path:
    """Make a private folder that was not there before."""
    while True:
        room = _part_of(place)
        try:
            room.mkdir()
            return room
        except FileExistsError:
            continue


def _regular(place: Path, flags: int) -> FileIO:
    """Open a file for writing: no link, and nothing that waits for a reader."""
    file = FileIO(os.open(place, flags | _NO_LINK | getattr(os, "O_NONBLOCK", 0), 0o666), "wb")
    if stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        return file
    file.close()
    raise InputError("is not a file", mend="delete it", path=place)


def _make(folder: Path) -> None:
    """Make a folder with its parents; on disk when this returns."""
    missing: list[Path] = []
    while not folder.is_dir():
        missing.append(folder)
        folder = folder.parent
    for path in reversed(missing):
        path.mkdir(exist_ok=True)
        _sync(path.parent)


def _take_place(made: Path, place: Path) -> None:
    os.replace(made, place)  # noqa: PTH105 - tests let each call to the system fail in turn
    _sync(place.parent)


def _sync_tree(made: Path) -> None:
    """Wait until a file, or a folder with all in it, is on disk: side by side, which takes a tenth of the time."""
    with ThreadPoolExecutor(_SYNCS) as threads:
        list(threads.map(_sync, [Path(folder, name) for folder, _, names in os.walk(made) for name in names]))
    _sync(made)


def _sync(path: Path) -> None:
    """Wait until a file, or the names in a folder, are on disk."""
    if path.is_dir() and not hasattr(os, "O_DIRECTORY"):  # a system where folders cannot be opened
        return
    handle = os.open(path, os.O_RDONLY | _NO_LINK)
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno != errno.EINVAL:  # a file system that cannot, such as some network folders
            raise
    finally:
        os.close(handle)
