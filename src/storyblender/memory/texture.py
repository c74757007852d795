"""Pictures of a real surface that walls, floors and grounds are made of: what the graph knows of them."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.base import Color, Frozen

TEXTURES = "assets"
"""Folder of the prepared pictures, each named by its digest."""
TextureMap = Literal["color", "normal", "roughness"]
Metres = Annotated[float, Field(ge=0.01, le=100)]


class Texture(Frozen):
    """A surface as pictures that repeat without a seam."""

    provenance: Provenance
    metres: Metres
    """Width of one repeat of the prepared picture, which is square."""
    color: Color
    """Mean of the colour picture."""
    roughness: float = Field(ge=0, le=1)
    """Mean: 0 is a mirror, 1 is chalk."""
    maps: Annotated[tuple[TextureMap, ...], Field(min_length=1, max_length=3)]
    """What there is of it besides ``color``."""
    upright: bool | None = None
    """Whether its boards run up the picture; None where it has no grain."""

    def file(self, name: TextureMap) -> str:
        """Return the path, in a project, of one of its prepared pictures."""
        return texture_file(self.provenance.digest, name)

    @property
    def files(self) -> tuple[str, ...]:
        """Paths of all its prepared pictures."""
        return tuple(map(self.file, self.maps))


def texture_file(digest: str, name: TextureMap) -> str:
    """Return the path, in a project, of a prepared picture of the surface with this SHA-256."""
    return f"{TEXTURES}/{digest[:16]}_{name}.jpg"
