"""Poly Haven: models, textures and panoramas, all given to the public domain (api.polyhaven.com, no key).

The whole list of a kind of asset is one answer, kept for a day; what fits a thing is chosen from it here, so that no
word of a story is sent. Their terms ask for a User-Agent and for the words "Powered by Poly Haven".
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, Final

from storyblender.errors import ServiceFailure
from storyblender.service_setting import ServiceChoice, ServiceName
from storyblender.services.archives import MODEL_FILES, inside_name
from storyblender.services.gltf_files import MODEL, check_gltf, check_picture
from storyblender.services.licences import CC0
from storyblender.services.offers import (
    FetchedFiles,
    Need,
    Offer,
    OfferKind,
    TextureMap,
    count_in,
    is_id,
    line_of,
    words_in,
)
from storyblender.services.register import ServiceRun
from storyblender.services.web import Web

ADDRESS: Final = "https://api.polyhaven.com"
_PAGE: Final = "https://polyhaven.com/a/"
_TYPES: Final[dict[OfferKind, str]] = {"model": "models", "texture": "textures", "panorama": "hdris"}
_MAPS: Final[dict[TextureMap, tuple[str, ...]]] = {
    "color": ("diffuse", "diff", "col_1", "col_01", "color"), "normal": ("nor_gl",), "roughness": ("rough",),
}  # fmt: skip
"""Map -> what it is called in the list of files, lower-case, the first that is there."""
_PICTURES = ("jpg", "png")
_MOST_ASSETS = 50_000
_MOST_FILES = 200
_MOST_BYTES = 400 << 20
_RESOLUTION = re.compile(r"([0-9]{1,2})k")
_MD5 = re.compile(r"[0-9a-fA-F]{32}")


@dataclass(frozen=True)
class _File:
    """A file to download, as the list of files has it."""

    name: str
    url: str
    bytes: int
    md5: str


class PolyHaven:
    """The catalogue.

    Args:
        choice: May have another address.
        run: What the run gives.
    """

    name: ServiceName = "poly_haven"

    def __init__(self, choice: ServiceChoice, run: ServiceRun) -> None:
        self._run, self._web = run, run.web(choice, ADDRESS)
        self._offers: dict[OfferKind, tuple[Offer, ...]] = {}
        self._files: dict[str, Any] = {}

    def find(self, words: str, kind: OfferKind, *, soon: bool = False) -> Sequence[Offer]:
        """Return all assets of a kind, by id.

        Args:
            words: Not used: they stay here.
            kind: Of asset.
            soon: A person waits: it is given up after a few seconds.

        Raises:
            ServiceFailure: The list cannot be had.
        """
        if kind not in self._offers:
            records = self._list(kind, self._web.soon if soon else self._web)
            self._offers[kind] = tuple(_offers(records, kind))
        return self._offers[kind]

    def thumbnail(self, offer: Offer) -> bytes:
        """Return the small picture that the service has of a work.

        Raises:
            ServiceFailure: There is none, or it cannot be had soon.
        """
        return self._web.picture(offer.thumbnail)

    def size_of(self, offer: Offer, need: Need) -> int:
        """Return the bytes of an asset's download.

        Raises:
            ServiceFailure: Its files cannot be asked for.
        """
        return sum(file.bytes for file in self._wanted(offer, need).values())

    def fetch(self, offer: Offer, folder: Path, need: Need) -> FetchedFiles:
        """Download an asset: a model with its textures, the maps of a texture, or a panorama.

        Raises:
            ServiceFailure: It cannot be fetched, or is not what was offered.
        """
        files = self._wanted(offer, need)
        if len(files) > _MOST_FILES or sum(file.bytes for file in files.values()) > _MOST_BYTES:
            raise ServiceFailure(f"{self.name}: {offer.id} is too large")
        size, digests = 0, {}
        for file in files.values():
            part = folder / file.name
            part.parent.mkdir(parents=True, exist_ok=True)
            came = self._web.download(file.url, part, most=_MOST_BYTES - size, md5=file.md5)
            size, digests[file.name] = size + came.bytes, came.digest
        main = next(iter(files.values())).name
        faces = check_gltf(folder / main) if offer.kind == "model" else 0
        maps: dict[TextureMap, str] = {name: files[name].name for name in _MAPS if name in files}
        for name in maps.values():
            check_picture(folder / name)
        return FetchedFiles(main, digests[main], size, faces, maps)

    def _list(self, kind: OfferKind, web: Web) -> dict[str, Any]:
        """Return the records of a kind, asked for at most once a day. Raises ServiceFailure."""
        name = (self.name, self._web.address, kind)
        kept = self._run.shelf.recall(*name)
        if kept is not None and kept.is_fresh:
            return kept.value
        try:
            asked = {"if-none-match": kept.etag} if kept is not None and kept.etag else {}
            answer = web.get("assets", {"t": _TYPES[kind]}, headers=asked)
            records = kept.value if answer.status == 304 and kept is not None else _records(answer.json)
        except ServiceFailure:
            if kept is None:
                raise
            return kept.value
        etag = line_of(answer.headers.get("etag", kept.etag if kept is not None else ""))
        self._run.shelf.keep(records, *name, etag=etag)
        return records

    def _wanted(self, offer: Offer, need: Need) -> dict[str, _File]:
        """Return the files to download, the main one first, by what they are. Raises ServiceFailure."""
        if offer.id not in self._files:
            self._files[offer.id] = self._web.get(f"files/{offer.id}").json
        tree = self._files[offer.id]
        if offer.kind == "texture":
            return _maps(tree, need)
        if offer.kind == "panorama":
            return {"panorama": _file("panorama.hdr", _dict(_at(_dict(tree).get("hdri"), need)).get("hdr"))}
        model = _dict(_at(_dict(tree).get("gltf"), need)).get("gltf")
        files = {"model": _file(MODEL, model)}
        for path, each in _dict(_dict(model).get("include")).items():
            name = inside_name(path)
            if PurePosixPath(name).suffix.lower() not in MODEL_FILES or name == MODEL:
                raise ServiceFailure("a file of the model has a name that is not one of a model's")
            files[name] = _file(name, each)
        return files


def _records(listed: Any) -> dict[str, Any]:
    """Return what is used of a list of assets. Raises ServiceFailure."""
    if not isinstance(listed, dict):
        raise ServiceFailure("poly_haven: its list of assets is none")
    used = ("name", "authors", "categories", "category", "tags", "dimensions", "polycount", "thumbnail_url")
    return {
        id: {name: record[name] for name in used if name in record}
        for id, record in list(listed.items())[:_MOST_ASSETS]
        if is_id(id) and isinstance(record, dict)
    }


def _offers(records: Any, kind: OfferKind) -> Iterator[Offer]:
    """Yield the offers of a list of records, by id."""
    for id, record in sorted(_dict(records).items()):
        name = line_of(record.get("name")) or id.replace("_", " ")
        path = record.get("category")
        told = [*words_in(record.get("tags")), *words_in(record.get("categories"))]
        told += [part.strip().lower() for part in line_of(path).split("/")]
        thumbnail = line_of(record.get("thumbnail_url"), 400)
        yield Offer(
            service="poly_haven",
            id=id,
            name=name,
            kind=kind,
            words=tuple(dict.fromkeys(word for word in told if word)),
            author=line_of(", ".join(line_of(each, 60) for each in _dict(record.get("authors")))),
            licence=CC0,
            url=f"{_PAGE}{id}",
            faces=count_in(record.get("polycount")),
            thumbnail=thumbnail if thumbnail.startswith(("https://", "http://")) else "",
            size=_size(record.get("dimensions")),
        )


def _size(told: Any) -> tuple[float, float, float] | None:
    """Return a size in metres from one in millimetres, of two or three numbers."""
    sides = (
        [each for each in told if isinstance(each, int | float) and 0 < each < 1e6] if isinstance(told, list) else []
    )
    if len(sides) < 2:
        return None
    return (sides[0] / 1000, sides[1] / 1000, sides[2] / 1000 if len(sides) > 2 else 0.0)


def _maps(tree: Any, need: Need) -> dict[str, _File]:
    """Return the maps of a texture; base colour first, which it must have. Raises ServiceFailure."""
    named = {line_of(name).lower(): value for name, value in _dict(tree).items()}
    files: dict[str, _File] = {}
    for kind, names in _MAPS.items():
        found = next((named[name] for name in names if name in named), None)
        formats = _dict(_at(found, need)) if found is not None else {}
        if suffix := next((each for each in _PICTURES if each in formats), ""):
            files[kind] = _file(f"{kind}.{suffix}", formats[suffix])
    if "color" not in files:
        raise ServiceFailure("poly_haven: the texture has no colour")
    return files


def _at(resolutions: Any, need: Need) -> Any:
    """Return what there is at the resolution that is needed, else at the next larger one, else at the largest."""
    sizes = {
        int(found[1]) * 1024: value
        for name, value in _dict(resolutions).items()
        if (found := _RESOLUTION.fullmatch(name)) is not None
    }
    if not sizes:
        raise ServiceFailure("poly_haven: it has no file of that kind")
    return sizes[min(sizes, key=lambda size: (size < need.pixels, abs(size - need.pixels)))]


def _file(name: str, told: Any) -> _File:
    """Return a file as the list has it. Raises ServiceFailure."""
    url, md5 = _dict(told).get("url"), _dict(told).get("md5")
    if not isinstance(url, str) or len(url) > 2000 or not isinstance(md5, str) or not _MD5.fullmatch(md5):
        raise ServiceFailure("poly_haven: its list of files is none")
    return _File(name, url, count_in(_dict(told).get("size")), md5)


def _dict(value: Any) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}
