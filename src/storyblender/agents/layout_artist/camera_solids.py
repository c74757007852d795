"""What stands in a camera's way on the floor plan: things, solid pieces of the set, piers, blocks and bodies."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

from storyblender.catalog.set_plan import Piece, SetPlan
from storyblender.catalog.sets.arcades import piers
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Figure

_HIGH = 4.0
"""Metres: a solid piece of the set is taken to be this high."""
_BODY = 0.24
"""Metres: radius of a person who stands in the way."""


def solids(props: dict[str, Box], plan: SetPlan | None, hidden: Collection[str]) -> list[Box]:
    """Return the boxes of everything that stands on the set, but for what is hidden."""
    found = [box for node, box in props.items() if node not in hidden]
    if plan is None:
        return found
    for piece in plan.pieces:
        if piece.node_id not in hidden:
            found += piece_boxes(piece)
    for slab in plan.slabs:
        if slab.role == "block" and slab.node_id not in hidden and slab.thickness > 0:
            xs, ys = zip(*slab.polygon, strict=True)
            middle = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, slab.z - slab.thickness)
            found.append(Box(*middle, max(xs) - min(xs), max(ys) - min(ys), slab.thickness))
    return found


def piece_boxes(piece: Piece) -> list[Box]:
    """Return the boxes of a set piece: its footprint, or the piers of an arcade; none for what nobody bumps into."""
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
    return [Box(*piece.location, width, depth, _HIGH, yaw)]


def body(figure: Figure) -> Box:
    """Return the box of somebody who stands or sits there."""
    x, y, _ = figure.face
    low = figure.base[2]
    return Box(x, y, low, 2 * _BODY, 2 * _BODY, figure.crown[2] - low)
