"""Finds seats and beds on any shape: level places at the right height, and the back that rises behind them. Pure.

The shape comes as a field of level places, as rays from above meet them. Metres, Z up; nothing is known of its front.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.rectangles import close_seams, largest_rectangle
from storyblender.memory.asset_sheet import Anchor

Floats = NDArray[np.float64]
Use = Literal["seat", "bed", "other", ""]
"""Use of a thing by its name; empty where the name says nothing."""

SEAT_HEIGHTS = {"seat": (0.2, 0.9), "": (0.3, 0.62)}
"""Metres of the sitting surface, for what is called a seat and for what has no known name."""
BED_HEIGHTS = {"bed": (0.12, 1.1), "": (0.25, 0.75)}
_MIN_HEADROOM = 0.85
"""Metres free above a seat or a bed. A back is lower than that above the seat's own board, which may go on under it."""
_MAX_SEAM = 0.045
"""Metres between slats that one sits across."""
_SEAT_LEAST = 0.2
"""Metres across the smallest seat."""
_SEAT_AREA = 0.045
"""Square metres of the smallest seat."""
_SEAT_UNEVENNESS, _SOFT_BED = 0.09, 0.2
"""Metres that one seat or bed may vary in height: cushions, blankets and pillows."""
_SEAT_HEIGHT = 0.45
"""Metres: the usual height of a seat."""
_MOST_LEVELS = 5
"""Levels of a thing that are looked at for a seat."""
_SITTER_WIDTH = 0.52
"""Metres of width for each of several sitters."""
_MAX_SEAT_DEPTH = 0.6
"""Metres: largest distance of a sitting point from the seat's front edge."""
_BED = (0.55, 1.25)
"""Metres: least width and length of a bed."""
_BACK, _CLEARER = 0.14, 0.1
"""Metres by which a back rises above the seat, and by which it is higher than what is opposite."""
_FOOTWELL = (0.12, 0.45)
"""Metres by which the floor before a seat is lower at least, and how far before it feet are."""
_BACK_SEARCH = 0.4
"""Metres behind a seat in which its back is looked for."""


@dataclass(frozen=True)
class LevelGrid:
    """Level places on a grid.

    Attributes:
        cell: Metres of a cell.
        origin: (2,) x and y of the grid's lower corner.
        top: (rows, columns) highest point of each cell, -inf where nothing is.
        row: (n,) of each level place.
        column: (n,) of each level place.
        z: (n,) its height.
        room: (n,) free height above it, inf if open.
    """

    cell: float
    origin: Floats
    top: Floats
    row: NDArray[np.int64]
    column: NDArray[np.int64]
    z: Floats
    room: Floats


@dataclass(frozen=True)
class Rest:
    """A rectangle to sit or lie on: its edges in x and y, its height, and how far each side rises above it.

    ``rises`` is in the order -X, +X, -Y, +Y.
    """

    low: tuple[float, float]
    high: tuple[float, float]
    z: float
    rises: tuple[float, float, float, float]

    @property
    def size(self) -> tuple[float, float]:
        """Extent in x and y."""
        return self.high[0] - self.low[0], self.high[1] - self.low[1]

    def behind(self) -> int | None:
        """Return the side of the back (0 to 3, as in ``rises``); None if no side clearly rises over its opposite."""
        sides = [(self.rises[side] - max(self.rises[side ^ 1], 0.0), side) for side in range(4)]
        gain, side = max(sides)
        return side if gain > _CLEARER and self.rises[side] > _BACK else None


_FACING = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))
"""Unit direction that a sitter faces, by the side of the back (in the order of ``Rest.rises``)."""


@dataclass(frozen=True)
class Places:
    """Seats and beds of a thing.

    Attributes:
        anchors: Beds and seats; the first one tells which way it faces.
        backed: Whether a back or a headboard says which way that is.
    """

    anchors: tuple[Anchor, ...] = ()
    backed: bool = False


