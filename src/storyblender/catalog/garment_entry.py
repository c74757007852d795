"""What the wardrobe knows of one garment. Data only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from storyblender.catalog.cuts import AnyPiece

Area = Literal["upper", "lower", "feet", "head"]


@dataclass(frozen=True)
class GarmentSpec:
    """A garment.

    Attributes:
        key: Key in the catalog.
        name: For people.
        tags: Other words for it.
        layer: Garments are put on in this order, so a jacket goes over a shirt in whatever order they were named.
        covers: What it dresses; a person without upper or lower gets the default there.
        colors: Typical colours (hex); the seed picks one where none is given.
        pieces: What it is sewn from.
        bares: What stays bare with it: nobody wears shoes to a swimsuit.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    layer: int
    covers: tuple[Area, ...]
    colors: tuple[str, ...]
    pieces: tuple[AnyPiece, ...]
    bares: tuple[Area, ...] = ()


def garment(
    key: str, words: str, layer: int, covers: str, colors: str, *pieces: AnyPiece, name: str = ""
) -> GarmentSpec:
    """Return a garment; an area after a minus stays bare with it."""
    return GarmentSpec(
        key=key,
        name=name or key.replace("_", " "),
        tags=tuple(words.split(", ")),
        layer=layer,
        covers=tuple(area for area in covers.split() if area[0] != "-"),  # type: ignore[arg-type]
        bares=tuple(area[1:] for area in covers.split() if area[0] == "-"),  # type: ignore[arg-type]
        colors=tuple(colors.split()),
        pieces=pieces,
    )
