"""Finds the place of a thing on furniture: on the desk, not on the edge of its mirror (notes: engine, section 2)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from storyblender.geometry.relations import StandingSurface

COVERAGE = 0.85
"""Share of a footprint that must rest on the surface."""
_GAP = 0.02
"""Metres between things on one surface."""
_EDGE_MARGIN = 0.02
"""Metres kept from the edge where there is room."""
_GRID_STEP = 0.04
"""Grid of the search for a free place, metres."""


class OpenTop(NamedTuple):
    """A surface and the free height above it in metres; None is open air."""

    surface: StandingSurface
    clearance: float | None = None


class Taken(NamedTuple):
    """A thing that already stands on the asset: centre, bottom and extent in the asset's frame, metres."""

    x: float
    y: float
    z: float
    width: float
    depth: float


class Perch(NamedTuple):
    """The chosen place: centre in the asset's frame, metres; coverage as a share of the footprint, 0..1."""

    surface: StandingSurface
    x: float
    y: float
    coverage: float
    turned: bool
    """True if the thing lies across, a quarter turn from the asset's yaw."""


def choose_perch(
    tops: Sequence[OpenTop],
    size: tuple[float, float, float],
    wish: tuple[float, float] = (0.0, 0.0),
    taken: Sequence[Taken] = (),
) -> Perch | None:
    """Choose surface and place for a thing, or None where it fits nowhere.

    Surfaces with too little free height or coverage are out. Of the others the one with the largest area x coverage
    wins, and on it the free place nearest to the wish; a full surface gives way to the next.

    Args:
        tops: The asset's surfaces.
        size: Width, depth and height of the thing, metres.
        wish: Wanted centre in the asset's frame, metres.
        taken: Things that already stand there.
    """
    fitting: list[tuple[float, float, OpenTop, bool]] = []
    for top in tops:
        if top.clearance is not None and top.clearance < size[2]:
            continue
        for turned in (False, True):
            covered = _coverage(top.surface, size, turned)
            if covered >= COVERAGE:
                fitting.append((top.surface.width * top.surface.depth * covered, covered, top, turned))
    for _, covered, top, turned in sorted(fitting, key=lambda item: (-round(item[0], 4), item[3])):
        width, depth = (size[1], size[0]) if turned else (size[0], size[1])
        place = _free_place(top.surface, width, depth, wish, taken)
        if place is not None:
            return Perch(top.surface, *place, covered, turned)
    return None


def _coverage(surface: StandingSurface, size: tuple[float, float, float], turned: bool) -> float:
    width, depth = (size[1], size[0]) if turned else (size[0], size[1])
    return min(width, surface.width) * min(depth, surface.depth) / max(width * depth, 1e-9)


def _free_place(
    surface: StandingSurface, width: float, depth: float, wish: tuple[float, float], taken: Sequence[Taken]
) -> tuple[float, float] | None:
    """Return the free centre nearest to the wish on one surface."""
    here = [other for other in taken if abs(other.z - surface.z) < 0.05]
    half_x = max((surface.width - width) / 2 - _EDGE_MARGIN, 0.0)
    half_y = max((surface.depth - depth) / 2 - _EDGE_MARGIN, 0.0)
    nearest = (
        min(max(wish[0], surface.x - half_x), surface.x + half_x),
        min(max(wish[1], surface.y - half_y), surface.y + half_y),
    )
    grid = [
        (surface.x - half_x + 2 * half_x * i / columns, surface.y - half_y + 2 * half_y * j / rows)
        for columns in (max(math.ceil(2 * half_x / _GRID_STEP), 1),)
        for rows in (max(math.ceil(2 * half_y / _GRID_STEP), 1),)
        for i in range(columns + 1)
        for j in range(rows + 1)
    ]
    for x, y in sorted([nearest, *grid], key=lambda place: math.dist(place, wish)):
        if all(
            abs(x - other.x) >= (width + other.width) / 2 + _GAP or abs(y - other.y) >= (depth + other.depth) / 2 + _GAP
            for other in here
        ):
            return x, y
    return None
