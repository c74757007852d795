"""Surfaces and panoramas of the user's library and of catalogues of services: found by meaning, fetched once, kept.

What was fetched lies in ``FETCHED`` of the project as ``<service>/<id>-1k``, whole or not at all, and in the library.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np

from storyblender.errors import InputError, ServiceFailure
from storyblender.folder import Folder
from storyblender.library.library_source import may_be_used
from storyblender.library.shared.entries import EntryFacts, LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Credit, Provenance
from storyblender.memory.jobs import FETCHED
from storyblender.memory.panorama import Panorama, panorama_file
from storyblender.memory.texture import Texture
from storyblender.model_content import CREDITS, credit_lines
from storyblender.ports import Embedder
from storyblender.service_setting import LicenceFilter
from storyblender.services.licences import is_allowed
from storyblender.services.offers import Catalogue, Need, Offer

if TYPE_CHECKING:
    from storyblender.services.register import ServiceRun

PictureKind = Literal["texture", "panorama"]
_NEEDS: dict[PictureKind, Need] = {"texture": Need(1024), "panorama": Need(2048)}
_LEAST = 0.3
"""Likeness of meaning below which nothing is taken, whatever words it has."""
_WORD = re.compile(r"[a-z]+")
_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")
_MOST_WORDS = 64


@dataclass(frozen=True)
class OfferedPicture:
    """A surface or a panorama that can be had.

    Attributes:
        kind: What it is.
        name: What it is called.
        text: Name and tags, lower-case.
        place: Of its files below ``FETCHED``: ``poly_haven/red_brick-1k``.
        entry: In the user's library.
        offer: Of a catalogue.
        catalogue: Whose offer it is.
    """

    kind: PictureKind
    name: str
    text: str
    place: str
    entry: LibraryEntry | None = None
    offer: Offer | None = None
    catalogue: Catalogue | None = None

    @cached_property
    def words(self) -> frozenset[str]:
        """Every word that is said of it."""
        return frozenset(_WORD.findall(self.text))


class Pictures:
    """All that can be had.

    Args:
        library: The user's; None where it is turned off.
        catalogues: Asked after it, in this order.
        run: Budget and licences; None where no service is asked.
        embedder: Loads the sentence model.
        warn: Hears in one sentence that a service failed.
        licences: Of what the library has.
    """

    def __init__(
        self,
        library: SharedLibrary | None,
        catalogues: Sequence[Catalogue],
        run: ServiceRun | None,
        embedder: Callable[[], Embedder],
        warn: Callable[[str], None],
        licences: LicenceFilter = "any",
    ) -> None:
        self._library, self._catalogues, self._run = library, catalogues, run
        self._embedder, self._warn = embedder, warn
        self._licences: LicenceFilter = licences
        self._failed: set[str] = set()
        """Services that are asked no more, and what was said."""

    def best(self, kind: PictureKind, phrase: str, fits: Callable[[frozenset[str]], bool]) -> OfferedPicture | None:
        """Return what is most like a phrase among those whose words fit; None where nothing is like it.

        Args:
            kind: What is wanted.
            phrase: What it shows: ``dark oak floor boards``.
            fits: Tells by its words whether it can be that at all.
        """
        found = [each for each in self._offered(kind, phrase) if fits(each.words)]
        if not found:
            return None
        wanted, *vectors = self._embedder().embed([phrase, *(each.text for each in found)])
        likeness = np.array([float(vector @ wanted) for vector in vectors])
        best = int(likeness.argmax())  # of equals the library's, which comes first
        return found[best] if likeness[best] >= _LEAST else None

    def texture(self, picture: OfferedPicture, files: Folder) -> tuple[Texture, dict[str, bytes]] | None:
        """Return a surface with its prepared pictures; None, said once, where it cannot be had.

        Args:
            picture: As ``best`` returned it.
            files: The project folder.
        """
        from storyblender.library.texture_file import read_texture

        folder = self._brought(picture, files)
        try:
            if folder is not None:
                texture, pictures = read_texture(folder)
                return texture.model_copy(update=_placed(texture.provenance, picture.place)), pictures
        except InputError as error:
            self._told(f"{picture.name} is left out: {error}")
        return None

    def panorama(self, picture: OfferedPicture, files: Folder) -> tuple[Panorama, bytes] | None:
        """Return a panorama with its prepared picture; None, said once, where it cannot be had.

        Args:
            picture: As ``best`` returned it.
            files: The project folder.
        """
        from storyblender.library.panorama_file import read_panorama

        folder = self._brought(picture, files)
        main = picture.entry.main if picture.entry is not None else "panorama.hdr"
        try:
            if folder is not None:
                known, data = read_panorama(folder / main)
                return known.model_copy(update=_placed(known.provenance, picture.place)), data
        except InputError as error:
            self._told(f"{picture.name} is left out: {error}")
        return None

    def again(self, kind: PictureKind, known: Provenance, files: Folder) -> dict[str, bytes]:
        """Return the prepared pictures of what was fetched before; empty where it is gone.

        Args:
            kind: What it is.
            known: Where it came from.
            files: The project folder.
        """
        source, _, id = known.file.partition("/")
        if source != known.source or not _ID.fullmatch(source) or not _ID.fullmatch(id):
            return {}
        entry = self._library.by_source(source, id) if self._library is not None else None
        if entry is None and not files.path(FETCHED, known.file, CREDITS).is_file():
            return {}
        picture = OfferedPicture(kind, known.file, "", known.file, entry=entry)
        if kind == "texture":
            texture = self.texture(picture, files)
            return texture[1] if texture is not None else {}
        panorama = self.panorama(picture, files)
        return {panorama_file(panorama[0].provenance.digest): panorama[1]} if panorama is not None else {}

    def _offered(self, kind: PictureKind, phrase: str) -> Iterator[OfferedPicture]:
        try:
            entries = self._library.find(kind=kind) if self._library is not None else []
        except InputError:
            entries = []
        known = set[str]()
        for entry in sorted(entries, key=lambda each: each.digest):
            if may_be_used(entry, self._licences):
                known.add(entry.place)
                text = " ".join((entry.name, *entry.words)).lower()
                yield OfferedPicture(kind, entry.name, text, entry.place, entry=entry)
        for catalogue in self._catalogues:
            if catalogue.name in self._failed or self._run is None:
                continue
            try:
                offers = catalogue.find(phrase, kind)
            except ServiceFailure as failure:
                self._fail(catalogue, failure)
                continue
            for offer in offers:
                place = f"{catalogue.name}/{offer.id}-{_NEEDS[kind].pixels // 1024}k"
                if place not in known and is_allowed(offer.licence, self._run.licences):
                    text = " ".join((offer.name, *offer.words)).lower()
                    yield OfferedPicture(kind, offer.name, text, place, offer=offer, catalogue=catalogue)

    def _brought(self, picture: OfferedPicture, files: Folder) -> Path | None:
        """Return the folder with the files of a picture; None where its service fails."""
        if picture.entry is not None and self._library is not None:
            return self._library.path_of(picture.entry).parent
        offer, catalogue, name = picture.offer, picture.catalogue, f"{FETCHED}/{picture.place}"
        if offer is None or catalogue is None or self._run is None:
            return files.path(name)  # fetched before
        if not files.path(name, CREDITS).is_file():
            try:
                need = _NEEDS[picture.kind]
                self._run.budget.ask("megabytes", catalogue.size_of(offer, need) / 1e6)
                with files.writing_tree(name) as room:
                    main = catalogue.fetch(offer, room, need).main
                    part: Path = room / CREDITS
                    part.write_text(_credit_file(offer, main), encoding="utf-8")
            except ServiceFailure as failure:
                self._fail(catalogue, failure)
                return None
        folder = files.path(name)
        if self._library is not None:
            main = "panorama.hdr" if picture.kind == "panorama" else next(folder.glob("color.*")).name
            words, credit = offer.words[:_MOST_WORDS], Credit(**_credit(offer))
            source, _, id = picture.place.partition("/")
            facts = EntryFacts(
                kind=picture.kind, name=offer.name, words=words, main=main, credit=credit, source=source, source_id=id
            )
            try:
                self._library.add(facts, folder)
            except InputError as error:
                self._told(f"the library does not keep {offer.name}: {error}")
        return folder

    def _fail(self, catalogue: Catalogue, failure: ServiceFailure) -> None:
        """Ask a service no more in this run, and say so once."""
        if catalogue.name not in self._failed:
            self._failed.add(catalogue.name)
            if self._run is None or self._run.outages.is_news(catalogue.name, str(failure)):
                self._warn(f"{failure}; surfaces and skies stay as the library draws them")

    def _told(self, sentence: str) -> None:
        if sentence not in self._failed:
            self._failed.add(sentence)
            self._warn(sentence)


def _placed(known: Provenance, place: str) -> dict[str, Provenance]:
    """Return where a picture came from, named by its source and its place there."""
    return {"provenance": known.model_copy(update={"source": place.partition("/")[0], "file": place})}


def _credit(offer: Offer) -> dict[str, str]:
    return credit_lines({"author": offer.author, "license": offer.licence.name, "url": offer.url})


def _credit_file(offer: Offer, main: str) -> str:
    """Return whose work an offer is, and how wide a surface is, as the file beside it says."""
    lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}" for name, value in _credit(offer).items()]
    if offer.kind == "texture" and offer.size is not None:
        lines.append(f"width = {offer.size[0]:g}")
    return "\n".join([*lines, ""])