def find_seats(field: LevelGrid, use: Use, *, faces_front: bool = False, cabin: bool = False) -> Places:
    """Return the seats of a thing, side by side in one row; nothing if its name is that of no seat.

    What has no known name must have a back to be sat on.

    Args:
        field: Its level places.
        use: What it is called.
        faces_front: Whether one sits on it facing -Y in any case, as on what is ridden or driven.
        cabin: Whether it has a floor to stand on, which is no seat: a seat then has room for feet before it.
    """
    if use not in SEAT_HEIGHTS:
        return Places()
    levels = _levels(field, SEAT_HEIGHTS[use], _MIN_HEADROOM, _SEAT_UNEVENNESS)
    large = [each for each in levels if min(each.size) >= _SEAT_LEAST and math.prod(each.size) >= _SEAT_AREA]
    large = [each for each in large if not cabin or _has_footwell(field, each)]
    if not large:
        return Places()
    rest = large[0] if faces_front else max(large, key=_seat_likeness)
    back = 3 if faces_front else rest.behind()
    if back is None and use != "seat":
        return Places()
    if back is None:
        return Places(tuple(_seat_row(rest, 3 if rest.size[0] >= 0.7 * rest.size[1] else 0)))
    return Places(tuple(_seat_row(rest, back)), backed=not faces_front)


def _has_footwell(field: LevelGrid, rest: Rest) -> bool:
    """Return whether there is a floor for the feet of one who sits on a rectangle and faces -Y."""
    x = field.origin[0] + (field.column + 0.5) * field.cell
    y = field.origin[1] + (field.row + 0.5) * field.cell
    ahead = (x > rest.low[0]) & (x < rest.high[0]) & (y < rest.low[1]) & (y > rest.low[1] - _FOOTWELL[1])
    floor = ahead & (field.z < rest.z - _FOOTWELL[0]) & (field.room > _FOOTWELL[0])
    cells = len(np.unique(np.stack([field.row[floor], field.column[floor]]), axis=1).T) if floor.any() else 0
    return cells * field.cell**2 > 0.3 * rest.size[0] * _FOOTWELL[1]


def _seat_likeness(rest: Rest) -> float:
    """Return how much a level is like a seat: large, with a back, as high as knees; the top of a back is none of it."""
    height = math.exp(-(((rest.z - _SEAT_HEIGHT) / 0.2) ** 2))
    return math.prod(rest.size) * (0.1 + height) * (1.0 if rest.behind() is None else 3.0)


def _seat_row(rest: Rest, back: int) -> Iterator[Anchor]:
    ahead = np.array(_FACING[back])
    across = np.array([-ahead[1], ahead[0]])
    middle = (np.array(rest.low) + rest.high) / 2
    depth, width = rest.size if back < 2 else rest.size[::-1]
    count = max(1, int(width / _SITTER_WIDTH + 0.12))
    front = middle + ahead * depth / 2
    for index in range(count):
        x, y = front + across * (index - (count - 1) / 2) * width / count
        yield Anchor(
            kind="seat",
            name=f"seat_{index + 1}" if count > 1 else "",
            location=(float(x), float(y), rest.z),
            direction=(float(ahead[0]), float(ahead[1]), 0.0),
            size=(width / count, min(depth, _MAX_SEAT_DEPTH)),
        )


