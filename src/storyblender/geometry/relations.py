"""The paper's spatial constraints: relationship, direction, contact, and what every room demands of its things.

``violations`` says what is wrong and by how much; ``remedy`` gives the exact move that mends it.
Tolerances are the paper's (appendix, Spatial Planner); signs are the conventions of ``docs/architecture.md``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from storyblender.geometry.boxes import Box, footprint_gap, penetration, vertical_gap, wrap_angle, yaw_along

PENETRATION_TOLERANCE = 0.02
"""Metres that two boxes may share."""
CONTACT_DISTANCE = 0.05
"""Metres within which two things touch."""
DIRECTION_TOLERANCE = math.radians(45)
"""Radians that a yaw may deviate from a direction, either way."""
BEARING_TOLERANCE = math.radians(45)
"""Radians that a bearing may deviate from a relationship, either way."""

BEARING: dict[str, float] = {
    "on_the_right_of": 0.0,
    "behind": math.pi / 2,
    "on_the_left_of": math.pi,
    "in_front_of": -math.pi / 2,
}
"""Bearing of a thing from its anchor in the world, radians counter-clockwise from +X."""
DIRECTION_TURN: dict[str, float] = {
    "facing": 0.0,
    "facing_away": math.pi,
    "left_side_facing": -math.pi / 2,
    "right_side_facing": math.pi / 2,
}
"""Radians added to the yaw that faces the anchor. A thing's own left is at +90 degrees of its front."""

Kind = Literal[
    "direction",
    "relationship",
    "contact",
    "no_contact",
    "support",
    "overhang",
    "floor",
    "bounds",
    "penetration",
    "lane",
]


class PlayingArea(NamedTuple):
    """The playing area, metres."""

    x_min: float
    x_max: float
    y_min: float
    y_max: float


class StandingSurface(NamedTuple):
    """A rectangle on an anchor where things may stand: centre, height and extent in the anchor's own frame, metres."""

    x: float
    y: float
    z: float
    width: float
    depth: float


@dataclass(slots=True)
class LayoutThing:
    """One thing of a layout and what is asked of it.

    Attributes:
        name: Its node_id.
        box: Its box in the world.
        anchor: Name of the thing it relates to. An anchor with neither relationship nor direction lets the two
            overlap: the thing is under it, in it or seated on it, and is carried along.
        relationship: One of the paper's five, seen from -Y.
        contact: True must touch, False must not, None is free.
        direction: A key of ``DIRECTION_TURN``: the side of the thing that looks to the anchor.
        surface: For ``on_top_of``: where on the anchor it stands; None takes the top of the anchor's box.
        mass: Resistance to being pushed, relative to 1.
        fixed: Never moves.
        walks: A person: lanes are kept free for them, not from them.
        floats: Its height is meant (on a wall, from the ceiling): no floor check.
    """

    name: str
    box: Box
    anchor: str | None = None
    relationship: str | None = None
    contact: bool | None = None
    direction: str | None = None
    surface: StandingSurface | None = None
    mass: float = 1.0
    fixed: bool = False
    walks: bool = False
    floats: bool = False

    def copy(self) -> LayoutThing:
        """Return an independent thing."""
        return LayoutThing(
            self.name, self.box.copy(), self.anchor, self.relationship, self.contact, self.direction,
            self.surface, self.mass, self.fixed, self.walks, self.floats,
        )  # fmt: skip


class Violation(NamedTuple):
    """One broken constraint."""

    kind: Kind
    subject: str
    other: str | None
    amount: float
    """By how much: metres, or radians for direction and relationship."""
    error: float
    """Signed deviation from the ideal, same unit."""


def may_overlap_anchor(thing: LayoutThing) -> bool:
    """Return whether a thing is in, under or seated on its anchor, so that their boxes may overlap."""
    return thing.anchor is not None and thing.relationship is None and thing.direction is None


def surface_of(thing: LayoutThing, anchor: LayoutThing) -> StandingSurface:
    """Return the surface of the anchor on which the thing stands, in the anchor's frame."""
    if thing.surface is not None:
        return thing.surface
    return StandingSurface(0.0, 0.0, anchor.box.height, anchor.box.width, anchor.box.depth)


