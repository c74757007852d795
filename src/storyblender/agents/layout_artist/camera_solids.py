"""Boxes that stand in a camera's way: things, solid pieces of the set, blocks and bodies."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from storyblender.catalog.footprints import piece_boxes
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Figure

_BODY, _HEAD = 0.24, 0.12
"""Metres: radius of a standing person, and of the head."""
_ABOARD = 0.45
"""Metres that a boat or a carriage extends past a person in it, on every side; a chair does not."""
_BOARD = 0.06
"""Metres: thickness of its sides, and of a table's top."""
_NECK = 1.4
"""Heads from the crown down to the shoulders."""


def solid_boxes(props: dict[str, Box], plan: SetPlan | None, hidden: Collection[str]) -> list[Box]:
    """Return the boxes of all things and solid parts of the set that are not hidden.

    Args:
        props: Boxes of things by node_id.
        plan: The set; None on an empty stage.
        hidden: node_ids to leave out.
    """
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


def body_boxes(figure: Figure) -> list[Box]:
    """Return the boxes of a person: body up to the shoulders, and head."""
    x, y, _ = figure.face
    low, crown = figure.base[2], figure.crown[2]
    neck = max(crown - _NECK * figure.head, low + 0.1)
    return [
        Box(x, y, low, 2 * _BODY, 2 * _BODY, neck - low),
        Box(x, y, neck, 2 * _HEAD, 2 * _HEAD, max(crown - neck, 0.05)),
    ]


def contains_person(box: Box, figure: Figure) -> bool:
    """Return whether a person is inside a thing such as a boat or a carriage.

    Args:
        box: Of the thing, world metres.
        figure: The person at one moment.
    """
    x, y = box.to_local(figure.base[0], figure.base[1])
    aboard = min(box.width / 2 - abs(x), box.depth / 2 - abs(y)) > _ABOARD
    return aboard and box.z < (figure.base[2] + figure.crown[2]) / 2 < box.top


def is_anyone_aboard(boxes: Iterable[Box], people: Sequence[Figure]) -> bool:
    """Return whether any of the people is inside one of the things.

    Args:
        boxes: Of the things, world metres.
        people: All at the same moment.
    """
    return any(contains_person(box, figure) for box in boxes for figure in people)


def open_vessels(boxes: Sequence[Box], figure: Figure) -> list[Box]:
    """Return the boxes with every one that contains the person replaced by its four sides.

    Args:
        boxes: Of things and parts of the set, world metres.
        figure: The person at one moment.
    """
    found: list[Box] = []
    for box in boxes:
        found += _side_boxes(box) if contains_person(box, figure) else [box]
    return found


def top_slab(box: Box) -> Box:
    """Return the top of a thing as a thin box, such as a table's."""
    thick = min(_BOARD, box.height)
    return replace(box, z=box.top - thick, height=thick)


def _side_boxes(box: Box) -> list[Box]:
    """Return the four sides of a box as thin boxes."""
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
