"""Conversion between the graph's layout objects and the solver's things, and the check of every layout."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Final

import numpy as np

from storyblender.catalog.footprints import piece_boxes, wall_boxes
from storyblender.catalog.set_plan import SetPlan
from storyblender.draft_words import fix_in_words
from storyblender.geometry.boxes import Box, footprint_gap, yaw_along
from storyblender.geometry.relations import (
    CONTACT_DISTANCE,
    LayoutThing,
    PlayingArea,
    StandingSurface,
    Violation,
    remedy,
    violations,
)
from storyblender.geometry.seating import list_seats
from storyblender.geometry.support import OpenTop
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Layout, LayoutObject, SceneSize
from storyblender.reflection import Fault

PERSON = (0.5, 0.36)
"""Width and depth in metres of the floor that a standing person takes."""
_SEATED_BEHIND = 0.26
"""Metres from a seat's front edge to the middle of the sitter's trunk."""
_TRUNK = (0.42, 0.3, 0.8)
_FLAT = 0.05
_HUNG = 0.12
"""Most metres from a wall or a ceiling at which a thing counts as hanging."""
_OFF_SEAT, _LIFTED = 0.3, 0.12
"""Metres that a sitter may be beside a seat, and above or below it."""
_TWISTED = 100.0
"""Degrees that a sitter may be turned away from where the seat faces."""
NOWHERE: Final[Mapping[str, str]] = MappingProxyType({})
_SEVERITY = 2.5
"""Points for each violation: one is enough to be refined at the usual threshold of 8."""


def room_of(size: SceneSize) -> PlayingArea:
    """Return the playing area."""
    return PlayingArea(size.x_negative, size.x, size.y_negative, size.y)


def anchors_of(measure: AssetMeasure, kind: str) -> list[Anchor]:
    """Return the anchors of one kind, such as ``seat`` or ``top``, in their order.

    Args:
        measure: Of an asset; anchors are in metres in the asset's own frame.
        kind: A kind of `Anchor`.
    """
    return [anchor for anchor in measure.anchors if anchor.kind == kind]


def tops_of(measure: AssetMeasure) -> list[OpenTop]:
    """Return the surfaces of an asset on which things can stand; the top of its box if it declares none."""
    tops = [
        OpenTop(StandingSurface(*anchor.location, *anchor.size), anchor.clearance)
        for anchor in measure.anchors
        if anchor.kind == "top" and min(anchor.size) > 0
    ]
    width, depth, height = measure.dimensions
    return tops or [OpenTop(StandingSurface(0.0, 0.0, height, width, depth))]


def size_of(measure: AssetMeasure) -> tuple[float, float, float]:
    """Return the width, depth and height in metres that an asset takes; people have their arms down."""
    width, depth, height = measure.dimensions
    if measure.asset_type == "character" and height > 1.05 * max(width, depth):
        return min(width, PERSON[0]), min(depth, PERSON[1]), height
    return width, depth, height


def thing_of(
    item: LayoutObject,
    measures: Mapping[str, AssetMeasure],
    plan: SetPlan,
    placements: Mapping[str, str] = NOWHERE,
) -> LayoutThing | None:
    """Return a layout object as the solver sees it; None if its asset has no measure.

    Args:
        item: The object.
        measures: Measures by asset id.
        plan: The set, to tell whether the object hangs.
        placements: ``floor``, ``surface``, ``wall`` or ``ceiling`` by asset id, where it is known.
    """
    measure = measures.get(item.asset_id)
    if measure is None:
        return None
    x, y, z = item.location
    yaw = math.radians(item.rotation[2])
    is_person = measure.asset_type == "character"
    if is_person and is_seated(item):
        width, depth, height = _TRUNK
        box = Box(x - math.sin(yaw) * _SEATED_BEHIND, y + math.cos(yaw) * _SEATED_BEHIND, z, width, depth, height, yaw)
    else:
        box = Box(x, y, z, *_rotated_extent(size_of(measure), item.rotation), yaw)
    thing = LayoutThing(
        item.node_id, box, item.anchor_asset_id, item.relationship, item.contact, item.direction,
        mass=1.0 if is_person else mass_of(measure.dimensions), fixed=item.fixed, walks=is_person,
    )  # fmt: skip
    stands = is_person or item.anchor_asset_id is not None or placements.get(item.asset_id) in ("floor", "surface")
    thing.floats = item.fixed or (z > _FLAT and not stands and is_hanging(box, plan))
    return thing


def is_seated(item: LayoutObject) -> bool:
    """Return whether an object of the layout is a person on a seat or a bed."""
    return item.anchor_asset_id is not None and item.relationship is None and item.direction is None


def _rotated_extent(size: tuple[float, float, float], rotation: Sequence[float]) -> tuple[float, float, float]:
    """Return the width, depth and height of a thing after its rotation around x and y (degrees); yaw is left out."""
    rx, ry = math.radians(rotation[0]), math.radians(rotation[1])
    turn_x = np.array([[1, 0, 0], [0, math.cos(rx), -math.sin(rx)], [0, math.sin(rx), math.cos(rx)]])
    turn_y = np.array([[math.cos(ry), 0, math.sin(ry)], [0, 1, 0], [-math.sin(ry), 0, math.cos(ry)]])
    width, depth, height = np.abs(turn_y @ turn_x) @ np.asarray(size)
    return float(width), float(depth), float(height)


def mass_of(size: tuple[float, float, float]) -> float:
    """Return how hard the solver finds it to move a thing of this width, depth and height in metres, 0.3 to 8."""
    width, depth, height = size
    return min(max(6.0 * width * depth * max(height, 0.3), 0.3), 8.0)


def is_hanging(box: Box, plan: SetPlan) -> bool:
    """Return whether a box touches a wall or a ceiling of the set.

    Args:
        box: Of the thing, world metres.
        plan: The set.
    """
    ceilings = [slab.z for slab in plan.slabs if slab.role == "ceiling"]
    if any(abs(height - box.top) < 2 * _HUNG for height in ceilings):
        return True
    return any(footprint_gap(box, wall.box)[0] < _HUNG for wall in walls_of(plan))


def walls_of(plan: SetPlan) -> list[LayoutThing]:
    """Return walls and solid parts of the set as fixed boxes."""
    solid = [(part.node_id, wall_boxes(part)) for part in plan.walls]
    solid += [(part.node_id, piece_boxes(part)) for part in plan.pieces]
    return [
        LayoutThing(f"{node_id}_{index}", box, fixed=True, floats=True)
        for node_id, boxes in solid
        for index, box in enumerate(boxes)
    ]


def layout_object_of(thing: LayoutThing, asset_id: str) -> LayoutObject:
    """Return a solved thing as the graph stores it, rounded to a millimetre and a tenth of a degree.

    Args:
        thing: Its box is in world metres; a sitter is stored at the seat's front edge.
        asset_id: The asset that it shows.
    """
    box = thing.box
    x, y, z = box.x, box.y, box.z
    if thing.walks and thing.anchor is not None and thing.relationship is None and thing.direction is None:
        x, y = box.to_world(0.0, -_SEATED_BEHIND)
    return LayoutObject(
        node_id=thing.name,
        asset_id=asset_id,
        location=(round(x, 3), round(y, 3), round(z, 3)),
        rotation=(0.0, 0.0, round(math.degrees(box.yaw), 1)),
        anchor_asset_id=thing.anchor,
        relationship=thing.relationship,  # pyright: ignore[reportArgumentType]
        contact=thing.contact,
        direction=thing.direction,  # pyright: ignore[reportArgumentType]
        fixed=thing.fixed and thing.floats and not thing.walks,
    )


def seat_box(x: float, y: float, z: float, yaw: float) -> Box:
    """Return the trunk of a sitter, world metres: seat's front edge at (x, y, z), facing ``yaw`` radians (0 is -Y)."""
    return Box(x - math.sin(yaw) * _SEATED_BEHIND, y + math.cos(yaw) * _SEATED_BEHIND, z, *_TRUNK, yaw)