def carrier(thing: LayoutThing, by_name: Mapping[str, LayoutThing]) -> LayoutThing | None:
    """Return the thing that moves this one along with it: its support or its seat; None without one.

    Args:
        thing: Thing that is carried.
        by_name: The layout's things by node_id.
    """
    if thing.anchor is not None and (thing.relationship == "on_top_of" or may_overlap_anchor(thing)):
        return by_name.get(thing.anchor)
    return None


def carriers(thing: LayoutThing, by_name: Mapping[str, LayoutThing]) -> list[LayoutThing]:
    """Return the chain of carriers, nearest first.

    Args:
        thing: Thing that is carried.
        by_name: The layout's things by node_id.
    """
    chain: list[LayoutThing] = []
    current = carrier(thing, by_name)
    while current is not None and current is not thing and current not in chain:
        chain.append(current)
        current = carrier(current, by_name)
    return chain


def cannot_move(thing: LayoutThing, by_name: Mapping[str, LayoutThing]) -> bool:
    """Return whether a thing is fixed or carried by a fixed thing, such as a person seated in a moored boat.

    Args:
        thing: Thing to move.
        by_name: The layout's things by node_id.
    """
    return thing.fixed or any(support.fixed for support in carriers(thing, by_name))


def exempt_pairs(things: Iterable[LayoutThing], by_name: Mapping[str, LayoutThing]) -> set[tuple[str, str]]:
    """Return the ordered name pairs that may overlap: each of ``things`` with its direct and indirect carriers.

    Args:
        things: Things to pair with their carriers.
        by_name: The layout's things by node_id.
    """
    pairs: set[tuple[str, str]] = set()
    for thing in things:
        for support in carriers(thing, by_name):
            pairs.add((thing.name, support.name))
            pairs.add((support.name, thing.name))
    return pairs


def bearing_error(thing: Box, anchor: Box, relationship: str) -> float:
    """Return the deviation of a bearing from the middle of its sector, radians, counter-clockwise positive.

    Args:
        thing: Box in the world.
        anchor: Box of its anchor, in the world.
        relationship: A key of ``BEARING``.
    """
    return wrap_angle(math.atan2(thing.y - anchor.y, thing.x - anchor.x) - BEARING[relationship])


def wanted_yaw(thing: Box, anchor: Box, direction: str) -> float:
    """Return the yaw in radians (0 faces -Y, not wrapped) that satisfies a direction exactly.

    Args:
        thing: Box in the world, whose yaw does not count.
        anchor: Box of its anchor, in the world.
        direction: A key of ``DIRECTION_TURN``.
    """
    return yaw_along(anchor.x - thing.x, anchor.y - thing.y) + DIRECTION_TURN[direction]


def distance_outside(box: Box, room: PlayingArea) -> float:
    """Return the largest distance in metres by which a box sticks out of the room; 0 inside."""
    rx, ry = box.reach((1.0, 0.0)), box.reach((0.0, 1.0))
    return max(room.x_min - box.x + rx, box.x + rx - room.x_max, room.y_min - box.y + ry, box.y + ry - room.y_max, 0.0)


def overhang_distance(thing: LayoutThing, anchor: LayoutThing) -> float:
    """Return the metres from the surface's edge to the centre of a thing on it; negative if the centre is on it."""
    surface = surface_of(thing, anchor)
    u, v = anchor.box.to_local(thing.box.x, thing.box.y)
    return max(abs(u - surface.x) - surface.width / 2, abs(v - surface.y) - surface.depth / 2)


def own_violations(thing: LayoutThing, by_name: Mapping[str, LayoutThing], room: PlayingArea) -> list[Violation]:
    """Return what is wrong with one thing by itself and towards its anchor.

    Args:
        thing: Thing to check.
        by_name: The layout's things by node_id; an anchor that is not among them is not checked.
        room: The playing area, metres.
    """
    found: list[Violation] = []
    anchor = by_name.get(thing.anchor) if thing.anchor is not None else None
    if anchor is not None:
        found += _anchor_violations(thing, anchor)
    lifted = thing.relationship == "on_top_of" or thing.floats or may_overlap_anchor(thing)
    if not lifted and abs(thing.box.z) > CONTACT_DISTANCE:
        found.append(Violation("floor", thing.name, None, abs(thing.box.z), thing.box.z))
    if not cannot_move(thing, by_name) and (amount := distance_outside(thing.box, room)) > PENETRATION_TOLERANCE:
        found.append(Violation("bounds", thing.name, None, amount, amount))
    return found