def find_bed(field: LevelGrid, use: Use) -> Places:
    """Return the bed of a thing and the seats on its long edges; nothing if its name is that of no bed.

    What has no known name must have a headboard and a bed's size.

    Args:
        field: Its level places.
        use: What it is called.
    """
    if use not in BED_HEIGHTS:
        return Places()
    rest = _largest_level(field, BED_HEIGHTS[use], _MIN_HEADROOM, _SOFT_BED)
    if rest is None or min(rest.size) < _BED[0] or max(rest.size) < _BED[1]:
        return Places()
    head = rest.behind()
    if head is None or rest.size[head // 2] < max(rest.size) - 0.35:
        return Places(tuple(_bed_anchors(rest, _pillow_side(field, rest)))) if use == "bed" else Places()
    if use != "bed" and not (1.7 < max(rest.size) < 2.4 and min(rest.size) > 0.7):
        return Places()
    return Places(tuple(_bed_anchors(rest, head)), backed=True)


def _pillow_side(field: LevelGrid, rest: Rest) -> int:
    """Return the end whose part of the bed is higher; +Y or +X if both are alike."""
    along = 0 if rest.size[0] > rest.size[1] + 0.15 else 1
    at = [field.column, field.row][along] * field.cell + field.origin[along]
    share = (at - rest.low[along]) / max(rest.size[along], 1e-6)
    near = np.abs(field.z - rest.z) < _SOFT_BED + 0.1
    ends = [field.z[near & (share >= low) & (share <= high)] for low, high in ((0.0, 0.25), (0.75, 1.0))]
    means = [float(end.mean()) if len(end) else -1.0 for end in ends]
    return 2 * along + (0 if means[0] > means[1] + 0.02 else 1)


def _bed_anchors(rest: Rest, head: int) -> Iterator[Anchor]:
    feet = np.array(_FACING[head])
    side = np.array([-feet[1], feet[0]])
    middle = (np.array(rest.low) + rest.high) / 2
    length, width = rest.size if head < 2 else rest.size[::-1]
    yield Anchor(
        kind="bed",
        location=(float(middle[0]), float(middle[1]), rest.z + 0.02),
        direction=(float(feet[0]), float(feet[1]), 0.0),
        size=(width, length),
    )
    for name, way in (("edge_right", side), ("edge_left", -side)):
        x, y = middle + way * (width / 2 - 0.02) + feet * 0.1
        yield Anchor(
            kind="seat",
            name=name,
            location=(float(x), float(y), rest.z),
            direction=(float(way[0]), float(way[1]), 0.0),
            size=(length * 0.6, min(width, _MAX_SEAT_DEPTH)),
        )


def _largest_level(field: LevelGrid, heights: tuple[float, float], room: float, soft: float) -> Rest | None:
    """Return the largest rectangle of the fullest level within the heights, if there is any."""
    return next(_levels(field, heights, room, soft), None)


def _levels(field: LevelGrid, heights: tuple[float, float], room: float, soft: float) -> Iterator[Rest]:
    """Yield the largest rectangle of each level within the heights, the fullest level first."""
    left = (field.z >= heights[0]) & (field.z <= heights[1]) & (field.room >= room)
    for _ in range(_MOST_LEVELS):
        if not left.any():
            return
        z = np.sort(field.z[left])
        last = np.searchsorted(z, z + soft, side="right")
        first = int(np.argmax(last - np.arange(len(z))))
        level = left & (field.z >= z[first]) & (field.z <= z[last[first] - 1])
        left &= ~level
        yield _rest_of(field, level, float(z[last[first] - 1]))


def _rest_of(field: LevelGrid, level: NDArray[np.bool_], upper: float) -> Rest:
    """Return the largest rectangle of a level, whose highest place is at ``upper``."""
    free = np.zeros(field.top.shape, bool)
    free[field.row[level], field.column[level]] = True
    heights_of = np.full(field.top.shape, np.nan)
    heights_of[field.row[level], field.column[level]] = field.z[level]
    free |= close_seams(free, field.cell, _MAX_SEAM) & (field.top < upper + 0.12)
    row, column, rows, columns = largest_rectangle(free)
    part = np.s_[row : row + rows, column : column + columns]
    low = field.origin + np.array([column, row]) * field.cell
    high = low + np.array([columns, rows]) * field.cell
    sitting = float(np.nanmedian(heights_of[part]))
    rises = _side_rises(field, (row, column, rows, columns), sitting)
    return Rest((float(low[0]), float(low[1])), (float(high[0]), float(high[1])), sitting, rises)


def _side_rises(field: LevelGrid, place: tuple[int, int, int, int], z: float) -> tuple[float, float, float, float]:
    """Return how far the shape rises beyond each side of a rectangle, on average over the side's middle part."""
    row, column, rows, columns = place
    beyond = max(1, round(_BACK_SEARCH / field.cell))
    height = np.where(np.isfinite(field.top), field.top, -np.inf)

    def rise(lines: Floats) -> float:
        """``lines`` has a row for each place along the side, and goes outwards."""
        skip = int(0.15 * len(lines))
        lines = lines[skip : len(lines) - skip]
        if not lines.size:
            return 0.0
        return float(np.clip(lines.max(axis=1) - z, 0.0, 0.8).mean())

    return (
        rise(height[row : row + rows, max(0, column - beyond) : column]),
        rise(height[row : row + rows, column + columns : column + columns + beyond]),
        rise(height[max(0, row - beyond) : row, column : column + columns].T),
        rise(height[row + rows : row + rows + beyond, column : column + columns].T),
    )
