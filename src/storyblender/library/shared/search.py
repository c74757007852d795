"""Finds models of the user's library by what a script calls a thing: by their words, and by their meaning.

Vectors are kept in the index, so that a name is read by the sentence model once for all stories.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from storyblender.catalog.props.phrases import kept_words
from storyblender.catalog.recipe import AssetQuery
from storyblender.library.file_names import words_of_file
from storyblender.library.matching import Likeness, Match, Term, Vectors
from storyblender.library.named_models import named, terms_of, words_told
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.ports import Embedder

if TYPE_CHECKING:
    from storyblender.library.shared.index import Index

_MOST = 100
"""Models whose names are compared word by word: those that share most words with the phrase."""


class LibrarySearch:
    """Finds models.

    Args:
        library: Where they are.
        embedder: Loads the sentence model.
    """

    def __init__(self, library: SharedLibrary, embedder: Callable[[], Embedder]) -> None:
        self._library, self._embedder, self._likeness = library, embedder, Likeness(embedder)
        self._state: object = None
        self._terms: tuple[Term, ...] = ()
        self._vectors: Vectors = np.zeros((0, 0), np.float32)

    def matches(self, query: AssetQuery, *, by_meaning: bool) -> list[tuple[Match, LibraryEntry]]:
        """Return the models that fit an object, best first.

        Args:
            query: The object.
            by_meaning: Also those that are only similar in meaning.

        Raises:
            InputError: The library cannot be read.
        """
        index = self._library.index()
        if index is None:
            return []
        names = self._sharing_words(index, query.phrase)
        ranked = [(key, name, rank) for rank, (key, name) in enumerate(names)]
        found = named(query.phrase, ranked, terms_of(names))
        if by_meaning:
            self._know_all(index)
            found = self._likeness.with_likely(found, query, self._terms, self._vectors)
        entries = {entry.digest: entry for entry in self._library.entries([match.key for match in found])}
        return [(match, entries[match.key]) for match in found if match.key in entries]

    def know(self) -> None:
        """Let the sentence model read the names that it has not read yet. Raises InputError."""
        if (index := self._library.index()) is not None:
            self._know_all(index)

    def _sharing_words(self, index: Index, phrase: str) -> list[tuple[str, str]]:
        """Return digest and name of models that share words with a phrase, those that share most first."""
        nouns = sorted(words_told(phrase))
        query = f"""SELECT e.digest FROM nouns n JOIN entries e ON e.digest = n.digest
            WHERE n.noun IN ({", ".join("?" * len(nouns))}) AND e.kind = 'model'
            GROUP BY e.digest ORDER BY count(*) DESC, e.added DESC, e.digest LIMIT {_MOST}"""
        with index.reading() as db:
            digests = [row[0] for row in db.execute(query, nouns)]
        return [(entry.digest, name) for entry in self._library.entries(digests) for name in entry.names]

    def _know_all(self, index: Index) -> None:
        """Bring the terms and vectors of all models up to what the library holds now."""
        with index.reading() as db:
            state = db.execute("SELECT count(*), max(added) FROM entries").fetchone()
        if state == self._state or state[0] == 0:
            return
        width = self._embedder().embed(["chair"]).shape[1]
        self._read(index, width)
        with index.reading() as db:
            known = "SELECT digest FROM vectors WHERE width = ?"
            query = f"SELECT digest FROM entries WHERE kind = 'model' AND digest NOT IN ({known})"
            unread = [row[0] for row in db.execute(query, (width,))]
        if unread:
            self._learn(index, width, unread)
            self._read(index, width)
        self._state = state

    def _read(self, index: Index, width: int) -> None:
        query = """SELECT v.digest, v.phrase, v.vector FROM vectors v JOIN entries e ON e.digest = v.digest
            WHERE v.width = ? AND length(v.vector) = 4 * v.width AND v.phrase != '' AND e.kind = 'model'
            ORDER BY v.digest"""
        with index.reading() as db:
            rows = db.execute(query, (width,)).fetchall()
        self._terms = tuple(Term(digest, tuple(phrase.split()), True) for digest, phrase, _ in rows)
        self._vectors = np.frombuffer(b"".join(row[2] for row in rows), np.float32).reshape(-1, width)

    def _learn(self, index: Index, width: int, digests: Sequence[str]) -> None:
        """Let the sentence model read names, and keep their vectors."""
        phrases = {entry.digest: _phrase(entry.name) for entry in self._library.entries(digests)}
        vectors = self._embedder().embed(list(phrases.values()))
        rows = [
            (digest, width, phrase, vector.tobytes())
            for (digest, phrase), vector in zip(phrases.items(), vectors, strict=True)
        ]
        with index.writing() as db:
            db.executemany("INSERT OR REPLACE INTO vectors VALUES (?, ?, ?, ?)", rows)


def _phrase(name: str) -> str:
    """Return the words of a name that say something."""
    words = list(words_of_file(name).words)
    return " ".join(kept_words(words) or words)