def _anchor_violations(thing: LayoutThing, anchor: LayoutThing) -> list[Violation]:
    found: list[Violation] = []
    box, base = thing.box, anchor.box
    apart = math.hypot(box.x - base.x, box.y - base.y)
    if thing.direction is not None and apart > 1e-3:
        error = wrap_angle(box.yaw - wanted_yaw(box, base, thing.direction))
        if abs(error) > DIRECTION_TOLERANCE:
            found.append(Violation("direction", thing.name, anchor.name, abs(error) - DIRECTION_TOLERANCE, error))
    if thing.relationship in BEARING:
        error = bearing_error(box, base, thing.relationship)
        if abs(error) > BEARING_TOLERANCE:
            found.append(Violation("relationship", thing.name, anchor.name, abs(error) - BEARING_TOLERANCE, error))
        if thing.contact is not None:
            gap, rise = footprint_gap(box, base)[0], vertical_gap(box, base)
            if thing.contact and (gap > CONTACT_DISTANCE or rise > CONTACT_DISTANCE):
                found.append(Violation("contact", thing.name, anchor.name, max(gap, rise), gap))
            if not thing.contact and gap <= CONTACT_DISTANCE and rise < 0:
                found.append(Violation("no_contact", thing.name, anchor.name, CONTACT_DISTANCE - gap, gap))
    elif thing.relationship == "on_top_of":
        lift = box.z - base.z - surface_of(thing, anchor).z
        if lift > CONTACT_DISTANCE - 1e-9 or lift < -PENETRATION_TOLERANCE:
            found.append(Violation("support", thing.name, anchor.name, abs(lift), lift))
        if (beyond := overhang_distance(thing, anchor)) > 1e-6:
            found.append(Violation("overhang", thing.name, anchor.name, beyond, beyond))
    return found


def violations(things: Sequence[LayoutThing], room: PlayingArea, keep_free: Sequence[Box] = ()) -> list[Violation]:
    """Return every broken constraint of a layout; empty means valid (the paper's V = 1).

    Args:
        things: All of them; pairs of which both are fixed are not compared.
        room: The playing area.
        keep_free: Volumes of air that things, not people, stay out of: lanes and door swings.
    """
    by_name = {thing.name: thing for thing in things}
    exempt = exempt_pairs(things, by_name)
    found: list[Violation] = []
    for index, thing in enumerate(things):
        found += own_violations(thing, by_name, room)
        for other in things[:index]:
            if (thing.fixed and other.fixed) or (thing.name, other.name) in exempt:
                continue
            depth = penetration(thing.box, other.box, PENETRATION_TOLERANCE)[0]
            if depth > PENETRATION_TOLERANCE:
                found.append(Violation("penetration", thing.name, other.name, depth, depth))
        if thing.fixed or thing.walks:
            continue
        for lane in keep_free:
            depth = penetration(thing.box, lane, PENETRATION_TOLERANCE)[0]
            if depth > PENETRATION_TOLERANCE:
                found.append(Violation("lane", thing.name, None, depth, depth))
    return found


