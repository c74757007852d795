"""What catalogues of assets offer, and the protocol that they are asked by."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, Literal, Protocol

from storyblender.service_setting import ServiceName
from storyblender.services.licences import UNKNOWN, Licence

OfferKind = Literal["model", "texture", "panorama"]
TextureMap = Literal["color", "normal", "roughness"]
"""Maps of a texture: base colour, normals with +Y up (OpenGL), roughness."""

_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")
_LONGEST: Final = 120
"""Letters of a line of text that a service says."""
_MOST_WORDS: Final = 40


@dataclass(frozen=True)
class Need:
    """What a thing is wanted for.

    Attributes:
        pixels: Across each texture, about: 1024 for most things, 2048 for what fills the picture.
        faces: The most that its mesh may have.
    """

    pixels: Literal[1024, 2048] = 1024
    faces: int = 200_000


@dataclass(frozen=True)
class Offer:
    """A work that a catalogue offers.

    Attributes:
        service: Whose catalogue.
        id: Of the work, unique in the catalogue; letters, digits, ``_`` and ``-``, as ``is_id`` says.
        name: What it is called.
        words: Further words for it: tags, categories, lower-case.
        kind: What it is.
        author: Who made it.
        licence: Under which it is given.
        url: Page of the work.
        bytes: Of the download; 0 where it is not known yet.
        faces: Of the mesh; 0 where it is not known.
        thumbnail: Address of a small picture; empty where there is none.
        size: Width, depth and height in metres where the catalogue knows them.
    """

    service: ServiceName
    id: str
    name: str
    kind: OfferKind = "model"
    words: tuple[str, ...] = ()
    author: str = ""
    licence: Licence = UNKNOWN
    url: str = ""
    bytes: int = 0
    faces: int = 0
    thumbnail: str = ""
    size: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class FetchedFiles:
    """A work that was fetched into a folder.

    Attributes:
        main: Name of the file that is opened, relative to the folder.
        digest: SHA-256 of that file.
        bytes: Of all files.
        faces: Triangles of a model; 0 where it does not say.
        maps: Of a texture: its files by map, relative to the folder.
    """

    main: str
    digest: str
    bytes: int
    faces: int = 0
    maps: Mapping[TextureMap, str] = field(default_factory=dict)


class Catalogue(Protocol):
    """A service that offers works: it is searched by words, and one work is fetched at a time."""

    @property
    def name(self) -> ServiceName:
        """What the service is called in the settings."""
        ...

    def find(self, words: str, kind: OfferKind, *, soon: bool = False) -> Sequence[Offer]:
        """Return what may fit, in an order that only depends on what the service answers.

        Args:
            words: What a thing is called, such as ``leather armchair``; nothing else of a story is ever sent.
            kind: Of work.
            soon: A person waits: it is given up after a few seconds.

        Raises:
            ServiceFailure: The service cannot be asked.
        """
        ...

    def thumbnail(self, offer: Offer) -> bytes:
        """Return the file of a small picture of a work, for people to choose by.

        Raises:
            ServiceFailure: There is none, or it cannot be had soon.
        """
        ...

    def size_of(self, offer: Offer, need: Need) -> int:
        """Return how many bytes a download has, 0 if that cannot be known before.

        Raises:
            ServiceFailure: The service cannot be asked.
        """
        ...

    def fetch(self, offer: Offer, folder: Path, need: Need) -> FetchedFiles:
        """Download a work into an empty folder.

        Args:
            offer: As ``find`` returned it.
            folder: Private to the caller; if this fails, what is in it is of no use.
            need: What it is wanted for.

        Raises:
            ServiceFailure: It cannot be fetched, or is not what was offered.
        """
        ...


def is_id(text: object) -> bool:
    """Tell whether an id is one that can be part of an address and of the name of a file."""
    return isinstance(text, str) and _ID.fullmatch(text) is not None


def line_of(text: object, longest: int = _LONGEST) -> str:
    """Return a line of plain text from what a service says: printable, without line ends, cut; empty if it is no text.

    Args:
        text: Whatever the service answered.
        longest: In letters.
    """
    if not isinstance(text, str):
        return ""
    return "".join(filter(str.isprintable, " ".join(text[: longest * 4].split())))[:longest].strip()


def words_in(texts: object) -> tuple[str, ...]:
    """Return words from what a service lists, lower-case, each once, in the order given.

    Args:
        texts: A list of texts, or of anything else, which is left out.
    """
    listed = texts if isinstance(texts, list) else []
    lines = (line_of(each, 40).lower() for each in listed[:_MOST_WORDS])
    return tuple(dict.fromkeys(line for line in lines if line))


def count_in(value: object, most: int = 1 << 40) -> int:
    """Return a count from what a service says; 0 if it is none or is larger than ``most``."""
    return value if isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= most else 0
