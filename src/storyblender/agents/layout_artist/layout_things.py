"""Between the graph's layout and the solver's things, and the check that every layout has to pass."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from storyblender.catalog.footprints import piece_boxes, wall_boxes
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box, footprint_gap
from storyblender.geometry.relations import Room, Surface, Thing, Violation, remedy, violations
from storyblender.geometry.support import Top
from storyblender.memory.asset_sheet import Anchor
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
"""Metres from a wall or a ceiling at which a thing hangs on it."""
_SEVERITY = 2.5
"""Points for each violation: validity is binary, so one is enough to be refined at the usual threshold of 8."""


def room_of(size: SceneSize) -> Room:
    """Return the playing area."""
    return Room(size.x_negative, size.x, size.y_negative, size.y)


def anchors_of(measure: AssetMeasure, kind: str) -> list[Anchor]:
    """Return the anchors of one kind, in their order."""
    return [anchor for anchor in measure.anchors if anchor.kind == kind]


def tops_of(measure: AssetMeasure) -> list[Top]:
    """Return where things can stand on an asset; the top of its box if it declares nothing."""
    tops = [
        Top(Surface(*anchor.location, *anchor.size), anchor.clearance)
        for anchor in measure.anchors
        if anchor.kind == "top" and min(anchor.size) > 0
    ]
    width, depth, height = measure.dimensions
    return tops or [Top(Surface(0.0, 0.0, height, width, depth))]


def size_of(measure: AssetMeasure) -> tuple[float, float, float]:
    """Return width, depth and height of the room a thing takes; people have their arms down."""
    width, depth, height = measure.dimensions
    if measure.asset_type == "character" and height > 1.05 * max(width, depth):
        return min(width, PERSON[0]), min(depth, PERSON[1]), height
    return width, depth, height


def thing_of(item: LayoutObject, measures: Mapping[str, AssetMeasure], plan: SetPlan) -> Thing | None:
    """Return a laid-out object as the solver sees it, or None where nothing is known of its shape."""
    measure = measures.get(item.asset_id)
    if measure is None:
        return None
    x, y, z = item.location
    yaw = math.radians(item.rotation[2])
    is_person = measure.asset_type == "character"
    if is_person and seated(item):
        width, depth, height = _TRUNK
        box = Box(x - math.sin(yaw) * _SEATED_BEHIND, y + math.cos(yaw) * _SEATED_BEHIND, z, width, depth, height, yaw)
    else:
        box = Box(x, y, z, *_lying_aside(size_of(measure), item.rotation), yaw)
    thing = Thing(
        item.node_id, box, item.anchor_asset_id, item.relationship, item.contact, item.direction,
        mass=1.0 if is_person else _mass(measure), fixed=item.fixed, walks=is_person,
    )  # fmt: skip
    thing.floats = item.fixed or (z > _FLAT and hangs(box, plan))
    return thing


def seated(item: LayoutObject) -> bool:
    """Return whether a person is laid out on a seat or a bed."""
    return item.anchor_asset_id is not None and item.relationship is None and item.direction is None


def _lying_aside(size: tuple[float, float, float], rotation: Sequence[float]) -> tuple[float, float, float]:
    """Return the extent of a thing that lies on its side or back; yaw is left to the box."""
    rx, ry = math.radians(rotation[0]), math.radians(rotation[1])
    turn_x = np.array([[1, 0, 0], [0, math.cos(rx), -math.sin(rx)], [0, math.sin(rx), math.cos(rx)]])
    turn_y = np.array([[math.cos(ry), 0, math.sin(ry)], [0, 1, 0], [-math.sin(ry), 0, math.cos(ry)]])
    width, depth, height = np.abs(turn_y @ turn_x) @ np.asarray(size)
    return float(width), float(depth), float(height)


def _mass(measure: AssetMeasure) -> float:
    width, depth, height = measure.dimensions
    return min(max(6.0 * width * depth * max(height, 0.3), 0.3), 8.0)


def hangs(box: Box, plan: SetPlan) -> bool:
    """Return whether a thing touches a wall or a ceiling."""
    ceilings = [slab.z for slab in plan.slabs if slab.role == "ceiling"]
    if any(abs(height - box.top) < 2 * _HUNG for height in ceilings):
        return True
    return any(footprint_gap(box, wall.box)[0] < _HUNG for wall in walls_of(plan))


def walls_of(plan: SetPlan) -> list[Thing]:
    """Return walls and solid parts of the set as fixed boxes."""
    solid = [(part.node_id, wall_boxes(part)) for part in plan.walls]
    solid += [(part.node_id, piece_boxes(part)) for part in plan.pieces]
    return [
        Thing(f"{node_id}_{index}", box, fixed=True, floats=True)
        for node_id, boxes in solid
        for index, box in enumerate(boxes)
    ]


def laid_out(thing: Thing, asset_id: str) -> LayoutObject:
    """Return a solved thing as the graph stores it: a millimetre and a tenth of a degree are enough."""
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
    """Return the trunk of somebody who sits with the seat's front edge at (x, y, z), facing ``yaw`` radians."""
    return Box(x - math.sin(yaw) * _SEATED_BEHIND, y + math.cos(yaw) * _SEATED_BEHIND, z, *_TRUNK, yaw)


def with_surfaces(things: Sequence[Thing], assets: Mapping[str, str], measures: Mapping[str, AssetMeasure]) -> None:
    """Find, for everything that stands on something, the surface nearest below it."""
    by_name = {thing.name: thing for thing in things}
    for thing in things:
        anchor = by_name.get(thing.anchor or "")
        if thing.relationship != "on_top_of" or anchor is None:
            continue
        lift = thing.box.z - anchor.box.z
        tops = tops_of(measures[assets[anchor.name]])
        thing.surface = min((top.surface for top in tops), key=lambda surface: abs(surface.z - lift))


def layout_violations(layout: Layout, measures: Mapping[str, AssetMeasure], plan: SetPlan) -> tuple[Fault, ...]:
    """Return everything that is geometrically wrong with a layout, each with its exact fix; empty means V = 1.

    Args:
        layout: To check.
        measures: By asset id; what has none is not checked.
        plan: The set, for its walls and solid parts.
    """
    things = [thing for item in layout.objects if (thing := thing_of(item, measures, plan)) is not None]
    with_surfaces(things, {item.node_id: item.asset_id for item in layout.objects}, measures)
    everything = [*things, *walls_of(plan)]
    room = room_of(layout.scene_size)
    return tuple(fault_of(violation, everything, room) for violation in violations(everything, room))


def fault_of(violation: Violation, things: Sequence[Thing], room: Room) -> Fault:
    """Return a violation as a fault: the sentence and the numbers that mend it."""
    fix = {name: round(value, 3) for name, value in remedy(violation, things, room).items()}
    amount = violation.amount
    angular = violation.kind in ("direction", "relationship")
    size = f"{math.degrees(amount):.0f} degrees" if angular else f"{amount:.2f} m"
    towards = f" and {violation.other}" if violation.other else ""
    mend = ", ".join(f"{name} {value:+.2f}" for name, value in fix.items()) or "none known"
    return Fault(
        kind=violation.kind,
        subject=violation.subject,
        severity=_SEVERITY,
        message=f"{violation.kind} of {violation.subject}{towards}: {size} too much; fix: {mend}",
        fix=dict(fix),
    )
