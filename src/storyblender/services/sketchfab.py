"""Sketchfab: models that their authors let be downloaded, each with its licence (api.sketchfab.com, API token).

A search is by words; its answer says author, licence, faces and size. The link to a download is good for minutes only,
so it is asked for when it is used, and it goes to another host, which never sees the token.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

from storyblender.errors import ServiceFailure
from storyblender.keys import service_key, service_key_name
from storyblender.service_setting import ServiceChoice, ServiceName
from storyblender.services.archives import extract
from storyblender.services.gltf_files import MODEL, check_gltf, main_of, unpack_glb
from storyblender.services.licences import UNKNOWN, Licence, is_allowed, licence_of
from storyblender.services.offers import FetchedFiles, Need, Offer, OfferKind, count_in, is_id, line_of, words_in
from storyblender.services.register import ServiceRun
from storyblender.services.web import Web

ADDRESS: Final = "https://api.sketchfab.com/v3"
_PAGE: Final = "https://sketchfab.com/3d-models/"
_MOST_BYTES = 300 << 20
_MOST_RESULTS = 24
"""Of one answer; the service gives no more at once."""
_THUMBNAIL = 256
"""Pixels across, at least."""


class Sketchfab:
    """The catalogue.

    Args:
        choice: May have another address.
        run: What the run gives.
    """

    name: ServiceName = "sketchfab"

    def __init__(self, choice: ServiceChoice, run: ServiceRun) -> None:
        self._choice, self._run = choice, run
        self._web = run.web(choice, ADDRESS, "Authorization", "Token")
        self._found: dict[str, tuple[Offer, ...]] = {}

    def find(self, words: str, kind: OfferKind, *, soon: bool = False) -> Sequence[Offer]:
        """Return the models that the service finds for words, the most relevant first; it has nothing but models.

        Args:
            words: Sent as they are.
            kind: Of work.
            soon: A person waits: it is given up after a few seconds.

        Raises:
            ServiceFailure: The service cannot be asked.
        """
        if kind != "model" or not words.strip():
            return ()
        self._refuse_without_key()
        if words not in self._found:
            query = {
                "type": "models", "q": words, "downloadable": "true", "archives_flavours": "false",
                "count": _MOST_RESULTS, "max_face_count": Need().faces,
            }  # fmt: skip
            if self._run.licences == "free":
                query["license"] = "cc0"
            self._found[words] = tuple(
                self._allowed(self._results(words, query, self._web.soon if soon else self._web))
            )
        return self._found[words]

    def thumbnail(self, offer: Offer) -> bytes:
        """Return the small picture that the service has of a work.

        Raises:
            ServiceFailure: There is none, or it cannot be had soon.
        """
        return self._web.picture(offer.thumbnail)

    def size_of(self, offer: Offer, need: Need) -> int:
        """Return the bytes of a model's archive, as the search said."""
        return offer.bytes

    def fetch(self, offer: Offer, folder: Path, need: Need) -> FetchedFiles:
        """Download a model and unpack it.

        Raises:
            ServiceFailure: It cannot be fetched, or is not what was offered.
        """
        self._refuse_without_key()
        links = self._web.get(f"models/{offer.id}/download").json
        archive, single = _link(links, "gltf"), _link(links, "glb")
        if not archive and not single:
            raise ServiceFailure(f"{self.name}: it offers no glTF of {offer.id}")
        with TemporaryDirectory(dir=folder) as room:
            part = Path(room) / "download"
            size = self._web.download(archive or single, part, most=_MOST_BYTES).bytes
            if archive:
                _unpack(part, Path(room) / "files", folder)
            else:
                unpack_glb(part, folder)
        faces = check_gltf(folder / MODEL)
        with (folder / MODEL).open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
        return FetchedFiles(MODEL, digest, size, faces)

    def _refuse_without_key(self) -> None:
        if not self._choice.address and not service_key(self._choice):
            name = service_key_name(self._choice)
            mend = f"set {name} in the environment, or `keyring set storyblender {name}`"
            raise ServiceFailure(f"{self.name}: there is no key", mend=mend)

    def _results(self, words: str, query: dict[str, Any], web: Web) -> Any:
        """Return the results of a search, asked for at most once a day. Raises ServiceFailure."""
        name = (self.name, self._web.address, words, self._run.licences)
        kept = self._run.shelf.recall(*name)
        if kept is not None and kept.is_fresh:
            return kept.value
        answer = web.get("search", query).json
        results = answer.get("results") if isinstance(answer, dict) else None
        if not isinstance(results, list):
            raise ServiceFailure(f"{self.name}: its answer is not a list of models")
        records = [_record(each) for each in results[:_MOST_RESULTS] if isinstance(each, dict)]
        self._run.shelf.keep(records, *name)
        return records

    def _allowed(self, records: Any) -> Iterator[Offer]:
        """Yield the offers that may be used."""
        for record in records if isinstance(records, list) else ():
            offer = _offer(record)
            if offer is not None and is_allowed(offer.licence, self._run.licences) and offer.faces <= Need().faces:
                yield offer