def assign_surfaces(
    things: Sequence[LayoutThing], assets: Mapping[str, str], measures: Mapping[str, AssetMeasure]
) -> None:
    """Set the surface on which each thing stands, if it stands on another: the nearest one that has room for it.

    Args:
        things: The things; changed in place.
        assets: Asset ids by the things' names.
        measures: Measures by asset id.
    """
    by_name = {thing.name: thing for thing in things}
    for thing in things:
        anchor = by_name.get(thing.anchor or "")
        if thing.relationship != "on_top_of" or anchor is None:
            continue
        lift = thing.box.z - anchor.box.z
        tops = sorted(tops_of(measures[assets[anchor.name]]), key=lambda top: abs(top.surface.z - lift))
        nearest = tops[0].surface
        roomy = (
            [top.surface for top in tops if _has_room(top, thing)] if abs(nearest.z - lift) > CONTACT_DISTANCE else []
        )
        thing.surface = next(iter(roomy), nearest)


def _has_room(top: OpenTop, thing: LayoutThing) -> bool:
    """Return whether a thing fits on a surface, straight or turned by a quarter, and under what is above it."""
    small, large = sorted((thing.box.width, thing.box.depth))
    narrow, wide = sorted((top.surface.width, top.surface.depth))
    return small <= narrow and large <= wide and (top.clearance is None or thing.box.height <= top.clearance)


