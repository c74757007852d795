"""A motion of the user's own, as a story keeps it: what it is called, and the name of the file with its numbers."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, StringConstraints

from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.base import Described, Digest


class MocapClip(Described):
    """A recorded motion that the project keeps in a file named by its content."""

    digest: Annotated[Digest, Field(min_length=32)]
    """Names the content, and the file in the folder ``mocap`` of the project."""
    name: Annotated[str, StringConstraints(min_length=1, max_length=80)]
    """What it is called: the words of its file."""
    seconds: Annotated[float, Field(gt=0, le=600)]
    """Its length."""
    travel: Annotated[float, Field(ge=0, le=100)] = 0.0
    """Metres on the floor from its first place to its last, at a stature of 1.7 m; 0 where it stays."""
    way: Annotated[float, Field(ge=-180, le=180)] = 0.0
    """Degrees from where the person faces first to where the travel leads, counter-clockwise."""
    turns: Annotated[float, Field(ge=-10_000, le=10_000)] = 0.0
    """Degrees that the person turns, counter-clockwise."""
    seated: bool = False
    """Whether it is done on a seat."""
    loops: bool = False
    """Whether it may begin again where it ends."""
    provenance: Provenance
    """The file in the folder of motions, and whose work it is."""
    reason: Annotated[str, StringConstraints(max_length=200)] = ""
    """Why it was chosen."""


def mocap_file(digest: Digest) -> str:
    """Return the name in the project of the file with the numbers of a recorded motion."""
    return f"mocap/{digest}.npz"
