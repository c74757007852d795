"""A rectangular room: four walls with doors and windows, floor, ceiling, and something to see outside.

Sides are named as the audience sees them: ``back`` (+Y), ``front`` (-Y), ``left`` (-X), ``right`` (+X).
``at`` is measured along a side from its middle, to the right (back, front) or to the back (left, right).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import Opening, SetPlan, Wall
from storyblender.catalog.sets.drawing import Drawing, SetParams, rectangle
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import SceneSize

Side = Literal["back", "front", "left", "right"]
View = Literal["skyline", "treeline", "hills", "sea", "facades", "none"]

YAW_OF_SIDE: dict[Side, float] = {"back": 0.0, "front": 180.0, "left": 90.0, "right": 270.0}
"""The yaw of a thing that stands against the side and faces the room."""


_PIT = 1.1
"""Metres that a pit is deep."""
_KERB = 0.4
"""Metres of stone along its edge."""
_VIEW_TOPS = {"skyline": 14.0, "facades": 10.0, "hills": 6.5, "treeline": 5.2, "sea": 1.6}
"""Height of what stands outside, low enough to leave some sky in the windows."""


@dataclass(frozen=True)
class Finishes:
    """Finish keys of a room's shell."""

    wall: str
    floor: str
    ceiling: str = "ceiling_white"
    dado: str | None = None
    dado_height: float = 0.95
    beams: int = 0
    outside: str = "paving"


@dataclass
class _View:
    kind: View
    distance: float = 16.0
    sides: set[Side] = field(default_factory=set)


