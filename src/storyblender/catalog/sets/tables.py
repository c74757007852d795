"""Draws the tables of a kit file: shell or ground first, then the contents in the order of the file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from storyblender.catalog.materials import hex_color
from storyblender.catalog.props import PROPS
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import CANDLE, COOL, SODIUM, WARM, SetParams, rectangle
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.hooks import HOOKS
from storyblender.catalog.sets.kit_file import (
    Conditional,
    GroundTable,
    KitBody,
    LampTable,
    Place,
    PlanTable,
    PutTable,
    Row,
    ScatterTable,
    ShellTable,
)
from storyblender.catalog.sets.room import YAW_OF_SIDE, Finishes, Room
from storyblender.catalog.sets.terms import value_of
from storyblender.memory.base import Color, Vec3

_COLORS: dict[str, Color] = {"warm": WARM, "candle": CANDLE, "cool": COOL, "sodium": SODIUM}
_CLEAR_OF_WALL = 0.04
"""Metres between a wall and an object against it."""


def draw_tables(kit: str, body: KitBody, params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Return the plan of a kit file.

    Args:
        kit: Key of the kit.
        body: Tables of the kit file.
        params: Size, period and options.
        rng: The seeded source of variation.

    Raises:
        ValueError: A table describes an object that cannot be drawn.
    """
    drawing = _room(kit, body.shell, params, rng) if body.shell else _ground(kit, body.ground, params, rng)
    return _Tables(drawing, params).draw(body)


def _room(kit: str, shell: ShellTable, params: SetParams, rng: np.random.Generator) -> Room:
    """Return a room with the shell of a kit file, as its period has it."""
    names = ("wall", "floor", "ceiling", "dado", "dado_height", "beams", "outside")
    said = {name: getattr(table, name) for table in (shell, getattr(shell, params.period)) for name in names
            if getattr(table, name) is not None}  # fmt: skip
    return Room(kit, params, rng, Finishes(**said), view=shell.view, thickness=shell.thickness, pit=shell.pit)


def _ground(kit: str, table: GroundTable | None, params: SetParams, rng: np.random.Generator) -> Ground:
    """Return the ground of a kit file: rolling land, a limited sheet or a plain."""
    if table is None:
        raise ValueError("there is neither [shell] nor [ground]")
    ground = Ground(kit, params, rng)
    names = {"x": ground.half_x, "y": ground.half_y, "h": 0.0, "n": 0.0}
    if table.relief or table.rise:
        flat = None if table.flat is None else value_of(table.flat, names)
        ground.land(table.material, relief=table.relief, rise=table.rise, flat=flat)
    elif table.extent:
        x0, y0, x1, y1 = (value_of(term, names) for term in table.extent)
        ground.slab("ground", rectangle(x0, y0, x1, y1), table.material, wet=table.wet)
    else:
        ground.level(table.material, wet=table.wet)
    return ground


