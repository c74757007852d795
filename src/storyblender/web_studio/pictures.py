"""Surfaces and panoramas as the page shows them to choose by eye, and the small pictures of them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path, PurePosixPath
from urllib.parse import quote

from storyblender.errors import InputError
from storyblender.library.panorama_file import small_panorama
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.small_picture import small_picture
from storyblender.library.texture_file import surface_name
from storyblender.memory.base import Described
from storyblender.workplace.workplace import PANORAMAS, Workplace

MOST_SHOWN = 100
"""Pictures at once; words narrow them."""


class PictureCard(Described):
    """A surface or a panorama."""

    file: str
    """Its path in the folder; empty for one of the library."""
    entry: str
    """Its digest in the library; empty for one of the folder."""
    named: str
    """As a story names what it was made of."""
    name: str
    """As people call it."""
    source: str
    """Where it is from."""
    credit: str
    """Author and licence; empty where none is stated."""
    picture: str
    """Address of a small picture."""


def picture_cards(own: Sequence[str], kept: Sequence[LibraryEntry], words: str) -> list[PictureCard]:
    """Return the surfaces or the panoramas that fit some words: those of the folder first.

    Args:
        own: Paths in the folder.
        kept: Of the library.
        words: All of them are in name, tags, author or licence; empty for all.
    """
    wanted = words.lower().split()
    cards = [(name, _own_card(name)) for name in own]
    cards += [(" ".join((entry.name, *entry.words, *_credit(entry))), _kept_card(entry)) for entry in kept]
    return [card for text, card in cards if all(word in text.lower() for word in wanted)][:MOST_SHOWN]


def picture_of_own(place: Workplace, name: str) -> bytes:
    """Return a small picture of a surface or a panorama of the folder.

    Args:
        place: The folder.
        name: Path in it.

    Raises:
        InputError: There is none of that name, or it is damaged.
    """
    is_panorama = PurePosixPath(name).suffix.lower() in PANORAMAS
    path = place.panorama(name) if is_panorama else place.surface(name)
    return _drawn(path, path.stat().st_mtime_ns)


def picture_of_file(path: Path) -> bytes:
    """Return a small picture of a file that is a panorama or a picture. Raises InputError."""
    if path.suffix.lower() in PANORAMAS:
        return small_panorama(path)
    try:
        return small_picture(path.read_bytes())
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror})", path=path) from error


@lru_cache(maxsize=256)
def _drawn(path: Path, changed: int) -> bytes:
    return picture_of_file(path)


def _own_card(name: str) -> PictureCard:
    path = PurePosixPath(name)
    return PictureCard(
        file=name,
        entry="",
        named=path.name,
        name=surface_name(Path(name)),
        source="your folder",
        credit="",
        picture=f"/folder/{quote(name)}",
    )


def _kept_card(entry: LibraryEntry) -> PictureCard:
    return PictureCard(
        file="",
        entry=entry.digest,
        named=entry.place,
        name=entry.name,
        source="your library",
        credit=", ".join(_credit(entry)),
        picture=f"/library/{entry.digest}.png",
    )


def _credit(entry: LibraryEntry) -> list[str]:
    return [text for text in (entry.credit.author, entry.credit.license) if text]