class Room(Drawing):
    """A drawing that starts with four walls; kits add openings and furniture.

    Args:
        kit: Key of the kit.
        params: Width (x), depth (y) and height inside the walls.
        rng: The seeded source of variation.
        finishes: What the shell is made of.
        view: What stands outside the windows.
        thickness: Of the walls.
        pit: Metres before the back wall where the floor ends at a pit: a track, a dock. People stay off it.
    """

    def __init__(
        self,
        kit: str,
        params: SetParams,
        rng: np.random.Generator,
        finishes: Finishes,
        *,
        view: View = "facades",
        thickness: float = 0.15,
        pit: float = 0.0,
    ) -> None:
        self.half_x, self.half_y, self.height = params.width / 2, params.depth / 2, params.height
        size = SceneSize(x=self.half_x, x_negative=-self.half_x, y=self.half_y - pit, y_negative=-self.half_y)
        super().__init__(kit, indoor=True, size=size, rng=rng)
        self.params, self.finishes, self.thickness, self.pit = params, finishes, thickness, pit
        self.centre: Vec2 = (0.0, 0.0)
        """Where people act."""
        self._view = _View(view)
        self._openings: dict[Side, list[Opening]] = {"back": [], "front": [], "left": [], "right": []}

    def length(self, side: Side) -> float:
        """Return the length of a side in metres."""
        return 2 * (self.half_x if side in ("back", "front") else self.half_y)

    def spot(self, side: Side, at: float, off: float) -> Vec2:
        """Return a floor point before a side of the room.

        Args:
            side: As the audience sees it.
            at: Metres along the side from its middle.
            off: Metres from the wall into the room.
        """
        if side == "back":
            return (at, self.half_y - off)
        if side == "front":
            return (at, -self.half_y + off)
        if side == "left":
            return (-self.half_x + off, at)
        return (self.half_x - off, at)

    def against(
        self,
        side: Side,
        prop: str,
        at: float,
        off: float,
        *,
        z: float = 0.0,
        required: bool = True,
        **params: ParamValue,
    ) -> str:
        """Add a prop against a side, facing the room, and return its id.

        Args:
            side: As the audience sees it.
            prop: Key of the prop.
            at: Metres along the side from its middle.
            off: Metres from the wall to its centre.
            z: Height of its foot.
            required: False for dressing.
            **params: Parameters of the prop.
        """
        x, y = self.spot(side, at, off)
        return self.furnish(prop, x, y, z, YAW_OF_SIDE[side], required=required, **params)

    def on_wall(self, side: Side, prop: str, at: float, z: float, *, off: float = 0.04, **params: ParamValue) -> str:
        """Hang a prop on a side, as dressing, and return its id.

        Args:
            side: As the audience sees it.
            prop: Key of the prop.
            at: Metres along the side from its middle.
            z: Height of its lower edge.
            off: Metres from the wall to its centre.
            **params: Parameters of the prop.
        """
        return self.against(side, prop, at, off, z=z, required=False, **params)

    def hang(self, prop: str, x: float, y: float, *, low: float = 2.15) -> str:
        """Hang a lamp from the ceiling and return its id.

        Args:
            prop: Key of the lamp.
            x: Metres.
            y: Metres.
            low: Height of its lower edge: over heads, or lower over a table.
        """
        length = round(min(max(self.height - low, 0.4), 1.6), 3)
        if prop == "lantern":
            self.piece("chain", x, y, self.height, length=length - 0.3)
            return self.furnish(prop, x, y, round(self.height - length - 0.05, 3))
        return self.furnish(prop, x, y, round(self.height - length, 3), height=length)

    def door(
        self,
        side: Side,
        at: float,
        *,
        width: float = 0.95,
        height: float = 2.1,
        style: str = "panel",
        state: Literal["open", "closed"] = "closed",
        name: str = "door",
        tags: tuple[str, ...] = ("enter", "exit", "door"),
    ) -> None:
        """Cut a door and mark the place before it where people come in.

        Args:
            side: As the audience sees it.
            at: Metres along the side from its middle.
            width: Metres.
            height: Metres.
            style: Style of ``set_plan.Opening``; ``arch`` has no leaf.
            state: Whether its leaf is open.
            name: Id of the opening.
            tags: What the place before it is for.
        """
        kind: Literal["door", "arch"] = "arch" if style == "arch" else "door"
        self._cut(side, at, name, kind, 0.0, width, height, style, state)
        x, y = self.spot(side, at, 0.55)
        self.mark(self.name(f"{name}_mark"), x, y, YAW_OF_SIDE[side], *tags)

    def window(
        self,
        side: Side,
        at: float,
        *,
        width: float = 1.3,
        height: float = 1.45,
        sill: float = 0.9,
        style: str = "sash",
        mark: bool = False,
    ) -> None:
        """Cut a window.

        Args:
            side: As the audience sees it.
            at: Metres along the side from its middle.
            width: Metres.
            height: Metres.
            sill: Height of its lower edge.
            style: Style of ``set_plan.Opening``.
            mark: Name the place before it, where a person may look out.
        """
        self._cut(side, at, "window", "window", sill, width, min(height, self.height - sill - 0.15), style, "closed")
        self._view.sides.add(side)
        if mark:
            x, y = self.spot(side, at, 0.6)
            self.mark(self.name("window_mark"), x, y, YAW_OF_SIDE[side] + 180, "window")

    def gap(self, side: Side, at: float, width: float, height: float) -> None:
        """Leave a bare hole in a wall, such as the mouth of a tunnel.

        Args:
            side: As the audience sees it.
            at: Metres along the side from its middle.
            width: Metres.
            height: Metres, from the floor.
        """
        self._cut(side, at, "gap", "gap", 0.0, width, height, "", "open")

    def _cut(
        self,
        side: Side,
        at: float,
        name: str,
        kind: Literal["door", "window", "arch", "gap"],
        sill: float,
        width: float,
        height: float,
        style: str,
        state: Literal["open", "closed"],
    ) -> None:
        """Add an opening to a side, its middle ``at`` metres along it."""
        half = self.length(side) / 2
        along = at if side in ("front", "right") else -at
        self._openings[side].append(
            Opening(
                name=self.name(name),
                kind=kind,
                x=round(half + along - width / 2, 4),
                sill=sill,
                width=width,
                height=min(height, self.height - 0.1),
                style=style,
                state=state,
            )
        )

    def finish(self) -> SetPlan:
        """Raise the walls, lay floor and ceiling, hang what is seen through the windows, return the plan."""
        x, y, look = self.half_x, self.half_y, self.finishes
        ends: dict[Side, tuple[Vec2, Vec2]] = {
            "front": ((-x, -y), (x, -y)),
            "right": ((x, -y), (x, y)),
            "back": ((x, y), (-x, y)),
            "left": ((-x, y), (-x, -y)),
        }
        for side, (start, end) in ends.items():
            self.walls.append(
                Wall(
                    node_id=f"wall_{side}",
                    start=start,
                    end=end,
                    height=self.height + (_PIT if self.pit and side == "back" else 0.0),
                    base=-_PIT if self.pit and side == "back" else 0.0,
                    thickness=self.thickness,
                    material=look.wall,
                    dado=look.dado,
                    dado_height=look.dado_height,
                    openings=tuple(sorted(self._openings[side], key=lambda opening: opening.x)),
                )
            )
        edge = self.thickness
        end = y - self.pit - _KERB if self.pit else y + edge
        self.slab("floor", rectangle(-x - edge, -y - edge, x + edge, end), look.floor)
        if self.pit:
            self.slab("block", rectangle(-x - edge, end, x + edge, y - self.pit), "concrete_light", thickness=_PIT)
            self.slab("ground", rectangle(-x - edge, y - self.pit, x + edge, y + edge), "gravel", z=-_PIT)
        self.slab(
            "ceiling",
            rectangle(-x - edge, -y - edge, x + edge, y + edge),
            look.ceiling,
            z=self.height,
            beams=look.beams,
        )
        self.mark("centre", *self.centre, 0.0, "centre")
        for side in ("back", "left", "right", "front"):
            if side in self._view.sides and self._view.kind != "none":
                self._hang_view(side, self._view.kind)
        return super().finish()

    def _hang_view(self, side: Side, kind: Literal["skyline", "treeline", "hills", "sea", "facades"]) -> None:
        """Hang the backdrop seen through the windows of a side, and lay the ground before it."""
        x, y, view = self.half_x, self.half_y, self._view
        far, spread, edge = view.distance, view.distance, self.thickness
        left, right, ground = {
            "back": ((-x - spread, y + far), (x + spread, y + far), (-x - spread, y + edge, x + spread, y + far)),
            "front": ((x + spread, -y - far), (-x - spread, -y - far), (-x - spread, -y - far, x + spread, -y - edge)),
            "left": ((-x - far, -y - spread), (-x - far, y + spread), (-x - far, -y - spread, -x - edge, y + spread)),
            "right": ((x + far, y + spread), (x + far, -y - spread), (x + edge, -y - spread, x + far, y + spread)),
        }[side]
        self.card(kind, left, right, -1.0, _VIEW_TOPS[kind])
        self.slab("patch", rectangle(*ground), self.finishes.outside, z=-0.18)
