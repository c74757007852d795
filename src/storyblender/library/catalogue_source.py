"""A service's catalogue as an asset source: found by name, fetched once, kept in the user's library.

What was fetched lies in ``FETCHED`` of the project under ``<service>/<id>-<size>``, whole or not at all, so that a run
that was killed goes on without asking for it again.
"""

from __future__ import annotations

import hashlib
import json
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Final

from storyblender.catalog.recipe import AssetQuery, Recipe
from storyblender.errors import InputError, ServiceFailure
from storyblender.folder import Folder
from storyblender.library.catalogue_asking import Asking
from storyblender.library.matching import Likeness
from storyblender.library.offer_matching import Offers, is_asked_for, need_of, ranked, search_words
from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit, Provenance
from storyblender.memory.jobs import FETCHED
from storyblender.model_content import CREDITS, content_of, credit_lines
from storyblender.ports import Embedder
from storyblender.services.gltf_files import MODEL
from storyblender.services.licences import is_allowed
from storyblender.services.offers import Catalogue, Need, Offer
from storyblender.services.register import ServiceRun

_MOST = 8
"""Works of one catalogue that are offered for a thing."""
_REST: Final = 300.0
"""Seconds for which a service that failed is not asked again."""
_WORDS = 64


class CatalogueSource:
    """A catalogue.

    Args:
        catalogue: The service.
        run: Its budget and licences.
        embedder: Loads the sentence model.
        library: Keeps what was fetched; None keeps it in the project only.
        warn: Hears in one sentence that the service failed.
    """

    def __init__(
        self,
        catalogue: Catalogue,
        run: ServiceRun,
        embedder: Callable[[], Embedder],
        library: SharedLibrary | None,
        warn: Callable[[str], None],
    ) -> None:
        self._catalogue, self._run, self._library, self._warn = catalogue, run, library, warn
        self._likeness, self._lock = Likeness(embedder), threading.Lock()
        self._known: dict[str, tuple[Offer, Need]] = {}
        self._listed: tuple[Sequence[Offer], Offers] | None = None
        self._rests_until, self._asking = 0.0, Asking(catalogue)

    @property
    def name(self) -> str:
        """What the service is called."""
        return self._catalogue.name

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        """Return the works that fit a thing that the script names, best first; none if the service fails."""
        if not is_asked_for(query):
            return ()
        with self._lock:
            offers = self._offers(search_words(query.phrase))
            return self._fitting(query, offers, by_meaning=by_meaning) if offers else ()

    def offered(self, query: AssetQuery) -> Sequence[Recipe] | None:
        """Return the works that fit any thing, best first, for a person who looks; None while the service is asked.

        Args:
            query: What is looked for.

        Raises:
            ServiceFailure: The service cannot be asked, or does not answer soon.
        """
        with self._lock:
            found = self._asking.models(search_words(query.phrase))
            return None if found is None else self._fitting(query, self._allowed(found), by_meaning=True)

    def _fitting(self, query: AssetQuery, offers: Offers, *, by_meaning: bool) -> list[Recipe]:
        """Return what fits a thing of what the service has, best first."""
        matches = ranked(query, offers, self._likeness, by_meaning=by_meaning)[:_MOST]
        need = need_of(query)
        keys = {match.key: f"{self._place(match.key, need)}/{MODEL}" for match in matches}
        self._known |= {keys[match.key]: (offers.by_id[match.key], need) for match in matches}
        return [
            Recipe(
                source="file",
                key=keys[match.key],
                score=match.score,
                reason=match.reason,
                by_meaning=match.by_meaning,
                provenance=Provenance(source=self.name, file=keys[match.key]),
            )
            for match in matches
        ]

    def inventory(self) -> Mapping[str, str]:
        """Return nothing: a catalogue that grows does not ask for another plan of a story."""
        return {}

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        """Put the files of a work into the project: from the user's library, else from the service.

        Raises:
            InputError: The service cannot give it.
        """
        if recipe.key not in self._known:
            raise InputError(f"{self.name} was not asked for {recipe.key!r}", mend="run the same command again")
        offer, need = self._known[recipe.key]
        folder = f"{FETCHED}/{self._place(offer.id, need)}"
        try:
            self._bring(offer, need, files, folder)
        except ServiceFailure as failure:
            raise InputError(f"{self.name} cannot give {offer.name!r}: {failure}") from failure
        path = files.path(folder, MODEL)
        with path.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
        provenance = Provenance(source=self.name, file=recipe.key, digest=digest, **_credit(offer))
        params = {**recipe.params, "content": content_of(path, files.path(FETCHED))}
        return recipe.model_copy(update={"provenance": provenance, "params": params})

    def offers(self, key: str) -> bool:
        """Tell whether a work was found since this was opened."""
        return key in self._known

    def offer_of(self, key: str) -> Offer:
        """Return a work that was found, by the key of its recipe."""
        return self._known[key][0]

    def thumbnail(self, key: str) -> bytes:
        """Return the file of the small picture that the service has of a work.

        Raises:
            ServiceFailure: It has none, or cannot give it soon.
        """
        return self._asking.thumbnail(self._known[key][0])

    def bytes_to_fetch(self, recipe: Recipe) -> int | None:
        """Return what fetching a work takes, 0 if that is not known before; None if the library has it already.

        Raises:
            ServiceFailure: The service cannot be asked.
        """
        offer, need = self._known[recipe.key]
        id = self._place(offer.id, need).partition("/")[2]
        if self._library is not None and self._library.by_source(self.name, id) is not None:
            return None
        return self._catalogue.size_of(offer, need)

    def _place(self, id: str, need: Need) -> str:
        return f"{self.name}/{id}-{need.pixels // 1024}k"

    def _offers(self, words: str) -> Offers | None:
        """Return what the service has for some words; None while it fails."""
        if time.monotonic() < self._rests_until:
            return None
        try:
            found = self._catalogue.find(words, "model")
        except ServiceFailure as failure:
            self._rests_until = time.monotonic() + _REST
            if self._run.outages.is_news(self.name, str(failure)):
                self._warn(f"{failure}; things come from elsewhere")
            return None
        return self._allowed(found)

    def _allowed(self, found: Sequence[Offer]) -> Offers:
        """Return the works whose licences the settings allow."""
        if self._listed is None or self._listed[0] is not found:
            allowed = [offer for offer in found if is_allowed(offer.licence, self._run.licences)]
            self._listed = found, Offers.of(allowed)
        return self._listed[1]

    def _bring(self, offer: Offer, need: Need, files: Folder, folder: str) -> None:
        """Have the files of a work in the project and in the library. Raises ServiceFailure."""
        id = folder.rpartition("/")[2]
        entry = self._library.by_source(self.name, id) if self._library is not None else None
        if entry is not None and self._library is not None:
            if not self._library.is_in(entry, files, folder):
                self._library.put_into(entry, files, folder)
            return
        if not all(files.path(folder, name).is_file() for name in (MODEL, CREDITS)):
            self._download(offer, need, files, folder)
        if self._library is not None:
            facts = EntryFacts(
                kind="model",
                name=offer.name,
                words=offer.words[:_WORDS],
                main=MODEL,
                credit=Credit(**_credit(offer)),
                source=self.name,
                source_id=id,
                faces=offer.faces or None,
            )
            self._library.add(facts, files.path(folder))

    def _download(self, offer: Offer, need: Need, files: Folder, folder: str) -> None:
        """Fetch a work into the project, whole or not at all. Raises ServiceFailure."""
        self._run.budget.ask("megabytes", self._catalogue.size_of(offer, need) / 1e6)
        with files.writing_tree(folder) as room:
            self._catalogue.fetch(offer, room, need)
            part: Path = room / CREDITS
            lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}" for name, value in _credit(offer).items()]
            part.write_text("\n".join([*lines, ""]), encoding="utf-8")


def _credit(offer: Offer) -> dict[str, str]:
    """Return whose work an offer is."""
    return credit_lines({"author": offer.author, "license": offer.licence.name, "url": offer.url})