def remedy(
    violation: Violation, things: Sequence[LayoutThing], room: PlayingArea, keep_free: Sequence[Box] = ()
) -> dict[str, float]:
    """Return the exact move of the subject that mends a violation: ``move_x/y/z`` in metres, ``turn`` in degrees.

    The move mends this one constraint; the solver is what mends all of them together.

    Args:
        violation: One of ``violations``, for the same things.
        things: All things of the layout.
        room: The playing area, metres.
        keep_free: Volumes of air to leave, as for ``violations``.
    """
    by_name = {thing.name: thing for thing in things}
    thing = by_name[violation.subject]
    box = thing.box
    if violation.kind == "lane":
        return max(
            (_move_out(box, lane) for lane in keep_free), key=lambda move: math.hypot(*move.values()), default={}
        )
    if violation.kind == "bounds":
        return _shift(clamp_into_room(box, room)[0] - box.x, clamp_into_room(box, room)[1] - box.y)
    if violation.kind == "floor":
        return {"move_z": -box.z}
    if violation.other is None:
        return {}
    anchor = by_name[violation.other]
    if violation.kind == "penetration":
        return _move_out(box, anchor.box)
    if violation.kind == "direction":
        return {"turn": -math.degrees(violation.error)}
    if violation.kind == "support":
        return {"move_z": -violation.error}
    if violation.kind == "overhang":
        return _shift(*shift_onto_surface(thing, anchor))
    return _bearing_remedy(thing, anchor, violation)


def _bearing_remedy(thing: LayoutThing, anchor: LayoutThing, violation: Violation) -> dict[str, float]:
    box, base = thing.box, anchor.box
    if violation.kind == "relationship":
        apart = math.hypot(box.x - base.x, box.y - base.y)
        angle = BEARING[thing.relationship or ""]
        return _shift(base.x + apart * math.cos(angle) - box.x, base.y + apart * math.sin(angle) - box.y)
    x, y = slide_to_gap(
        box, base, 0.01 if violation.kind == "contact" else CONTACT_DISTANCE + 0.05, BEARING[thing.relationship or ""]
    )
    return _shift(x - box.x, y - box.y)


def _shift(dx: float, dy: float) -> dict[str, float]:
    return {"move_x": dx, "move_y": dy}


def _move_out(box: Box, other: Box) -> dict[str, float]:
    depth, axis = penetration(box, other)
    return _shift(axis[0] * depth, axis[1] * depth)


def clamp_into_room(box: Box, room: PlayingArea) -> tuple[float, float]:
    """Return the nearest centre (world x and y) of a box inside the room; the middle where it is too big."""
    rx, ry = box.reach((1.0, 0.0)), box.reach((0.0, 1.0))
    return _clamp(box.x, room.x_min + rx, room.x_max - rx), _clamp(box.y, room.y_min + ry, room.y_max - ry)


def _clamp(value: float, low: float, high: float) -> float:
    return (low + high) / 2 if low > high else min(max(value, low), high)


def shift_onto_surface(thing: LayoutThing, anchor: LayoutThing) -> tuple[float, float]:
    """Return the world shift (dx, dy; metres) of a footprint onto its surface, or of its centre if it is too big."""
    surface, box, base = surface_of(thing, anchor), thing.box, anchor.box
    u, v = base.to_local(box.x, box.y)
    turn = box.yaw - base.yaw
    c, s = abs(math.cos(turn)), abs(math.sin(turn))
    room_u = max((surface.width - box.width * c - box.depth * s) / 2, 0.0)
    room_v = max((surface.depth - box.width * s - box.depth * c) / 2, 0.0)
    du = _clamp(u, surface.x - room_u, surface.x + room_u) - u
    dv = _clamp(v, surface.y - room_v, surface.y + room_v) - v
    return base.cos * du - base.sin * dv, base.sin * du + base.cos * dv


def slide_to_gap(box: Box, base: Box, gap: float, bearing: float) -> tuple[float, float]:
    """Return the centre (world x and y) at which the gap of a box to its anchor is ``gap`` metres.

    It is on the ray from the anchor through the box; ``bearing`` (radians from +X) serves where both are one point.
    """
    dx, dy = box.x - base.x, box.y - base.y
    apart = math.hypot(dx, dy)
    ux, uy = (dx / apart, dy / apart) if apart > 1e-3 else (math.cos(bearing), math.sin(bearing))
    probe = box.copy()
    near, far = 0.0, 2 * (box.radius + base.radius) + gap
    for _ in range(20):
        middle = (near + far) / 2
        probe.x, probe.y = base.x + ux * middle, base.y + uy * middle
        if footprint_gap(probe, base)[0] < gap:
            near = middle
        else:
            far = middle
    return base.x + ux * far, base.y + uy * far
