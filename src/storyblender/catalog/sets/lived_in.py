"""Fills bare walls, corners and table tops of a room with everyday belongings.

A kit draws the essentials of a place; this pass adds what makes it look used, by the sort of room. All of it is
dressing, which crowded scenes drop; props of the script do not replace the small things it lays on tops.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from storyblender.catalog.footprints import piece_boxes, stage_box
from storyblender.catalog.props import PROPS
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import Furnishing, Piece, SetPlan, Wall
from storyblender.catalog.sets.belongings import HUNG, ONE, ROOMS, STANDING, SURFACES, Belongings, Hanging
from storyblender.catalog.sets.drawing import Period
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.base import Vec2

_EVERY = 1.5
"""Metres of bare wall that one thing fills."""
_MARGIN = 0.14
"""Metres between things on a wall."""
_SPARE = 0.1
"""Metres around the square in the middle that stay free too."""
_WAY = 0.55
"""Metres that stay free before doors and marks, to each side and into the room."""
_NEAR = 0.45
"""Metres from a wall up to which a thing covers it."""
_FULL = 3
"""At most this many pieces of furniture are added along one wall."""


def lived_in(plan: SetPlan, room: str, period: Period, seed: int) -> SetPlan:
    """Return a plan with its bare places filled.

    Args:
        plan: As its kit drew it.
        room: The sort of room, a key of ``ROOMS``; any other word adds nothing.
        period: When the story plays.
        seed: Seed of the set.
    """
    kept = ROOMS.get(room)
    if kept is None or not plan.indoor:
        return plan
    filling = _Filling(plan, kept, period, np.random.default_rng((seed, 11)))
    for wall in plan.walls:
        if not wall.missing:
            filling.stand_along(wall)
            filling.hang_on(wall)
    filling.lay_on_tops()
    return plan.model_copy(
        update={
            "furnishings": (*plan.furnishings, *filling.furnishings),
            "pieces": (*plan.pieces, *filling.pieces),
        }
    )


@dataclass
class _Filling:
    """Adds belongings to one plan.

    Args:
        plan: As the kit drew it.
        kept: Belongings of this sort of room.
        period: When the story plays.
        rng: The seeded source of variation.
    """

    plan: SetPlan
    kept: Belongings
    period: Period
    rng: np.random.Generator
    furnishings: list[Furnishing] = field(default_factory=list)
    pieces: list[Piece] = field(default_factory=list)
    turns: dict[str, int] = field(default_factory=dict)

    def stand_along(self, wall: Wall) -> None:
        """Set furniture down along the bare foot of a wall."""
        face, added = _Face(wall), 0
        if face.length < 2.4 or self._depth_of_room(face) < 3.4:
            return
        blocked = [*face.openings(low=-0.1, high=0.9, doors=_WAY), *self._covered(face, 0.0, 0.9)]
        for start, end in _gaps(blocked, face.length, _MARGIN):
            for at in _evenly(start, end, 2.2):
                key = self._next("floor", self.kept.floor)
                if key is None or added >= _FULL:
                    return
                prop, params = STANDING[key]
                width, depth, height = _size(prop, params)
                x, y = face.point(at, depth / 2 + 0.04)
                box = Box(x, y, 0.0, width + 0.1, depth, height, math.radians(face.yaw))
                if width > end - start or not self._is_free(box):
                    continue
                self._furnish(prop, (x, y), 0.0, face.yaw, params)
                added += 1

    def hang_on(self, wall: Wall) -> None:
        """Hang pictures, shelves and the like where a wall is bare at the height of heads."""
        face = _Face(wall)
        low, high = 1.05, 2.1
        blocked = [*face.openings(low=low, high=high, doors=0.12), *self._covered(face, low, high)]
        for start, end in _gaps(blocked, face.length, _MARGIN):
            for at in _evenly(start, end, _EVERY):
                key = self._next("walls", self.kept.walls)
                if key is None:
                    return
                hanging = HUNG[key]
                choice = int(self.rng.integers(len(hanging.sizes)))
                width, height = hanging.sizes[choice]
                room = end - start if len(list(_evenly(start, end, _EVERY))) == 1 else _EVERY * 0.8
                if width > room - 0.1 or hanging.z(height) + height > wall.height - 0.08:
                    continue
                self._hang(hanging, face, at, width, height)

    def lay_on_tops(self) -> None:
        """Lay small things on tables, counters and cupboards that have nothing on them."""
        for item in (*self.plan.furnishings, *self.furnishings):
            tops = SURFACES.get(item.prop)
            width, depth, height = _size(item.prop, item.params)
            if tops is None or item.location[2] > 0.2 or self._bears_something(item, height):
                continue
            base = Box(*item.location, width, depth, height, math.radians(item.yaw))
            laid: list[Box] = []
            for share in tops:
                key = self._next("tops", self.kept.tops)
                if key is None:
                    return
                small = _size(key, {})
                if small[0] > 0.4 * width or small[1] > 0.7 * depth:
                    continue
                across = share * (width / 2 - small[0] / 2 - 0.04)
                x, y = base.to_world(across, min(0.1, (depth - small[1]) / 2 - 0.03) if depth > 0.2 else 0.0)
                turn = float(self.rng.integers(-20, 21))
                laid.append(Box(x, y, 0.0, *small, math.radians(item.yaw + turn)))
                if any(penetration(laid[-1], other)[0] > 0.0 for other in laid[:-1]):
                    continue
                self._furnish(key, (x, y), item.location[2] + height, item.yaw + turn, {}, loose=True)

    # ------------------------------------------------------------------ what is there

    def _depth_of_room(self, face: _Face) -> float:
        """Return the metres from a wall to the opposite side of the room."""
        size = self.plan.size
        across = (size.x - size.x_negative, size.y - size.y_negative)
        return across[0] if abs(face.inward[0]) > 0.5 else across[1]

    def _boxes(self) -> Iterator[Box]:
        """Yield the boxes of furniture and pieces, those added so far included, without flat things such as rugs."""
        for item in (*self.plan.furnishings, *self.furnishings):
            size = _size(item.prop, item.params)
            if size[2] > 0.05:
                yield Box(*item.location, *size, math.radians(item.yaw))
        for piece in (*self.plan.pieces, *self.pieces):
            boxes = piece_boxes(piece)
            yield from boxes or [_box_of(piece)]

    def _covered(self, face: _Face, low: float, high: float) -> Iterator[Vec2]:
        """Yield the stretches of a wall that something covers between two heights."""
        for box in self._boxes():
            along, away = face.local(box.x, box.y)
            gap = away - box.reach(face.inward)
            if gap < _NEAR and away > -0.5 and box.z < high and box.z + box.height > low:
                half = box.reach(face.along)
                yield (along - half, along + half)

    def _is_free(self, box: Box) -> bool:
        """Return whether furniture may stand somewhere: nothing is there, and nobody walks or acts there."""
        stage = stage_box(self.plan, _SPARE)
        marks = (Box(*mark.location[:2], 0.0, 2 * _WAY, 2 * _WAY, 2.0) for mark in self.plan.marks)
        others = (other for other in self._boxes() if other.z < box.height)
        return not any(penetration(box, other)[0] > 0.0 for other in (stage, *marks, *others))

    def _bears_something(self, base: Furnishing, height: float) -> bool:
        """Return whether something lies on top of a piece of furniture of this height."""
        top = base.location[2] + height
        width, depth, _ = _size(base.prop, base.params)
        box = Box(*base.location, width, depth, height, math.radians(base.yaw))
        for item in (*self.plan.furnishings, *self.furnishings):
            across, deep = box.to_local(*item.location[:2])
            if abs(item.location[2] - top) < 0.15 and abs(across) < width / 2 and abs(deep) < depth / 2:
                return True
        return False

    # ------------------------------------------------------------------ what is added

    def _next(self, kind: str, told: Sequence[str]) -> str | None:
        """Return the next thing of a list that suits the period, or None where none does."""
        fitting = [word.rpartition(":")[2] for word in told if ":" not in word or self.period in word.split(":")[0]]
        if not fitting:
            return None
        turn = self.turns.setdefault(kind, int(self.rng.integers(len(fitting))))
        for step in range(len(fitting)):
            key = fitting[(turn + step) % len(fitting)]
            if key not in ONE or not self._has(key):
                self.turns[kind] = turn + step + 1
                return key
        return None

    def _has(self, key: str) -> bool:
        """Return whether the room has a thing already."""
        prop = HUNG[key].key if key in HUNG else STANDING[key][0] if key in STANDING else key
        return any(item.prop == prop for item in (*self.plan.furnishings, *self.furnishings))

    def _hang(self, hanging: Hanging, face: _Face, at: float, width: float, height: float) -> None:
        """Hang a thing on a wall, its middle ``at`` metres along it."""
        z = hanging.z(height)
        if hanging.piece:
            x, y = face.point(at, 0.0)
            number = len(self.pieces)
            params: dict[str, ParamValue] = {"length": width, "seed": int(self.rng.integers(1000)), **hanging.params}
            self.pieces.append(
                Piece(node_id=f"kept_{hanging.key}_{number}", part=hanging.key, location=(x, y, z), yaw=face.yaw,
                      params=params, solid=False)
            )  # fmt: skip
            return
        depth = _size(hanging.key, {})[1]
        x, y = face.point(at, depth / 2 + 0.012)
        self._furnish(hanging.key, (x, y), z, face.yaw, {"width": width, "height": height, **hanging.params})

    def _furnish(
        self, prop: str, spot: Vec2, z: float, yaw: float, params: dict[str, ParamValue], *, loose: bool = False
    ) -> None:
        """Add a prop at a floor point and height; a thing of the script may take its place unless it is ``loose``."""
        node_id = f"set_kept_{prop}_{len(self.furnishings)}"
        location = (round(spot[0], 3), round(spot[1], 3), round(z, 3))
        self.furnishings.append(
            Furnishing(node_id=node_id, prop=prop, location=location, yaw=yaw % 360, params=params, required=False,
                       loose=loose)
        )  # fmt: skip


class _Face:
    """The room's side of a wall: places along it in metres from its start."""

    def __init__(self, wall: Wall) -> None:
        self.wall, self.length = wall, math.dist(wall.start, wall.end)
        self.along = ((wall.end[0] - wall.start[0]) / self.length, (wall.end[1] - wall.start[1]) / self.length)
        self.inward = (-self.along[1], self.along[0])
        self.yaw = math.degrees(math.atan2(self.inward[0], -self.inward[1])) % 360
        """Of a thing with its back to the wall."""

    def point(self, at: float, off: float) -> Vec2:
        """Return a floor point before the wall.

        Args:
            at: Metres along the wall from its start.
            off: Metres from the wall into the room.
        """
        (x, y), (ax, ay), (ix, iy) = self.wall.start, self.along, self.inward
        return (round(x + ax * at + ix * off, 4), round(y + ay * at + iy * off, 4))

    def local(self, x: float, y: float) -> Vec2:
        """Return how many metres along the wall, and how many before it, a floor point is."""
        dx, dy = x - self.wall.start[0], y - self.wall.start[1]
        return (dx * self.along[0] + dy * self.along[1], dx * self.inward[0] + dy * self.inward[1])

    def openings(self, *, low: float, high: float, doors: float) -> Iterator[Vec2]:
        """Yield the stretches of the wall that openings take between two heights, in metres from its start.

        Args:
            low: Lower height, metres.
            high: Upper height.
            doors: Margin on both sides of a door, metres; windows and curtains have their own.
        """
        for hole in self.wall.openings:
            if hole.sill < high and hole.sill + hole.height > low:
                margin = doors if hole.kind != "window" else 0.3 if hole.style in ("curtains", "sash") else 0.12
                yield (hole.x - margin, hole.x + hole.width + margin)


