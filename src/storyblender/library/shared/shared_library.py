"""The user's library as one value: entries with their files, and the jobs that were paid for.

``files/<aa>/<digest>/`` has the files of a bundle, ``files/<aa>/<digest>.json`` what is known of it, ``index.sqlite``
finds it. Files are on disk before their row is, so a row always has files; a bundle whose files are not as their digest
says is treated as missing. Nothing is made on disk, and SQLite is not loaded, before there is something to keep.
"""

from __future__ import annotations

import json
import re
import secrets
import shutil
import time
from collections.abc import Iterable
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from pydantic import ValidationError

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.named_models import words_told
from storyblender.library.shared.entries import EntryFacts, EntryKind, LibraryEntry
from storyblender.library.shared.place import library_folder
from storyblender.outputs import digest_of

if TYPE_CHECKING:
    from storyblender.library.shared.built_geometry import BuiltGeometry
    from storyblender.library.shared.index import Index
    from storyblender.library.shared.jobs import JobLedger
    from storyblender.library.shared.uses import Uses

INDEX = "index.sqlite"
FILES, INCOMING, THUMBNAILS = "files", "incoming", "thumbnails"


class SharedLibrary:
    """A library that all projects and processes of a user share.

    Args:
        root: Its folder; it need not exist.
    """

    def __init__(self, root: Path) -> None:
        self.files = Folder(root)
        self._opened: Index | None = None

    @classmethod
    def open(cls, path: Path | None = None) -> SharedLibrary:
        """Return the library in a folder, the user's own if none is given. Nothing is read or made yet."""
        return cls(library_folder() if path is None else path)

    def index(self, make: bool = False) -> Index | None:
        """Return the index; None where there is no library yet, unless one is to be made.

        Raises:
            InputError: It cannot be opened.
        """
        if self._opened is None:
            path = self.files.root / INDEX
            if not make and not path.exists():
                return None
            from storyblender.library.shared.index import Index

            self.files.make_folder(FILES)
            self._opened = Index(path)
        return self._opened

    def close_index(self) -> None:
        """Close the index; it is opened again when it is needed."""
        if self._opened is not None:
            self._opened.close()
            self._opened = None

    @property
    def jobs(self) -> JobLedger:
        """The ledger of paid work."""
        from storyblender.library.shared.jobs import JobLedger

        return JobLedger(self.index, self.files)

    @property
    def uses(self) -> Uses:
        """What stories asked for, and how they got it."""
        from storyblender.library.shared.uses import Uses

        return Uses(self.index)

    @property
    def geometry(self) -> BuiltGeometry:
        """What was built for stories."""
        from storyblender.library.shared.built_geometry import BuiltGeometry

        return BuiltGeometry(self)

    def add(self, facts: EntryFacts, folder: Path) -> LibraryEntry:
        """Keep a bundle of files; if it is there already, return what is known of it.

        Args:
            facts: What is known of it.
            folder: Its files, which are copied: the main file, what that names, and ``credits.toml``.

        Raises:
            InputError: The main file is missing, something is no plain file, or the disk cannot take it.
        """
        if not (folder / facts.main).is_file():
            raise InputError(f"has no file {facts.main!r}", path=folder)
        index, incoming = self.index(make=True), f"{INCOMING}/{secrets.token_hex(8)}"
        assert index is not None, "made where there was none"
        try:
            with self.files.writing_tree(incoming) as part:
                shutil.copytree(folder, part, symlinks=True, dirs_exist_ok=True)
                digest, size = _digest(part), sum(path.stat().st_size for path in part.rglob("*") if path.is_file())
                main_digest = digest_of(part / facts.main)
            entry = LibraryEntry(**facts.model_dump(), digest=digest, bytes=size)
            with index.writing() as db:
                known = self._row(digest)
                if not self._is_whole(digest):
                    self.files.delete(_bundle(digest))
                    self.files.move(incoming, _bundle(digest))
                if known is None:
                    self.files.write(_record(digest), entry.model_dump_json(indent=1))
                    values = (digest, entry.kind, entry.name, json.dumps(entry.words), entry.category, entry.source)
                    row = (*values, entry.model_dump_json(), time.time(), main_digest)
                    db.execute("INSERT OR REPLACE INTO entries VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", row)
                    nouns = {(word, digest) for name in entry.names for word in words_told(name)}
                    db.executemany("INSERT OR IGNORE INTO nouns VALUES (?, ?)", nouns)
                if facts.source_id:
                    origin = (facts.source, facts.source_id, digest)
                    db.execute("INSERT OR REPLACE INTO origins VALUES (?, ?, ?)", origin)
                if facts.request:
                    db.execute("INSERT OR REPLACE INTO requests VALUES (?, ?)", (facts.request, digest))
        finally:
            self.files.delete(incoming)
        return known or entry

    def get(self, digest: str) -> LibraryEntry | None:
        """Return an entry whose files are whole, by its digest."""
        entry = self._row(digest)
        return entry if entry is not None and self._is_whole(entry.digest) else None

    def entries(self, digests: Iterable[str]) -> list[LibraryEntry]:
        """Return the entries of some digests in that order; their files are not checked."""
        return [entry for digest in digests if (entry := self._row(digest)) is not None]

    def by_source(self, source: str, source_id: str) -> LibraryEntry | None:
        """Return what came from a source, if it is here and whole.

        Args:
            source: Name of the source.
            source_id: What the source calls it.
        """
        return self._named("SELECT digest FROM origins WHERE source = ? AND source_id = ?", source, source_id)

    def by_request(self, request: str) -> LibraryEntry | None:
        """Return what was made for a request, by its digest, if it is here and whole."""
        return self._named("SELECT digest FROM requests WHERE request = ?", request)

    def by_main(self, digest: str) -> LibraryEntry | None:
        """Return the entry whose main file has a digest, SHA-256, if it is whole."""
        return self._named("SELECT digest FROM entries WHERE main_digest = ?", digest) if digest else None

    def has_since(self, entry: LibraryEntry) -> float:
        """Return when an entry came into the library, in seconds since 1970."""
        index = self.index()
        assert index is not None, "it has the entry"
        with index.reading() as db:
            row = db.execute("SELECT added FROM entries WHERE digest = ?", (entry.digest,)).fetchone()
        return row[0] if row else 0.0

    def told(self, text: str) -> LibraryEntry | None:
        """Return the one entry that a person means, as ``all_told``; None if it is none or several."""
        found = self.all_told(text)
        return found[0] if len(found) == 1 else None

    def all_told(self, text: str) -> list[LibraryEntry]:
        """Return the entries that a person may mean, whole or not: by digest or its first digits, by key, or by name.

        Args:
            text: At least eight digits of a digest, ``<source>/<id>/<file>`` as in a story's credits, or a name.
        """
        first, second, *_ = [*PurePosixPath(text).parts, "", ""]
        digits = second if first == "library" else text
        if re.fullmatch(r"[0-9a-f]{8,64}", digits):
            found = self._digests("SELECT digest FROM entries WHERE digest GLOB ?", f"{digits}*")
        else:
            found = self._digests("SELECT digest FROM origins WHERE source = ? AND source_id = ?", first, second)
            found = found or self._digests("SELECT digest FROM entries WHERE name = ? COLLATE NOCASE", text)
        return list(self.entries(found))

    def find(self, words: str = "", kind: EntryKind | None = None, source: str = "") -> list[LibraryEntry]:
        """Return entries for a person to look at, the newest first; their files are not checked.

        Args:
            words: All of them are in the name, the further words, the category or the credit.
            kind: None for any.
            source: Empty for any.
        """
        index = self.index()
        if index is None:
            return []
        query, values = "SELECT facts FROM entries WHERE 1", []
        for column, value in (("kind", kind), ("source", source)):
            if value:
                query, values = f"{query} AND {column} = ?", [*values, value]
        for word in words.split():
            query, values = f"{query} AND instr(lower(facts), lower(?))", [*values, json.dumps(word)[1:-1]]
        with index.reading() as db:
            rows = db.execute(f"{query} ORDER BY added DESC, digest", values).fetchall()
        return [entry for (facts,) in rows if (entry := read_entry(facts)) is not None]

    def path_of(self, entry: LibraryEntry) -> Path:
        """Return where the main file of an entry lies."""
        return self.files.path(_bundle(entry.digest), entry.main)

    def bundle_of(self, entry: LibraryEntry) -> Path:
        """Return the folder with the files of an entry."""
        return self.files.path(_bundle(entry.digest))

    def thumbnail_of(self, entry: LibraryEntry) -> Path:
        """Return where the picture of an entry lies once it is drawn."""
        return self.picture(entry.digest)

    def picture(self, digest: str) -> Path:
        """Return where the picture of an entry lies, by its digest, once it is drawn."""
        return self.files.path(THUMBNAILS, f"{digest}.png")

    def is_in(self, entry: LibraryEntry, files: Folder, name: str) -> bool:
        """Return whether a project has the files of an entry, whole, in a folder; takes what ``put_into`` does."""
        try:
            return digest_of(files.path(name)) == entry.digest
        except OSError:
            return False

    def put_into(self, entry: LibraryEntry, files: Folder, name: str) -> str:
        """Copy the files of an entry into a project.

        Args:
            entry: Of this library.
            files: The project folder.
            name: Of the folder in it that the files are written to; one that is there is replaced.

        Returns:
            Name of the main file in the project.

        Raises:
            InputError: The entry's files are gone or damaged, or the disk cannot take them.
        """
        with files.writing_tree(name) as part:
            try:
                shutil.copytree(self.files.path(_bundle(entry.digest)), part, symlinks=True, dirs_exist_ok=True)
                whole = digest_of(part) == entry.digest
            except OSError:
                whole = False
            if not whole:
                mend = "`storyblender library clean` forgets what is damaged"
                raise InputError(f"the library's {entry.name!r} is missing or damaged", mend=mend)
        return (PurePosixPath(name) / entry.main).as_posix()

    def remove(self, entry: LibraryEntry) -> None:
        """Forget an entry and delete its files; how often it was used stays in the figures."""
        index = self.index()
        if index is None:
            return
        with index.writing() as db:
            for table in ("entries", "origins", "requests", "nouns", "vectors"):
                db.execute(f"DELETE FROM {table} WHERE digest = ?", (entry.digest,))
        for name in (_record(entry.digest), _bundle(entry.digest), f"{THUMBNAILS}/{entry.digest}.png"):
            self.files.delete(name)

    def _named(self, query: str, *values: str) -> LibraryEntry | None:
        found = self._digests(query, *values)
        return self.get(found[0]) if found else None

    def _digests(self, query: str, *values: str) -> list[str]:
        index = self.index()
        if index is None:
            return []
        with index.reading() as db:
            return [row[0] for row in db.execute(query, values)]

    def _row(self, digest: str) -> LibraryEntry | None:
        index = self.index()
        if index is None:
            return None
        with index.reading() as db:
            row = db.execute("SELECT facts FROM entries WHERE digest = ?", (digest,)).fetchone()
        return None if row is None else read_entry(row[0])

    def _is_whole(self, digest: str) -> bool:
        """Return whether the files of a bundle are as its digest says."""
        try:
            return digest_of(self.files.path(_bundle(digest))) == digest
        except (OSError, InputError):
            return False


def _bundle(digest: str) -> str:
    return f"{FILES}/{digest[:2]}/{digest}"


def _record(digest: str) -> str:
    return f"{_bundle(digest)}.json"


def _digest(folder: Path) -> str:
    """Return the digest of a folder of plain files. Raises InputError for anything else in it."""
    try:
        return digest_of(folder)
    except OSError as error:
        raise InputError("a bundle has plain files only, no links", mend="copy the files themselves") from error


def read_entry(facts: str) -> LibraryEntry | None:
    """Return an entry as its row or its record has it; None where that is damaged."""
    try:
        return LibraryEntry.model_validate_json(facts)
    except (ValidationError, TypeError):
        return None
