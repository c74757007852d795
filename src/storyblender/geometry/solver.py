"""The layout solver: projected Gauss-Seidel over relations, contacts and collisions, with relocation and restarts.

Each pass visits the things from anchors to what hangs on them and projects every constraint in turn: height,
bearing, contact, direction, then pairs apart, off the lanes and into the room. Whatever stands on a thing moves with
it. A thing pushed back by a wall drags its anchors along, which is what frees crowded corners. Where passes stall, the
worst thing is set down at the cheapest of many sampled places. Measured in ``benchmarks/layout_solver.py``.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from storyblender.geometry.boxes import Axis, Box, footprint_gap, penetration, wrap_angle
from storyblender.geometry.relations import (
    BEARING,
    BEARING_TOLERANCE,
    CONTACT_DISTANCE,
    DIRECTION_TOLERANCE,
    PENETRATION_TOLERANCE,
    LayoutThing,
    PlayingArea,
    Violation,
    bearing_error,
    cannot_move,
    carrier,
    carriers,
    clamp_into_room,
    exempt_pairs,
    may_overlap_anchor,
    own_violations,
    shift_onto_surface,
    slide_to_gap,
    surface_of,
    violations,
    wanted_yaw,
)

_PATIENCE = 12
"""Passes before a thing is relocated."""
_SAMPLES = 60
"""Places tried for a relocated thing."""
_SLACK = 0.005
"""Metres that a pair is pushed apart beyond touching, so that it does not creep back."""


@dataclass(frozen=True)
class Solution:
    """Result of the solver.

    Attributes:
        things: In the order given.
        residual: Constraints still broken; empty if solved.
        passes: Gauss-Seidel passes over all restarts.
        relocations: Things set down elsewhere.
    """

    things: tuple[LayoutThing, ...]
    residual: tuple[Violation, ...]
    passes: int
    relocations: int

    @property
    def solved(self) -> bool:
        """True if every constraint holds."""
        return not self.residual


def solve(
    things: Sequence[LayoutThing],
    room: PlayingArea,
    *,
    keep_free: Sequence[Box] = (),
    seed: int = 0,
    restarts: int = 3,
    passes: int = 120,
    mending: bool = False,
) -> Solution:
    """Move and turn things until every constraint holds; the same input and seed give the same layout.

    Args:
        things: Things at their wished places; they are not changed.
        room: The playing area.
        keep_free: Volumes that things stay out of (lanes, door swings).
        seed: Seed of the random draws of relocation and restarts.
        restarts: Fresh starts from the wished places, roots drawn towards the middle.
        passes: Limit of each start; the first gives up at half of it.
        mending: Start from a draft with errors, not from wishes: what is carried keeps its place on what carries it,
            and fresh starts draw things that are placed by each other towards the middle as well.
    """
    rng = np.random.default_rng(seed)
    best: list[LayoutThing] | None = None
    least: list[Violation] = []
    total = moved = 0
    for start in range(restarts):
        current = [thing.copy() for thing in things]
        relaxation = _Relaxation(current, room, keep_free, rng, mending)
        if start:
            relaxation.draw_to_middle()
        residual = relaxation.run(passes if start else passes // 2)
        total += relaxation.passes
        moved += relaxation.relocations
        if best is None or len(residual) < len(least):
            best, least = current, residual
        if not least:
            break
    assert best is not None, "restarts is at least 1"
    return Solution(tuple(best), tuple(least), total, moved)


def _in_ring(thing: LayoutThing, by_name: Mapping[str, LayoutThing]) -> bool:
    """Return whether a thing is its anchor's anchor, or the anchor of that one, and so on."""
    seen: set[str] = set()
    anchor = thing.anchor
    while anchor is not None and anchor in by_name and anchor not in seen:
        if anchor == thing.name:
            return True
        seen.add(anchor)
        anchor = by_name[anchor].anchor
    return False


_OUTWARD_AXIS: dict[str, Axis] = {name: (math.cos(angle), math.sin(angle)) for name, angle in BEARING.items()}
"""Unit vector from an anchor to what has that relationship to it."""