def _unpack(archive: Path, room: Path, folder: Path) -> None:
    """Unpack an archive so that its model is ``MODEL`` in a folder. Raises ServiceFailure.

    Args:
        archive: The archive.
        room: A folder to be made, on the same disk.
        folder: Where to.
    """
    part = room
    part.mkdir()
    main = room / main_of(extract(archive, room))
    if main.suffix.lower() == ".glb":
        unpack_glb(main, folder)
        return
    for part in sorted(main.parent.iterdir()):
        part.rename(folder / (MODEL if part == main else part.name))


def _record(result: dict[str, Any]) -> dict[str, Any]:
    """Return what is used of one result."""
    used = (
        "uid", "name", "tags", "categories", "user", "license", "viewerUrl", "isDownloadable", "isAgeRestricted",
        "faceCount", "archives", "thumbnails",
    )  # fmt: skip
    return {name: result[name] for name in used if name in result}


def _offer(record: dict[str, Any]) -> Offer | None:
    """Return the offer that a record is; None if it is none, or not for everybody's eyes."""
    uid, name = record.get("uid"), line_of(record.get("name"))
    if not is_id(uid) or not name or record.get("isDownloadable") is False or record.get("isAgeRestricted") is True:
        return None
    user, archive = _dict(record.get("user")), _dict(_dict(record.get("archives")).get("gltf"))
    page = line_of(record.get("viewerUrl"), 400)
    return Offer(
        service="sketchfab",
        id=str(uid),
        name=name,
        words=(*_named(record.get("tags")), *_named(record.get("categories"))),
        author=line_of(user.get("displayName")) or line_of(user.get("username")),
        licence=_licence(record.get("license")),
        url=page if page.startswith(_PAGE) else f"{_PAGE}{uid}",
        bytes=count_in(archive.get("size")),
        faces=count_in(archive.get("faceCount")) or count_in(record.get("faceCount")),
        thumbnail=_thumbnail(record.get("thumbnails")),
    )


def _licence(told: Any) -> Licence:
    """Return a licence from its slug, its names or its URL, whichever is known."""
    texts = [told] if isinstance(told, str) else [_dict(told).get(key) for key in ("slug", "label", "fullName", "url")]
    found = (licence_of(text) for text in texts if isinstance(text, str))
    return next((licence for licence in found if licence.name), UNKNOWN)


def _named(listed: Any) -> tuple[str, ...]:
    """Return the names of tags or categories."""
    entries = [_dict(each) for each in listed] if isinstance(listed, list) else []
    return words_in([line_of(each.get("name")) or line_of(each.get("slug")).replace("-", " ") for each in entries])


def _thumbnail(told: Any) -> str:
    """Return the address of the smallest picture that is large enough; empty if there is none."""
    images = _dict(told).get("images")
    pictures = [
        (count_in(each.get("width")), line_of(each.get("url"), 400))
        for each in (images if isinstance(images, list) else [])
        if isinstance(each, dict)
    ]
    good = [(width, url) for width, url in pictures if width >= _THUMBNAIL and url.startswith(("https://", "http://"))]
    return min(good)[1] if good else ""


def _link(links: Any, kind: str) -> str:
    url = _dict(_dict(links).get(kind)).get("url")
    return url if isinstance(url, str) and len(url) < 8000 else ""


def _dict(value: Any) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}