@dataclass
class _Tables:
    """One drawing in progress.

    Args:
        drawing: Drawing that receives all parts.
        params: Size, period and options.
    """

    drawing: Room | Ground
    params: SetParams
    placed: dict[str, list[_Spot]] = field(default_factory=dict)
    """Positions of the placed objects, by id."""

    def draw(self, body: KitBody) -> SetPlan:
        """Draw all tables and return the plan."""
        plan = body.plan
        if isinstance(self.drawing, Room):
            self._openings(self.drawing, plan)
            if plan.centre is not None:
                self.drawing.centre = (self._value(plan.centre[0]), self._value(plan.centre[1]))
        for slab in filter(self._holds, plan.slab):
            x0, y0, x1, y1 = (self._value(term) for term in slab.box)
            self.drawing.slab(slab.role, rectangle(x0, y0, x1, y1), slab.material,
                              z=self._value(slab.z), thickness=slab.thickness, wet=slab.wet)  # fmt: skip
        for put in filter(self._holds, plan.put):
            self._put(put)
        if isinstance(self.drawing, Ground):
            self._outdoors(self.drawing, plan, body.ground)
        for lamp in filter(self._holds, plan.lamp):
            self._lamp(lamp)
        for mark in filter(self._holds, plan.mark):
            x, y, yaw = (self._value(term) for term in (mark.x, mark.y, mark.yaw))
            self.drawing.mark(mark.name, x, y, yaw, *mark.tags)
        for hook in filter(self._holds, plan.hook):
            HOOKS[hook.name](self.drawing, hook.give)
        return self.drawing.finish()

    def _holds(self, table: Conditional) -> bool:
        """Return whether a table's conditions hold for the period and the options."""
        facts = {self.params.period, *(name for name, value in self.params.options.items() if value)}
        return (not table.when or bool(facts.intersection(table.when))) and facts.isdisjoint(table.unless)

    def _value(self, term: float | str, copy: int = 0) -> float:
        """Return a term as a number; ``copy`` is the value of its variable ``n``."""
        height = self.params.height if isinstance(self.drawing, Room) else 0.0
        return value_of(term, {"x": self.drawing.half_x, "y": self.drawing.half_y, "h": height, "n": float(copy)})

    def _values(self, place: Place) -> list[float]:
        """Return the coordinates that a term or a row evaluates to."""
        if not isinstance(place, Row):
            return [self._value(place)]
        start, end = self._value(place.start), self._value(place.end)
        if place.every is None:
            count = place.count or 1
        else:  # the row stays in the middle of its span
            count = 1 + math.floor(max(0.0, end - start) / place.every + 1e-6)
            slack = (end - start - (count - 1) * place.every) / 2
            start, end = start + slack, end - slack
        return [round(float(value), 4) for value in np.linspace(start, end, count)]

    def _openings(self, room: Room, plan: PlanTable) -> None:
        """Cut the doors and windows of a room."""
        for door in filter(self._holds, plan.door):
            room.door(door.side, self._value(door.at), width=door.width, height=door.height, style=door.style,
                      state=door.state, name=door.name, tags=door.tags)  # fmt: skip
        for window in filter(self._holds, plan.window):
            for at in self._values(window.at):
                room.window(window.side, at, width=window.width, height=window.height, sill=window.sill,
                            style=window.style, mark=window.mark)  # fmt: skip

    def _outdoors(self, ground: Ground, plan: PlanTable, table: GroundTable | None) -> None:
        """Add planting, backdrops and entrances of open ground."""
        for planting in filter(self._holds, plan.scatter):
            self._scatter(ground, planting)
        for card in filter(self._holds, plan.backdrop):
            ground.ring(card.kind, card.radius, card.top, bottom=card.bottom, azimuths=card.between, sides=card.sides)
        ground.mark("centre", 0.0, 0.0, 0.0, "centre")
        ways = table.entrances if table else ()
        x, y = ground.half_x - 0.5, ground.half_y - 0.5
        for side, spot in (("left", (-x, 0.0, 90.0)), ("right", (x, 0.0, 270.0)), ("back", (0.0, y, 0.0))):
            if side in ways:
                ground.mark(f"enter_{side}", *spot, "enter", "exit", side)

    def _scatter(self, ground: Ground, table: ScatterTable) -> None:
        """Plant the pieces of a scatter table."""
        lanes = tuple(((a, b), (c, d), wide) for a, b, c, d, wide in (map(self._value, lane) for lane in table.lanes))
        ground.scatter(
            table.pieces, table.count, inner=self._value(table.inner), outer=self._value(table.outer), gap=table.gap,
            variants=table.variants, scale=table.scale, sector=table.sector, clear=lanes, sunk=table.sunk,
            solid=table.solid, centre=(self._value(table.x), self._value(table.y)),
        )  # fmt: skip

    def _lamp(self, table: LampTable) -> None:
        """Add the lights of a lamp table, one at each of its places."""
        color = _COLORS[table.color] if table.color in _COLORS else hex_color(table.color)
        target = None if table.target is None else tuple(map(self._value, table.target))
        for x in self._values(table.x):
            for y in self._values(table.y):
                aim: Vec3 | None = None if target is None else (target[0], target[1], target[2])
                self.drawing.lamp(
                    table.name, (x, y, self._value(table.z)), table.watts, color, kind=table.kind, target=aim,
                    size=table.size, cone=table.cone, glow=table.glow, role=table.role,
                )  # fmt: skip

    # ------------------------------------------------------------------ props and pieces

    def _put(self, table: PutTable) -> None:
        """Add the props or pieces of a table, one at each of its places."""
        keys = table.prop or table.piece
        keys = (keys,) if isinstance(keys, str) else keys
        spots = self.placed.setdefault(table.id, []) if table.id else []
        for copy, spot in enumerate(self._spots(table, keys)):
            if copy in table.skip:
                continue
            spot = self._varied(spot, table)
            key = keys[copy % len(keys)]
            given = {name: self._given(value, copy) for name, value in table.give.items()}
            if table.prop:
                if table.hang is not None and isinstance(self.drawing, Room):
                    self.drawing.hang(key, spot.x, spot.y, low=table.hang)
                else:
                    self.drawing.furnish(key, *spot, required=table.required, **given)
            else:
                width, depth, *tall = [self._value(term) for term in table.footprint] or [0.0, 0.0]
                footprint = (width, depth) if table.footprint else None
                given |= {"tall": tall[0]} if tall else {}
                self.drawing.piece(key, *spot, scale=table.scale, footprint=footprint, wild=table.wild, **given)
            spots.append(spot.topped(float(given.get("height", PROPS[key].size[2])) if table.prop else 0.0))

    def _given(self, value: ParamValue | tuple[ParamValue, ...], copy: int) -> ParamValue:
        """Return a parameter of one copy: of a list the next in turn, of a text such as ``=n * 2`` its value."""
        if isinstance(value, tuple):
            value = value[copy % len(value)]
        return self._value(value[1:], copy) if isinstance(value, str) and value.startswith("=") else value

    def _spots(self, table: PutTable, keys: tuple[str, ...]) -> Iterator[_Spot]:
        """Yield the places of a table: along a side, relative to other objects, or in the set's own frame."""
        z, yaw = 0.0 if table.z is None else self._value(table.z), self._value(table.yaw)
        if table.side is not None and isinstance(self.drawing, Room):
            off = self._depth(keys[0], table) / 2 + _CLEAR_OF_WALL if table.off is None else self._value(table.off)
            for at in self._values(table.at):
                x, y = self.drawing.spot(table.side, at, off)
                yield _Spot(x, y, z, YAW_OF_SIDE[table.side] + yaw)
            return
        offsets = [(x, y) for x in self._values(table.x) for y in self._values(table.y)]
        anchor = table.on or table.by
        for base in self.placed.get(anchor, []) if anchor else [_Spot(0.0, 0.0, 0.0, 0.0)]:
            for x, y in offsets:
                spot = base.beside(x, y, z + (base.top if table.on else 0.0), yaw)
                if isinstance(self.drawing, Ground) and anchor is None:
                    spot = spot.lifted(self.drawing.height(spot.x, spot.y))
                yield spot

    def _depth(self, key: str, table: PutTable) -> float:
        """Return the depth of a prop in metres, front to back; set pieces have their back at their origin."""
        depth = table.give.get("depth")
        if not table.prop:
            return -2 * _CLEAR_OF_WALL
        return float(depth) if isinstance(depth, int | float) else PROPS[key].size[1]

    def _varied(self, spot: _Spot, table: PutTable) -> _Spot:
        """Return a spot moved and turned at random by as much as its table allows."""
        if not table.vary and not table.turn:
            return spot
        dx, dy = (self.drawing.between(-table.vary, table.vary) if table.vary else 0.0 for _ in "xy")
        turned = self.drawing.between(-table.turn, table.turn) if table.turn else 0.0
        return _Spot(round(spot.x + dx, 3), round(spot.y + dy, 3), spot.z, spot.yaw + turned)


@dataclass(frozen=True)
class _Spot:
    """Position in metres and yaw in degrees of an object, and the height of its top above its base."""

    x: float
    y: float
    z: float
    yaw: float
    top: float = 0.0

    def __iter__(self) -> Iterator[float]:
        yield from (self.x, self.y, self.z, self.yaw)

    def beside(self, x: float, y: float, z: float, yaw: float) -> _Spot:
        """Return the spot at ``x``, ``y``, ``z`` metres and ``yaw`` degrees in the frame of this one."""
        turn = math.radians(self.yaw)
        dx, dy = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
        return _Spot(round(self.x + dx, 4), round(self.y + dy, 4), round(self.z + z, 4), self.yaw + yaw)

    def lifted(self, height: float) -> _Spot:
        """Return the spot raised by the height of the ground."""
        return _Spot(self.x, self.y, round(self.z + height, 4), self.yaw)

    def topped(self, top: float) -> _Spot:
        """Return the spot with the top height of the object on it."""
        return _Spot(self.x, self.y, self.z, self.yaw, top)
