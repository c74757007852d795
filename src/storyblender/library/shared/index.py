"""The index of the user's library: SQLite in WAL mode, for many processes at once."""

from __future__ import annotations

import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from storyblender.errors import InputError

VERSION = 1
"""Raised when tables change."""
PATIENCE = 60.0
"""Seconds to wait while another process writes."""
_TABLES = """
CREATE TABLE IF NOT EXISTS entries (
  digest TEXT PRIMARY KEY, kind TEXT NOT NULL, name TEXT NOT NULL, words TEXT NOT NULL, category TEXT NOT NULL,
  source TEXT NOT NULL, facts TEXT NOT NULL, added REAL NOT NULL, main_digest TEXT NOT NULL);
CREATE INDEX IF NOT EXISTS entries_by_main ON entries (main_digest);
CREATE TABLE IF NOT EXISTS origins (
  source TEXT NOT NULL, source_id TEXT NOT NULL, digest TEXT NOT NULL, PRIMARY KEY (source, source_id));
CREATE TABLE IF NOT EXISTS requests (request TEXT PRIMARY KEY, digest TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS nouns (noun TEXT NOT NULL, digest TEXT NOT NULL, PRIMARY KEY (noun, digest)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS vectors (
  digest TEXT NOT NULL, width INTEGER NOT NULL, phrase TEXT NOT NULL, vector BLOB NOT NULL,
  PRIMARY KEY (digest, width));
CREATE TABLE IF NOT EXISTS uses (
  project TEXT NOT NULL, asset TEXT NOT NULL, model TEXT NOT NULL, name TEXT NOT NULL, category TEXT NOT NULL,
  origin TEXT NOT NULL, entry TEXT NOT NULL, places INTEGER NOT NULL, noted REAL NOT NULL,
  PRIMARY KEY (project, asset, model));
CREATE TABLE IF NOT EXISTS jobs (
  id INTEGER PRIMARY KEY AUTOINCREMENT, request TEXT NOT NULL, service TEXT NOT NULL, price REAL NOT NULL,
  state TEXT NOT NULL, remote_id TEXT NOT NULL DEFAULT '', entry TEXT NOT NULL DEFAULT '',
  reason TEXT NOT NULL DEFAULT '', began REAL NOT NULL, changed REAL NOT NULL);
CREATE INDEX IF NOT EXISTS jobs_by_request ON jobs (request, service);
CREATE TABLE IF NOT EXISTS geometry (
  key TEXT PRIMARY KEY, place TEXT NOT NULL, content TEXT NOT NULL, bytes INTEGER NOT NULL, used REAL NOT NULL);
"""


class DamagedIndex(InputError):
    """The index is no database that can be read."""


class Index:
    """An open index. Safe to use from several threads and processes.

    Args:
        path: The file; made with its tables if it does not exist, in a folder that does.

    Raises:
        InputError: It cannot be opened.
    """

    def __init__(self, path: Path) -> None:
        self._path, self._lock = path, threading.RLock()
        with self._explained():
            self._connection = sqlite3.connect(path, timeout=PATIENCE, isolation_level=None, check_same_thread=False)
            self._connection.execute("PRAGMA journal_mode = WAL")
            self._connection.execute("PRAGMA synchronous = FULL")  # what was paid for is on disk before we go on
            (version,) = self._connection.execute("PRAGMA user_version").fetchone()
        if version > VERSION:
            mend = "update StoryBlender, or name another folder in STORYBLENDER_LIBRARY"
            raise InputError("the library was made by a newer StoryBlender", mend=mend, path=path)
        if version < VERSION:
            with self.writing() as db:
                for statement in _TABLES.split(";\n"):
                    db.execute(statement)
                db.execute(f"PRAGMA user_version = {VERSION}")

    @contextmanager
    def reading(self) -> Iterator[sqlite3.Connection]:
        """Yield the connection for queries. Raises InputError where the index cannot be read."""
        with self._lock, self._explained():
            yield self._connection

    @contextmanager
    def writing(self) -> Iterator[sqlite3.Connection]:
        """Yield the connection in a transaction, alone among all processes; on disk when this ends without an error.

        Raises:
            InputError: The index cannot be written.
        """
        with self._lock, self._explained():
            self._connection.execute("BEGIN IMMEDIATE")
            try:
                yield self._connection
                self._connection.execute("COMMIT")
            except BaseException:
                if self._connection.in_transaction:
                    self._connection.execute("ROLLBACK")
                raise

    def check(self) -> None:
        """Read the whole index. Raises DamagedIndex where a part of it cannot be read."""
        with self.reading() as db:
            (found,) = db.execute("PRAGMA quick_check(1)").fetchone()
            if found != "ok":
                raise sqlite3.DatabaseError(found)

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._connection.close()

    @contextmanager
    def _explained(self) -> Iterator[None]:
        """Turn what SQLite says into one sentence."""
        try:
            yield
        except sqlite3.OperationalError as error:
            mend = "mend that, or run with `library = false` in storyblender.toml"
            raise InputError(f"the library cannot be used ({error})", mend=mend, path=self._path) from error
        except sqlite3.DatabaseError as error:
            mend = "`storyblender library clean` makes it anew from the files of the library"
            raise DamagedIndex(f"the library's index is damaged ({error})", mend=mend, path=self._path) from error
