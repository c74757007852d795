"""Finds the seats of a thing: its own, else the front edge of a thing as high as a seat. Pure."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TypeVar

from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

PERCHES, HIGHEST = (0.2, 0.95), 2.4
"""Metres: heights of what one sits on that is no seat, a parcel, a desk, and of what one climbs to sit on, a wall."""
TABLE_GAP, NEAR_TABLE = 0.75, 1.2
"""Most metres from a table to the front edge of a seat that stands at it, and of one near it, which is taken if there
is no other: people sit on the table itself last. The layout and the animator must agree on them.
"""
_ROW_DISTANCE = 0.45
"""Metres between the rows of seats of a vehicle."""
_WIDE, _RAIL = 0.25, 0.3
"""Metres across of what one sits on the front edge of; on a narrower thing, such as a fence, one sits astride its top,
on so much of it.
"""


def list_seats(
    anchors: Iterable[Anchor], dimensions: Vec3, *, asked: bool = False, on_top: bool = False
) -> list[Anchor]:
    """Return the seats of a thing in its own frame.

    Args:
        anchors: Of the thing.
        dimensions: Its width, depth and height in metres.
        asked: Whether a person sits on it because the script says so: without a seat it has one at its front edge.
        on_top: Whether they sit on top even if it is high or narrow, such as a wall or a fence.
    """
    seats = [anchor for anchor in anchors if anchor.kind == "seat"]
    width, depth, height = dimensions
    wide = min(width, depth) > _WIDE
    fits = PERCHES[0] < height < (HIGHEST if on_top else PERCHES[1]) and (wide or on_top)
    if seats or not (asked or on_top) or not fits or any(anchor.kind == "bed" for anchor in anchors):
        return seats
    if wide:
        return [Anchor(kind="seat", location=(0.0, -depth / 2, height), size=(width, depth))]
    facing = (0.0, -1.0, 0.0) if depth < width else (-1.0, 0.0, 0.0)
    edge = (0.5 * _RAIL * facing[0], 0.5 * _RAIL * facing[1], height)
    return [Anchor(kind="seat", location=edge, direction=facing, size=(max(width, depth), _RAIL))]


_Seat = TypeVar("_Seat")


def select_seats(seats: Sequence[_Seat], side: str, ahead: Callable[[_Seat], tuple[float, float]]) -> list[_Seat]:
    """Return the seats of a vehicle on the given side, or all seats if it has none on that side.

    Args:
        seats: Seats of one vehicle.
        side: ``driver`` and ``passenger`` sit in front, left and right of the middle; ``front``, ``rear`` or
            ``back``, ``left`` and ``right`` are sides of the vehicle in its driving direction.
        ahead: Returns the offset of a seat from the vehicle's centre in metres: to its left, and forward.
    """
    if not seats:
        return []
    foremost = max(ahead(seat)[1] for seat in seats)
    rearmost = min(ahead(seat)[1] for seat in seats)
    rows = foremost - rearmost > _ROW_DISTANCE

    def fits(seat: _Seat) -> bool:
        left, on = ahead(seat)
        in_front = not rows or foremost - on < _ROW_DISTANCE
        if side == "driver":
            return in_front and left >= 0
        if side == "passenger":
            return in_front and left < 0
        if side in ("rear", "back"):
            return not in_front
        if side == "front":
            return in_front
        return (left > 0) == (side == "left")

    return [seat for seat in seats if fits(seat)] or list(seats)
