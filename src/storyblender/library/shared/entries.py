"""What the user's library knows of each thing in it."""

from __future__ import annotations

import re
from pathlib import PurePosixPath
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, StringConstraints

from storyblender.memory.asset_sheet import Credit, Note
from storyblender.memory.base import Digest, Frozen

ADDED = "files"
"""The source of what a person added."""
EntryKind = Literal["model", "texture", "panorama", "motion", "image", "character"]
_MOST_WORDS = 64
_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")


def _inside(name: str) -> str:
    path = PurePosixPath(name)
    if path.is_absolute() or ".." in path.parts or "\\" in name or "\0" in name or not path.parts:
        raise ValueError("it should be the path of a file in the bundle")
    return path.as_posix()


class EntryFacts(Frozen):
    """What is told about a bundle of files when it is added.

    A bundle is a main file, what that names (textures, buffers), and the ``credits.toml`` that says whose work it is.
    """

    kind: EntryKind
    name: Annotated[str, StringConstraints(min_length=1, max_length=200)]
    """What people call it; the end of it is the thing: ``Arm Chair 01``."""
    words: Annotated[tuple[Note, ...], Field(max_length=_MOST_WORDS)] = ()
    """What else is said of it: further names where a person added it or a story had it made, the tags of a service."""
    category: Note = ""
    """For lists and figures: ``furniture``."""
    main: Annotated[str, StringConstraints(max_length=400), AfterValidator(_inside)]
    """Path of the file to read, within the bundle."""
    credit: Credit = Credit()
    source: Note = ""
    """Where it came from: the name of a service, or ``ADDED``."""
    source_id: Note = ""
    """What the source calls it."""
    request: Digest = ""
    """Digest of the request that it answers, of what was made for the user."""
    faces: Annotated[int, Field(ge=0)] | None = None


class LibraryEntry(EntryFacts):
    """One bundle in the library."""

    digest: Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{64}$")]
    """SHA-256 over the names and contents of its files."""
    bytes: Annotated[int, Field(ge=0)]
    """Of all its files."""

    @property
    def facts(self) -> EntryFacts:
        """What was told about it."""
        return EntryFacts.model_validate(self.model_dump(exclude={"digest", "bytes"}))

    @property
    def names(self) -> tuple[str, ...]:
        """What it is called; the tags of a service are none of its names."""
        return (self.name, *self.words) if self.request or self.source == ADDED else (self.name,)

    @property
    def place(self) -> str:
        """The folder of its files among the models that a project fetched: ``<source>/<id>``."""
        if _ID.fullmatch(self.source) and _ID.fullmatch(self.source_id):
            return f"{self.source}/{self.source_id}"
        return f"library/{self.digest[:16]}"

    @property
    def key(self) -> str:
        """What a recipe that is made of it has as its key."""
        return f"{self.place}/{self.main}"
