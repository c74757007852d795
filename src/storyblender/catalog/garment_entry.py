"""Data model of one garment of the wardrobe."""

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
        name: Display name.
        tags: Synonyms.
        layer: Dressing order, innermost first: a jacket goes over a shirt, in whatever order they are listed.
        covers: Body areas it dresses; an undressed upper or lower body gets the default garment.
        colors: Typical colours (hex); the seed picks one if none is given.
        pieces: Pattern pieces it is made of.
        bares: Body areas that stay bare with it: no shoes with a swimsuit.
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
    """Return a garment from the short form of the catalogue.

    Args:
        key: Key in the catalog.
        words: Synonyms, separated by commas.
        layer: Dressing order.
        covers: Body areas it dresses, separated by blanks; areas with a leading minus stay bare.
        colors: Typical hex colours, separated by blanks.
        pieces: Pattern pieces.
        name: Display name; empty for the key in words.
    """
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