class _Relaxation:
    """One start of the solver; changes the things it is given."""

    def __init__(
        self,
        things: list[LayoutThing],
        room: PlayingArea,
        keep_free: Sequence[Box],
        rng: np.random.Generator,
        mending: bool,
    ) -> None:
        self.things, self.room, self.keep_free, self.rng, self.mending = things, room, keep_free, rng, mending
        self.by_name = {thing.name: thing for thing in things}
        chains = {thing.name: carriers(thing, self.by_name) for thing in things}
        self.riders: dict[str, list[LayoutThing]] = {thing.name: [] for thing in things}
        for thing in things:
            for support in chains[thing.name]:
                self.riders[support.name].append(thing)
        self.exempt = exempt_pairs(things, self.by_name)
        self.pairs = [
            (thing, other)
            for index, thing in enumerate(things)
            for other in things[:index]
            if not (thing.fixed and other.fixed) and (thing.name, other.name) not in self.exempt
        ]
        self.order = sorted(
            (thing for thing in things if not thing.fixed),
            key=lambda thing: (thing.relationship == "on_top_of", self._depth(thing)),
        )
        self.passes = self.relocations = 0

    def _depth(self, thing: LayoutThing) -> int:
        """Return how many anchors are above a thing; a ring of anchors counts once."""
        seen = {thing.name}
        while thing.anchor in self.by_name and thing.anchor not in seen:
            seen.add(thing.anchor)
            thing = self.by_name[thing.anchor]
        return len(seen) - 1

    def draw_to_middle(self) -> None:
        """Bring the things that have no anchor towards the middle of the room, with some scatter."""
        room = self.room
        middle_x, middle_y = (room.x_min + room.x_max) / 2, (room.y_min + room.y_max) / 2
        for thing in self.things:
            if thing.fixed or not (thing.anchor is None or (self.mending and _in_ring(thing, self.by_name))):
                continue
            dx, dy = self.rng.normal(0.0, 0.5, 2)
            x = middle_x + 0.4 * (thing.box.x - middle_x) + float(dx)
            y = middle_y + 0.4 * (thing.box.y - middle_y) + float(dy)
            if self.mending:
                self._move(thing, x - thing.box.x, y - thing.box.y)
            else:
                thing.box.x, thing.box.y = x, y

    def run(self, limit: int) -> list[Violation]:
        residual = violations(self.things, self.room, self.keep_free)
        while residual and self.passes < limit:
            self.passes += 1
            for thing in self.order:
                self._settle(thing)
                self._keep_bearing(thing)
                self._keep_direction(thing)
            for thing, other in self.pairs:
                self._separate(thing, other)
            for thing in self.order:
                self._keep_off_lanes(thing)
                self._keep_inside(thing)
            residual = violations(self.things, self.room, self.keep_free)
            if residual and self.passes >= _PATIENCE and self.passes % 4 == 0:
                self._relocate(residual)
        return residual

    def _move(self, thing: LayoutThing, dx: float, dy: float) -> None:
        if thing.fixed:
            return
        thing.box.x += dx
        thing.box.y += dy
        for rider in self.riders[thing.name]:
            rider.box.x += dx
            rider.box.y += dy

    def _turn(self, thing: LayoutThing, yaw: float) -> None:
        by = wrap_angle(yaw - thing.box.yaw)
        thing.box.turn_to(yaw)
        c, s = math.cos(by), math.sin(by)
        for rider in self.riders[thing.name]:
            dx, dy = rider.box.x - thing.box.x, rider.box.y - thing.box.y
            rider.box.x, rider.box.y = thing.box.x + c * dx - s * dy, thing.box.y + s * dx + c * dy
            rider.box.turn_to(rider.box.yaw + by)

    def _anchor(self, thing: LayoutThing) -> LayoutThing | None:
        return self.by_name.get(thing.anchor) if thing.anchor is not None else None

    def _settle(self, thing: LayoutThing) -> None:
        """Put a thing on the floor or on its support."""
        anchor = self._anchor(thing)
        if anchor is not None and thing.relationship == "on_top_of":
            thing.box.z = anchor.box.z + surface_of(thing, anchor).z
            self._move(thing, *shift_onto_surface(thing, anchor))
        elif not (thing.floats or may_overlap_anchor(thing)):
            thing.box.z = 0.0

    def _keep_bearing(self, thing: LayoutThing) -> None:
        """Turn the bearing to the nearest edge of its sector, then slide along it to touch or to clear."""
        anchor = self._anchor(thing)
        if anchor is None or thing.relationship not in BEARING:
            return
        box, base = thing.box, anchor.box
        error = bearing_error(box, base, thing.relationship)
        edge = BEARING_TOLERANCE - math.radians(3)
        if abs(error) > edge:
            apart = max(math.hypot(box.x - base.x, box.y - base.y), CONTACT_DISTANCE)
            angle = BEARING[thing.relationship] + math.copysign(edge, error)
            self._move(thing, base.x + apart * math.cos(angle) - box.x, base.y + apart * math.sin(angle) - box.y)
        if thing.contact is None:
            return
        gap = footprint_gap(box, base)[0]
        if thing.contact and -PENETRATION_TOLERANCE / 2 <= gap <= 0.6 * CONTACT_DISTANCE:
            return
        if not thing.contact and gap >= CONTACT_DISTANCE + 0.02:
            return
        x, y = slide_to_gap(box, base, 0.01 if thing.contact else CONTACT_DISTANCE + 0.06, BEARING[thing.relationship])
        self._move(thing, x - box.x, y - box.y)

    def _keep_direction(self, thing: LayoutThing) -> None:
        """Turn to the nearest admissible yaw, not to the ideal one: it disturbs the rest least."""
        anchor = self._anchor(thing)
        if anchor is None or thing.direction is None:
            return
        if math.hypot(thing.box.x - anchor.box.x, thing.box.y - anchor.box.y) < 1e-3:
            return
        ideal = wanted_yaw(thing.box, anchor.box, thing.direction)
        error = wrap_angle(thing.box.yaw - ideal)
        if abs(error) > DIRECTION_TOLERANCE - math.radians(5):
            self._turn(thing, ideal + math.copysign(DIRECTION_TOLERANCE - math.radians(10), error))

    def _separate(self, a: LayoutThing, b: LayoutThing) -> None:
        """Push two things apart, the lighter one more; related ones along their relation so that it holds."""
        depth, axis = penetration(a.box, b.box, PENETRATION_TOLERANCE)
        if depth <= PENETRATION_TOLERANCE / 2:
            return
        depth, axis = _along_relation(a, b, depth, axis)
        share_a = 0.0 if a.fixed else (4.0 if a.anchor == b.name else 1.0) / a.mass
        share_b = 0.0 if b.fixed else (4.0 if b.anchor == a.name else 1.0) / b.mass
        depth = (depth + _SLACK) / (share_a + share_b)
        self._move(a, axis[0] * depth * share_a, axis[1] * depth * share_a)
        self._move(b, -axis[0] * depth * share_b, -axis[1] * depth * share_b)

    def _keep_off_lanes(self, thing: LayoutThing) -> None:
        if thing.walks:
            return
        for lane in self.keep_free:
            depth, axis = penetration(thing.box, lane, PENETRATION_TOLERANCE)
            if depth > PENETRATION_TOLERANCE / 2:
                self._move(thing, axis[0] * (depth + _SLACK), axis[1] * (depth + _SLACK))

    def _keep_inside(self, thing: LayoutThing) -> None:
        """Bring a thing back into the room and drag its anchors off the wall to make room for it."""
        if thing.relationship == "on_top_of" or cannot_move(thing, self.by_name):
            return
        x, y = clamp_into_room(thing.box, self.room)
        dx, dy = x - thing.box.x, y - thing.box.y
        if dx == 0.0 and dy == 0.0:
            return
        self._move(thing, dx, dy)
        pull, seen = 0.7, {thing.name}
        while thing.relationship in BEARING and thing.anchor in self.by_name and thing.anchor not in seen:
            thing = self.by_name[thing.anchor]
            if self.mending and carrier(thing, self.by_name) is not None:
                return
            seen.add(thing.name)
            self._move(thing, dx * pull, dy * pull)
            pull *= 0.8

    def _relocate(self, residual: list[Violation]) -> None:
        """Set the worst thing, or now and then its anchor, down at the cheapest of many sampled places."""
        thing = self._worst(residual)
        if thing is None:
            return
        draws = self.rng.uniform(size=(_SAMPLES, 3)).tolist()
        start = (thing.box.x, thing.box.y, thing.box.yaw)
        best, place = self._cost(thing), start
        for u, v, w in draws:
            x, y = self._sample(thing, u, v)
            self._move(thing, x - thing.box.x, y - thing.box.y)
            anchor = self._anchor(thing)
            if anchor is not None and thing.direction is not None:
                ideal = wanted_yaw(thing.box, anchor.box, thing.direction)
                self._turn(thing, ideal + math.radians(70) * (w - 0.5))
            cost = self._cost(thing) + 0.05 * math.hypot(x - start[0], y - start[1])
            if cost < best:
                best, place = cost, (x, y, thing.box.yaw)
        self._move(thing, place[0] - thing.box.x, place[1] - thing.box.y)
        self._turn(thing, place[2])
        self.relocations += 1

    def _worst(self, residual: list[Violation]) -> LayoutThing | None:
        blame: Counter[str] = Counter()
        for violation in residual:
            blame[violation.subject] += 1
            if violation.kind == "penetration" and violation.other is not None:
                blame[violation.other] += 1
        movable = [name for name in blame if not self.by_name[name].fixed]
        if not movable:
            return None
        luck = dict(zip(movable, self.rng.uniform(0.5, 1.5, len(movable)), strict=True))
        worst = self.by_name[max(movable, key=lambda name: blame[name] * luck[name] / self.by_name[name].mass)]
        anchor = self._anchor(worst)
        swap = anchor is not None and not anchor.fixed and worst.relationship != "on_top_of"
        return anchor if swap and self.rng.uniform() < 0.35 else worst

    def _sample(self, thing: LayoutThing, u: float, v: float) -> tuple[float, float]:
        """Return a place that suits the thing's relation, from two draws in 0..1."""
        anchor = self._anchor(thing)
        if anchor is not None and thing.relationship == "on_top_of":
            surface = surface_of(thing, anchor)
            free_x = max(surface.width - thing.box.width, 0.0)
            free_y = max(surface.depth - thing.box.depth, 0.0)
            return anchor.box.to_world(surface.x + (u - 0.5) * free_x, surface.y + (v - 0.5) * free_y)
        if anchor is not None and thing.relationship in BEARING:
            angle = BEARING[thing.relationship] + math.radians(80) * (u - 0.5)
            touching = (thing.box.radius + anchor.box.radius) * (0.6 + 0.4 * v)
            apart = touching if thing.contact else 0.8 + 3.2 * v
            return anchor.box.x + apart * math.cos(angle), anchor.box.y + apart * math.sin(angle)
        width, depth = self.room.x_max - self.room.x_min, self.room.y_max - self.room.y_min
        return self.room.x_min + u * width, self.room.y_min + v * depth

    def _cost(self, thing: LayoutThing) -> float:
        """Return how much is wrong with a thing and what it carries or anchors, where they are now."""
        group = [thing, *self.riders[thing.name]]
        inside = {member.name for member in group}
        judged = group + [other for other in self.things if other.anchor in inside and other.name not in inside]
        cost = 0.0
        for member in judged:
            for violation in own_violations(member, self.by_name, self.room):
                angular = violation.kind in ("direction", "relationship")
                cost += 2 * violation.amount if angular else min(violation.amount, 50.0)
        for member in group:
            for other in self.things:
                if other.name not in inside and (member.name, other.name) not in self.exempt:
                    cost += penetration(member.box, other.box, PENETRATION_TOLERANCE)[0]
            if not member.walks:
                cost += sum(penetration(member.box, lane, PENETRATION_TOLERANCE)[0] for lane in self.keep_free)
        return cost


def _along_relation(a: LayoutThing, b: LayoutThing, depth: float, axis: Axis) -> tuple[float, Axis]:
    """Return the push of ``a`` out of ``b``: along their relation if one of them is placed beside the other."""
    for child, anchor, sign in ((a, b, 1.0), (b, a, -1.0)):
        if child.anchor == anchor.name and child.relationship in _OUTWARD_AXIS:
            out = _OUTWARD_AXIS[child.relationship]
            along = (child.box.x - anchor.box.x) * out[0] + (child.box.y - anchor.box.y) * out[1]
            missing = child.box.reach(out) + anchor.box.reach(out) - along
            if missing > 0:
                return missing, (out[0] * sign, out[1] * sign)
    return depth, axis
