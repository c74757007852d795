"""Where one sits on a thing: on its own seats, else on the edge of what is as high as a seat. Pure."""

from __future__ import annotations

from collections.abc import Iterable

from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

PERCHES = (0.2, 0.95)
"""Metres: heights of what one sits on that is no seat: a parcel, a desk."""
_WIDE = 0.25
"""Metres across, at least, of what one sits on."""


def seats_of(anchors: Iterable[Anchor], dimensions: Vec3, *, asked: bool = False) -> list[Anchor]:
    """Return the seats of a thing in its own frame.

    Args:
        anchors: Of the thing.
        dimensions: Its width, depth and height in metres.
        asked: Whether somebody sits on it because the script says so: without a seat it has one at its front edge.
    """
    seats = [anchor for anchor in anchors if anchor.kind == "seat"]
    width, depth, height = dimensions
    fits = PERCHES[0] < height < PERCHES[1] and min(width, depth) > _WIDE
    if seats or not asked or not fits or any(anchor.kind == "bed" for anchor in anchors):
        return seats
    return [Anchor(kind="seat", location=(0.0, -depth / 2, height), size=(width, depth))]
