"""Walls and solid pieces of a set as upright boxes that people and props must stay out of. Pure."""

from __future__ import annotations

import math
from dataclasses import replace

from storyblender.catalog.arcades import piers
from storyblender.catalog.set_plan import Piece, SetPlan, Wall
from storyblender.geometry.boxes import Box

_HIGH = 4.0
"""Height of a solid piece in metres, unless its parameter ``tall`` says otherwise."""
_STEP = 0.3
"""Openings with a sill lower than this, in metres, can be walked through."""
_SLIVER = 0.02
"""Pieces of wall narrower than this, in metres, are left out."""


_STAGE, _SHARE = 1.25, 0.28
"""Metres and share of the narrower side of a set: the smaller is half the side of the square kept free for people."""


def stage_box(plan: SetPlan, more: float = 0.0) -> Box:
    """Return the square around the centre of a set that furniture leaves free for people.

    Args:
        plan: The set.
        more: Metres added on each side.
    """
    size = plan.size
    narrow = min(size.x - size.x_negative, size.y - size.y_negative)
    half = min(_STAGE, _SHARE * narrow) + more
    x, y = next((mark.location[:2] for mark in plan.marks if "centre" in mark.tags), (0.0, 0.0))
    return Box(x, y, 0.0, 2 * half, 2 * half, 2.0)


def wall_boxes(wall: Wall) -> list[Box]:
    """Return the boxes of a wall between its doors, arches and gaps; the room's face of a box is the wall's line."""
    length = math.dist(wall.start, wall.end)
    ux, uy = (wall.end[0] - wall.start[0]) / length, (wall.end[1] - wall.start[1]) / length
    ways = sorted(
        (hole.x, hole.x + hole.width) for hole in wall.openings if hole.kind != "window" and hole.sill < _STEP
    )
    boxes, start, out = [], 0.0, wall.thickness / 2
    for first, last in [*ways, (length, length)]:
        if first - start > _SLIVER:
            along = (start + first) / 2
            x, y = wall.start[0] + ux * along + uy * out, wall.start[1] + uy * along - ux * out
            boxes.append(Box(x, y, wall.base, first - start, wall.thickness, wall.height, math.atan2(uy, ux)))
        start = last
    return boxes


def piece_boxes(piece: Piece) -> list[Box]:
    """Return the boxes of a set piece that people walk around: its footprint, or the piers of an arcade; else none."""
    yaw = math.radians(piece.yaw)
    if piece.part == "arcade":
        width, height, depth = (float(piece.params[name]) for name in ("width", "height", "depth"))
        whole = Box(*piece.location, width, depth, height, yaw)
        return [
            replace(whole, x=x, y=y, width=right - left)
            for left, right in piers(width, height, int(piece.params["arches"]))
            for x, y in [whole.to_world((left + right) / 2, 0.0)]
        ]
    if not piece.solid or piece.footprint is None:
        return []
    width, depth = (size * piece.scale for size in piece.footprint)
    return [Box(*piece.location, width, depth, float(piece.params.get("tall", _HIGH)), yaw)]
