"""The user's library as the page shows it: what is in it, whose work it is, and which stories use it."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from storyblender.errors import InputError
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.base import Described
from storyblender.web_studio.pictures import picture_of_file

MOST_SHOWN = 200
"""Entries at once; words narrow them."""


PICTURED = ("texture", "panorama", "image")
"""Kinds that are pictures themselves."""


class LibraryCard(Described):
    """An entry of the library."""

    digest: str
    """Its first eight digits name it on the command line."""
    name: str
    kind: str
    source: str
    """Where it came from; ``files`` for what a person added."""
    author: str
    licence: str
    """Empty where none is stated."""
    url: str
    """Of the work; empty unless it is an address of the web."""
    megabytes: float
    used: tuple[str, ...]
    """Names of the stories that use it."""
    file: str
    """What an edit of a thing names to have it made from it."""
    picture: str
    """Address; empty where none is drawn."""


class ShownLibrary(Described):
    """What of the library is shown."""

    cards: tuple[LibraryCard, ...]
    """The newest first."""
    found: int
    """All that fit the words."""
    figures: str
    """How much was used again, in a sentence; empty where no story used anything yet."""


def shown_library(words: str) -> ShownLibrary:
    """Return what fits some words.

    Args:
        words: All of them are in name, tags, author or licence; empty for all.

    Raises:
        InputError: The library cannot be read.
    """
    library = SharedLibrary.open()
    found, told = library.find(words), library.uses.figures()
    was = "was" if told.avoided == 1 else "were"
    sentence = (
        f"{told.stories} {'stories' if told.stories != 1 else 'story'} asked for {told.requests} models, "
        f"{told.unique} different ones; {told.avoided} {was} not built or fetched again ({told.reduction:.0f} %)"
    )
    cards = tuple(_card(library, entry) for entry in found[:MOST_SHOWN])
    return ShownLibrary(cards=cards, found=len(found), figures=sentence if told.requests else "")


def picture_of(digest: str) -> Path:
    """Return where the picture of an entry lies, if it is drawn; that of a surface or a panorama is made now.

    Args:
        digest: Of the entry.
    """
    library = SharedLibrary.open()
    path = library.picture(digest)
    if path.is_file():
        return path
    with suppress(InputError):
        entry = next(iter(library.entries([digest])), None)
        if entry is not None and entry.kind in PICTURED:
            library.files.write(library.files.name_of(path), picture_of_file(library.path_of(entry)))
    return path


def _has_picture(library: SharedLibrary, entry: LibraryEntry) -> bool:
    return entry.kind in PICTURED or library.thumbnail_of(entry).is_file()


def _card(library: SharedLibrary, entry: LibraryEntry) -> LibraryCard:
    credit = entry.credit
    return LibraryCard(
        digest=entry.digest,
        name=entry.name,
        kind=entry.kind,
        source=entry.source,
        author=credit.author,
        licence=credit.license,
        url=credit.url if credit.url.startswith(("https://", "http://")) else "",
        megabytes=round(entry.bytes / 1e6, 1),
        used=tuple(dict.fromkeys(Path(story).stem for story, _ in library.uses.of_entry(entry.digest))),
        file=entry.key,
        picture=f"/library/{entry.digest}.png" if _has_picture(library, entry) else "",
    )