def _gaps(blocked: Sequence[Vec2], length: float, margin: float) -> list[Vec2]:
    """Return the free stretches between blocked ones."""
    free: list[Vec2] = []
    at = 0.0
    for start, end in [*sorted(blocked), (length, length)]:
        if start - margin - (at + margin) > 0.35:
            free.append((at + margin, start - margin))
        at = max(at, end)
    return free


def _evenly(start: float, end: float, every: float) -> Iterator[float]:
    """Yield evenly spaced positions in a stretch, about ``every`` metres apart; at least one, in its middle."""
    count = max(1, round((end - start) / every))
    for index in range(count):
        yield start + (index + 0.5) * (end - start) / count


def _size(prop: str, params: dict[str, ParamValue]) -> tuple[float, float, float]:
    """Return width, depth and height in metres of a prop with these parameters."""
    usual = PROPS[prop].size if prop in PROPS else (0.6, 0.6, 0.8)
    width, depth, height = (
        float(params.get(name, each)) for name, each in zip(("width", "depth", "height"), usual, strict=True)
    )
    return (width, depth, height)


def _box_of(piece: Piece) -> Box:
    """Return a rough box for a piece that people can walk through, such as a hanging."""
    width = float(piece.params.get("length", piece.params.get("width", 0.9)))
    height = float(piece.params.get("height", 1.0 if piece.location[2] > 0.3 else 2.2))
    return Box(*piece.location, width, 0.3, height, math.radians(piece.yaw))
