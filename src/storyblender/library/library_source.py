"""The user's library as an asset source: what earlier stories brought in is used again before anybody is asked."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence

from storyblender.catalog.recipe import EXACT, AssetQuery, Recipe
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.shared.entries import ADDED, LibraryEntry
from storyblender.library.shared.search import LibrarySearch
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.jobs import FETCHED
from storyblender.model_content import content_of
from storyblender.ports import Embedder
from storyblender.service_setting import LicenceFilter
from storyblender.services.licences import is_allowed, licence_of


class LibrarySource:
    """The library of a user.

    Args:
        library: Where the models are.
        embedder: Loads the sentence model.
        licences: Which licences a model from outside may have.
    """

    name = "library"

    def __init__(
        self, library: SharedLibrary, embedder: Callable[[], Embedder], licences: LicenceFilter = "any"
    ) -> None:
        self._library = library
        self._licences: LicenceFilter = licences
        self._search = LibrarySearch(library, embedder)
        self._found: dict[str, LibraryEntry] = {}

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        """Return the models that fit a thing that the script names, best first; none if the library cannot be read."""
        if query.asset.origin == "dressing":
            return ()
        try:
            found = self._search.matches(query, by_meaning=by_meaning)
        except InputError:
            return ()
        offered = [(match, entry) for match, entry in found if may_be_used(entry, self._licences)]
        self._found |= {entry.key: entry for _, entry in offered}
        return [self._recipe(entry, match.score, match.reason, by_meaning=match.by_meaning) for match, entry in offered]

    def inventory(self) -> Mapping[str, str]:
        """Return nothing: what other stories bring in does not ask for another plan of this one."""
        return {}

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        """Put the files of a model into the project.

        Raises:
            InputError: They are gone or damaged.
        """
        return placed_model(self._library, self._found[recipe.key], recipe, files)

    def chosen(self, told: str) -> Recipe | None:
        """Return the model that a person names by its key, its name, or eight or more digits of its digest.

        Raises:
            InputError: The library cannot be read.
        """
        entry = self._library.told(told)
        if entry is None or entry.kind not in ("model", "character"):
            return None
        self._found[entry.key] = entry
        return self._recipe(entry, EXACT, "a person chose it")

    @property
    def models(self) -> list[str]:
        """Names of the models that ``chosen`` takes, the newest first. Raises InputError: it cannot be read."""
        return [entry.name for entry in self._library.find() if entry.kind in ("model", "character")]

    def _recipe(self, entry: LibraryEntry, score: float, reason: str, *, by_meaning: bool = False) -> Recipe:
        provenance = Provenance(source=self.name, file=entry.key)
        return Recipe(
            source="file", key=entry.key, score=score, reason=reason, by_meaning=by_meaning, provenance=provenance
        )


def placed_model(library: SharedLibrary, entry: LibraryEntry, recipe: Recipe, files: Folder) -> Recipe:
    """Put the files of a model into a project, and return its recipe with what is known of them.

    Args:
        library: Where it is.
        entry: The model.
        recipe: With its key.
        files: The project folder.

    Raises:
        InputError: They are gone or damaged.
    """
    folder = f"{FETCHED}/{entry.place}"
    if not library.is_in(entry, files, folder):
        library.put_into(entry, files, folder)
    path = files.path(folder, entry.main)
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    source = entry.source or LibrarySource.name
    provenance = Provenance(source=source, file=recipe.key, digest=digest, **entry.credit.model_dump())
    params = {**recipe.params, "content": content_of(path, files.path(FETCHED))}
    return recipe.model_copy(update={"provenance": provenance, "params": params})


def may_be_used(entry: LibraryEntry, wanted: LicenceFilter) -> bool:
    """Return whether the licence of an entry passes the filter of the settings.

    What a person added is theirs; only a licence that is said to be another one counts. What services made for them is
    theirs by the terms of all of these, but not given to the public domain.

    Args:
        entry: In the library.
        wanted: By the settings.
    """
    said, own = entry.credit.license, entry.source == ADDED
    if entry.request:
        return wanted != "free"
    if own and (not said or wanted == "any"):
        return True
    return is_allowed(licence_of(said), wanted)
