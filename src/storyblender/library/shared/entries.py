"""What the user's library knows of each thing in it."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, StringConstraints

from storyblender.memory.asset_sheet import Credit, Note
from storyblender.memory.base import Digest, Frozen

EntryKind = Literal["model", "texture", "panorama", "motion", "image", "character"]
_MOST_WORDS = 64


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
    """What else it is called, and what the story called it."""
    category: Note = ""
    """For lists and figures: ``furniture``."""
    main: Annotated[str, StringConstraints(max_length=400), AfterValidator(_inside)]
    """Path of the file to read, within the bundle."""
    credit: Credit = Credit()
    source: Note = ""
    """Where it came from: the name of a service, or ``files`` for what a person added."""
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
