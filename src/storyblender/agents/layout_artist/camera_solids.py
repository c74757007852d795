"""What stands in a camera's way on the floor plan: things, solid pieces of the set, piers, blocks and bodies."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from storyblender.catalog.footprints import piece_boxes
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Figure

_BODY, _HEAD = 0.24, 0.12
"""Metres: radius of a person who stands in the way, and of the head."""
_ABOARD = 0.45
"""Metres that a boat or a carriage reaches past whoever is in it, on every side; a chair or a sofa does not."""
_BOARD = 0.06
"""Metres: the thickness of a side of it, or of a table's top."""
_NECK = 1.4
"""Heads from the crown down to the shoulders."""


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


def body(figure: Figure) -> list[Box]:
    """Return the boxes of somebody who stands or sits there: up to the shoulders, and the head between them."""
    x, y, _ = figure.face
    low, crown = figure.base[2], figure.crown[2]
    neck = max(crown - _NECK * figure.head, low + 0.1)
    return [
        Box(x, y, low, 2 * _BODY, 2 * _BODY, neck - low),
        Box(x, y, neck, 2 * _HEAD, 2 * _HEAD, max(crown - neck, 0.05)),
    ]


def holds(box: Box, figure: Figure) -> bool:
    """Return whether somebody is in a thing, as in a boat or a carriage."""
    x, y = box.to_local(figure.base[0], figure.base[1])
    aboard = min(box.width / 2 - abs(x), box.depth / 2 - abs(y)) > _ABOARD
    return aboard and box.z < (figure.base[2] + figure.crown[2]) / 2 < box.top


def aboard(boxes: Iterable[Box], people: Sequence[Figure]) -> bool:
    """Return whether any of the people are in a thing, as in a boat."""
    return any(holds(box, figure) for box in boxes for figure in people)


def opened(boxes: Sequence[Box], figure: Figure) -> list[Box]:
    """Return the boxes as somebody is seen past them: of what they are in, only the four sides stand in the way."""
    found: list[Box] = []
    for box in boxes:
        found += _sides(box) if holds(box, figure) else [box]
    return found


def lidded(box: Box) -> Box:
    """Return a thing's top alone: what hides a hand below a table."""
    thick = min(_BOARD, box.height)
    return replace(box, z=box.top - thick, height=thick)


def _sides(box: Box) -> list[Box]:
    across, along = (box.width - _BOARD) / 2, (box.depth - _BOARD) / 2
    found: list[Box] = []
    for x, y, width, depth in (
        (-across, 0.0, _BOARD, box.depth),
        (across, 0.0, _BOARD, box.depth),
        (0.0, -along, box.width, _BOARD),
        (0.0, along, box.width, _BOARD),
    ):
        found.append(Box(*box.to_world(x, y), box.z, width, depth, box.height, box.yaw))
    return found