def layout_violations(
    layout: Layout, measures: Mapping[str, AssetMeasure], plan: SetPlan, placements: Mapping[str, str] = NOWHERE
) -> tuple[Fault, ...]:
    """Return everything that is geometrically wrong with a layout, each with its exact fix; empty if it is valid.

    Args:
        layout: The layout to check.
        measures: Measures by asset id; an object without one is not checked.
        plan: The set, for its walls and solid parts.
        placements: ``floor``, ``surface``, ``wall`` or ``ceiling`` by asset id, where it is known.
    """
    things = [thing for item in layout.objects if (thing := thing_of(item, measures, plan, placements)) is not None]
    assign_surfaces(things, {item.node_id: item.asset_id for item in layout.objects}, measures)
    everything = [*things, *walls_of(plan)]
    room = room_of(layout.scene_size)
    found = tuple(fault_of(violation, everything, room) for violation in violations(everything, room))
    return (*off_seats(layout, measures), *found)


def off_seats(layout: Layout, measures: Mapping[str, AssetMeasure]) -> tuple[Fault, ...]:
    """Return a fault for each sitter who is not on a seat of their furniture; the fix brings them to the nearest.

    Args:
        layout: The layout to check.
        measures: Measures by asset id.
    """
    items = {item.node_id: item for item in layout.objects if item.asset_id in measures}
    found: list[Fault] = []
    for item in items.values():
        anchor = items.get(item.anchor_asset_id or "")
        if anchor is None or not is_seated(item) or measures[item.asset_id].asset_type != "character":
            continue
        seats = [_seat_place(anchor, seat) for seat in _seats_of(measures[anchor.asset_id])]
        place, turned = min(seats, key=lambda seat: math.dist(seat[0], item.location), default=(item.location, 0.0))
        move = [there - here for there, here in zip(place, item.location, strict=True)]
        turn = (turned - item.rotation[2] + 180.0) % 360.0 - 180.0
        off = max(math.hypot(move[0], move[1]) - _OFF_SEAT, abs(move[2]) - _LIFTED)
        if seats and (off > 0 or abs(turn) > _TWISTED):
            amount = f"{math.hypot(*move):.2f} m" if off > 0 else f"{abs(turn):.0f} degrees"
            fix = {f"move_{axis}": round(step, 3) for axis, step in zip("xyz", move, strict=True)} | {"turn": turn}
            found.append(_fault("contact" if off > 0 else "direction", item.node_id, anchor.node_id, amount, fix))
    return tuple(found)


def _seats_of(measure: AssetMeasure) -> list[Anchor]:
    """Return where people sit and lie on an asset."""
    return [*anchors_of(measure, "bed"), *list_seats(measure.anchors, measure.dimensions, asked=True)]


def _seat_place(furniture: LayoutObject, seat: Anchor) -> tuple[Vec3, float]:
    """Return the place of a sitter on a seat, and the yaw in degrees that the seat faces."""
    x, y, z = furniture.location
    yaw = furniture.rotation[2]
    there = Box(x, y, z, 0.0, 0.0, 0.0, math.radians(yaw)).to_world(*seat.location[:2])
    return (*there, z + seat.location[2]), yaw + math.degrees(yaw_along(*seat.direction[:2]))


def fault_of(violation: Violation, things: Sequence[LayoutThing], room: PlayingArea) -> Fault:
    """Return a violation of the solver as a fault with its fix.

    Args:
        violation: The violation.
        things: Everything in the layout and the set.
        room: The playing area.
    """
    fix = {name: round(value, 3) for name, value in remedy(violation, things, room).items()}
    angular = violation.kind in ("direction", "relationship")
    amount = f"{math.degrees(violation.amount):.0f} degrees" if angular else f"{violation.amount:.2f} m"
    return _fault(violation.kind, violation.subject, violation.other, amount, fix)


def _fault(kind: str, subject: str, other: str | None, amount: str, fix: Mapping[str, float]) -> Fault:
    towards = f" and {other}" if other else ""
    mend = fix_in_words(fix) or "none known"
    message = f"{kind} of {subject}{towards}: {amount} too much; fix: {mend}"
    return Fault(kind=kind, subject=subject, severity=_SEVERITY, message=message, fix=dict(fix))
