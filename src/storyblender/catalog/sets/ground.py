"""Open ground: a level stage, land around it, and a horizon closed on all sides."""

from __future__ import annotations

import math

import numpy as np

from storyblender.catalog.sets.drawing import Drawing, SetParams, rectangle
from storyblender.catalog.sets.terrain import ground_height
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import SceneSize

REACH = 90.0
"""Metres from the middle to the edge of the land; the horizon's cards stand inside it."""


class Ground(Drawing):
    """A drawing that starts under the sky.

    Args:
        kit: Key of the kit.
        params: Width and depth of the playing area.
        rng: The seeded source of variation.
    """

    def __init__(self, kit: str, params: SetParams, rng: np.random.Generator) -> None:
        self.half_x, self.half_y = params.width / 2, params.depth / 2
        size = SceneSize(x=self.half_x, x_negative=-self.half_x, y=self.half_y, y_negative=-self.half_y)
        super().__init__(kit, indoor=False, size=size, rng=rng)
        self.params = params
        self._flat, self._relief, self._rise, self._seed = REACH, 0.0, 0.0, 0

    def level(self, material: str, *, wet: bool = False) -> None:
        """Lay flat ground to the horizon.

        Args:
            material: Finish or material key.
            wet: Whether it mirrors when it rains or at night.
        """
        self.slab("ground", rectangle(-REACH, -REACH, REACH, REACH), material, wet=wet)

    def land(self, material: str, *, relief: float, rise: float = 0.0, flat: float | None = None) -> None:
        """Lay rolling ground that is level where people act.

        Args:
            material: Finish or material key.
            relief: Height of its hills, metres.
            rise: Metres that it gains per metre beyond the level middle.
            flat: Radius of the level middle, metres; None for one around the playing area.
        """
        self._flat = math.hypot(self.half_x, self.half_y) if flat is None else flat
        self._relief, self._rise, self._seed = relief, rise, int(self.rng.integers(1000))
        self.piece(
            "terrain",
            0.0,
            0.0,
            material=material,
            flat=self._flat,
            relief=relief,
            rise=rise,
            seed=float(self._seed),
            reach=REACH,
        )

    def height(self, x: float, y: float) -> float:
        """Return the world z of the ground at the floor point ``x``, ``y``, all in metres; 0 before ``land``."""
        return round(
            float(ground_height(x, y, flat=self._flat, relief=self._relief, rise=self._rise, seed=self._seed)), 3
        )

    def scatter(
        self,
        parts: tuple[str, ...],
        count: int,
        *,
        inner: float,
        outer: float,
        gap: float,
        variants: int = 3,
        scale: tuple[float, float] = (0.8, 1.2),
        sector: tuple[float, float] = (0.0, 360.0),
        clear: tuple[tuple[Vec2, Vec2, float], ...] = (),
        sunk: float = 0.05,
        solid: float = 0.0,
        centre: Vec2 = (0.0, 0.0),
    ) -> None:
        """Plant pieces at random, denser near the stage, none closer than ``gap`` to the next.

        Args:
            parts: Pieces to draw from.
            count: How many; fewer if there is no room.
            inner: Metres from the middle where planting starts.
            outer: And ends.
            gap: Least distance between two; grows with distance.
            variants: Different meshes of each part.
            scale: Range of sizes.
            sector: Azimuths in degrees from +Y, counter-clockwise.
            clear: Lanes kept free: two points and a half width.
            sunk: Metres below the ground.
            solid: Width of what people walk around; 0 for none.
            centre: What ``inner``, ``outer`` and ``sector`` are measured from.
        """
        placed: list[Vec2] = []
        for _ in range(count * 30):
            if len(placed) == count:
                return
            radius = inner + (outer - inner) * float(self.rng.random()) ** 0.8
            azimuth = math.radians(self.between(*sector))
            x = round(centre[0] - radius * math.sin(azimuth), 3)
            y = round(centre[1] + radius * math.cos(azimuth), 3)
            room = gap + 0.03 * radius
            if any((x - px) ** 2 + (y - py) ** 2 < room * room for px, py in placed):
                continue
            if any(_distance_to_lane((x, y), a, b) < width for a, b, width in clear):
                continue
            placed.append((x, y))
            self.piece(
                self.choose(parts),
                x,
                y,
                self.height(x, y) - sunk,
                self.between(0, 360),
                scale=self.between(*scale),
                footprint=(solid, solid) if solid else None,
                variant=float(self.rng.integers(variants)),
            )

    def vehicle(self, x: float, y: float, yaw: float, color: str = "#2c3f4c") -> None:
        """Park a vehicle of the period, as dressing: a cart, an old car or a modern one.

        Args:
            x: Metres.
            y: Metres.
            yaw: Degrees; 0 faces -Y.
            color: Hex colour of a car.
        """
        if self.params.period == "past":
            self.furnish("cart", x, y, yaw=yaw, required=False)
        else:
            make = "modern" if self.params.period == "modern" else "1940s"
            self.furnish("car", x, y, yaw=yaw, required=False, period=make, color=color)

    def entrances(self, *, back: bool = True) -> None:
        """Mark the middle and the places where people come in from the wings."""
        self.mark("centre", 0.0, 0.0, 0.0, "centre")
        self.mark("enter_left", -self.half_x + 0.5, 0.0, 90.0, "enter", "exit", "left")
        self.mark("enter_right", self.half_x - 0.5, 0.0, 270.0, "enter", "exit", "right")
        if back:
            self.mark("enter_back", 0.0, self.half_y - 0.5, 0.0, "enter", "exit", "back")


def _distance_to_lane(point: Vec2, a: Vec2, b: Vec2) -> float:
    """Return the distance of a point from the line between ``a`` and ``b``, metres."""
    ax, ay = b[0] - a[0], b[1] - a[1]
    length = ax * ax + ay * ay
    t = min(1.0, max(0.0, ((point[0] - a[0]) * ax + (point[1] - a[1]) * ay) / length)) if length else 0.0
    return math.hypot(point[0] - a[0] - t * ax, point[1] - a[1] - t * ay)
