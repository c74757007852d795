"""What stories asked of models and how they got them, for the figures of reuse in the paper's form."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Final, Literal

from storyblender.memory.base import Frozen

if TYPE_CHECKING:
    from storyblender.library.shared.index import Index

UseOrigin = Literal["built", "fetched", "library", "geometry", "same"]
"""Built for the story; built of a model that was downloaded or made for it; built of a model that the library had;
taken from the library as it was built for another story; the same as another thing of the story."""
_AVOIDED: Final = ("library", "geometry", "same")


class Use(Frozen):
    """A thing of a story and what it was made from."""

    asset: str
    """Its id in the story."""
    model: str
    """What tells its model from other models."""
    name: str
    category: str
    origin: UseOrigin
    entry: str = ""
    """Digest of the entry that it was made from, if there is one."""


class ReuseFigures(Frozen):
    """How much was used again, as the paper counts it (appendix, incremental asset library)."""

    stories: int = 0
    requests: int = 0
    """Models that the stories asked for, each story for itself."""
    unique: int = 0
    """Different models among them."""
    avoided: int = 0
    """Requests for which nothing was built, downloaded or made."""
    avoided_in_story: int = 0
    """Of those: because another thing of the same story has the same model, which needs no library."""
    downloads_avoided: int = 0
    """Of those: built of a model that was not downloaded or made again."""
    places: int = 0
    """Where the things stand, scene by scene."""
    categories: Mapping[str, int] = {}
    """Different models by category, the largest first."""

    @property
    def reduction(self) -> float:
        """Percent of the requests that were avoided."""
        return 100 * self.avoided / self.requests if self.requests else 0.0

    @property
    def references(self) -> float:
        """How often each model is referenced, in the mean."""
        return self.places / self.unique if self.unique else 0.0


class Uses:
    """The uses that a library noted.

    Args:
        index: Opens the index: with True it is made if there is none, else None is returned then.
    """

    def __init__(self, index: Callable[[bool], Index | None]) -> None:
        self._index = index

    def note(self, project: str, uses: Iterable[Use]) -> None:
        """Note what a story uses; what was noted of a thing and its model before stays, however often it is made.

        Args:
            project: The story.
            uses: Of its things.

        Raises:
            InputError: The library cannot be written.
        """
        index = self._index(True)
        assert index is not None, "made where there was none"
        fields = "project, asset, model, name, category, origin, entry, places, noted"
        rows = [
            (project, use.asset, use.model, use.name, use.category, use.origin, use.entry, 1, time.time())
            for use in uses
        ]
        with index.writing() as db:
            db.executemany(f"INSERT OR IGNORE INTO uses ({fields}) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", rows)

    def count_places(self, project: str, places: Mapping[str, int]) -> None:
        """Note in how many places the things of a story stand.

        Args:
            project: The story.
            places: By id of the asset.

        Raises:
            InputError: The library cannot be written.
        """
        index = self._index(False)
        if index is None:
            return
        rows = [(max(1, count), project, asset) for asset, count in places.items()]
        with index.writing() as db:
            db.executemany("UPDATE uses SET places = ? WHERE project = ? AND asset = ?", rows)

    def of_entry(self, digest: str) -> list[tuple[str, str]]:
        """Return story and name of the things that were made from an entry."""
        index = self._index(False)
        if index is None:
            return []
        with index.reading() as db:
            query = "SELECT DISTINCT project, name FROM uses WHERE entry = ? ORDER BY noted, name"
            return db.execute(query, (digest,)).fetchall()

    def figures(self) -> ReuseFigures:
        """Return the figures over all stories."""
        index = self._index(False)
        if index is None:
            return ReuseFigures()
        with index.reading() as db:
            rows = db.execute("SELECT project, model, category, origin, places FROM uses").fetchall()
        categories = Counter({model: category for _, model, category, _, _ in rows}.values())
        return ReuseFigures(
            stories=len({row[0] for row in rows}),
            requests=len(rows),
            unique=len({row[1] for row in rows}),
            avoided=sum(row[3] in _AVOIDED for row in rows),
            avoided_in_story=sum(row[3] == "same" for row in rows),
            downloads_avoided=sum(row[3] == "library" for row in rows),
            places=sum(row[4] for row in rows),
            categories=dict(categories.most_common()),
        )
