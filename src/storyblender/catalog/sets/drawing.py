"""The drawing board: a kit draws its walls, pieces, furniture, lamps and marks here and gets a SetPlan."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal

import numpy as np

from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import Backdrop, Furnishing, Piece, PlanMark, SetPlan, Slab, Wall
from storyblender.memory.base import Color, Vec2, Vec3
from storyblender.memory.scene_context import Light, SceneSize
from storyblender.memory.vocabulary import Period

WARM: Color = (1.0, 0.74, 0.44)
CANDLE: Color = (1.0, 0.62, 0.28)
COOL: Color = (0.86, 0.94, 1.0)
SODIUM: Color = (1.0, 0.70, 0.38)


@dataclass(frozen=True)
class SetParams:
    """Parameters of every kit: size in metres between the walls, or of the ground people act on, period and options."""

    width: float
    depth: float
    height: float = 2.9
    period: Period = "classic"
    options: Mapping[str, ParamValue] = field(default_factory=dict)
    """The kit's own parameters."""

    def option(self, name: str) -> ParamValue:
        """Return one of the kit's own parameters. Raises KeyError."""
        return self.options[name]


def rectangle(x0: float, y0: float, x1: float, y1: float) -> tuple[Vec2, ...]:
    """Return the corners of an axis-parallel rectangle, counter-clockwise.

    Args:
        x0: Left side, metres.
        y0: Front side.
        x1: Right side.
        y1: Back side.
    """
    return ((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def facing(x: float, y: float, target: Vec2) -> float:
    """Return the yaw in degrees of something that faces a point (yaw 0 faces -Y).

    Args:
        x: Where it stands, metres.
        y: Where it stands.
        target: Floor point that it faces.
    """
    return math.degrees(math.atan2(target[0] - x, y - target[1]))


class Drawing:
    """Collects the parts of a plan and numbers them, so that ids are unique and stable.

    Args:
        kit: Key of the kit.
        indoor: False where the sky is the ceiling.
        size: The playing area.
        rng: The seeded source of variation.
    """

    def __init__(self, kit: str, *, indoor: bool, size: SceneSize, rng: np.random.Generator) -> None:
        self.kit, self.indoor, self.size, self.rng = kit, indoor, size, rng
        self.walls: list[Wall] = []
        self.slabs: list[Slab] = []
        self.pieces: list[Piece] = []
        self.backdrops: list[Backdrop] = []
        self.furnishings: list[Furnishing] = []
        self.lamps: list[Light] = []
        self.marks: list[PlanMark] = []
        self._counts: Counter[str] = Counter()

    def name(self, stem: str) -> str:
        """Return the next id of a family: ``facade_1``, ``facade_2``."""
        self._counts[stem] += 1
        return f"{stem}_{self._counts[stem]}"

    def between(self, low: float, high: float) -> float:
        """Return a random number from ``low`` to ``high``, rounded to thousandths."""
        return round(float(self.rng.uniform(low, high)), 3)

    def choose(self, options: Iterable[str]) -> str:
        """Draw one of ``options``."""
        choices = tuple(options)
        return choices[int(self.rng.integers(len(choices)))]

    def slab(
        self,
        role: Literal["floor", "ground", "ceiling", "patch", "block"],
        polygon: tuple[Vec2, ...],
        material: str,
        *,
        z: float = 0.0,
        thickness: float = 0.0,
        wet: bool = False,
        beams: int = 0,
    ) -> None:
        """Lay a horizontal sheet or block.

        Args:
            role: Floor, ground, ceiling, patch or block.
            polygon: Its corners, counter-clockwise.
            material: Finish or material key.
            z: Height of its upper side; of a ceiling the lower one.
            thickness: Of a block, metres.
            wet: Whether it mirrors when it rains or at night.
            beams: Number of beams under a ceiling.
        """
        self.slabs.append(
            Slab(
                node_id=self.name(role),
                role=role,
                polygon=polygon,
                z=z,
                thickness=thickness,
                material=material,
                wet=wet,
                beams=beams,
            )
        )

    def piece(
        self,
        part: str,
        x: float,
        y: float,
        z: float = 0.0,
        yaw: float = 0.0,
        *,
        scale: float = 1.0,
        footprint: Vec2 | None = None,
        wild: bool = False,
        **params: ParamValue,
    ) -> str:
        """Add a set piece and return its id.

        Args:
            part: Key of a builder in ``blender/sets/pieces``.
            x: Where it stands, metres.
            y: Where it stands.
            z: Height of its foot.
            yaw: Degrees; 0 faces -Y.
            scale: Size factor.
            footprint: Width and depth that people walk around; None lets them pass.
            wild: Whether it may be taken away for a shot.
            **params: Parameters of the builder.
        """
        node_id = self.name(part)
        self.pieces.append(
            Piece(
                node_id=node_id,
                part=part,
                location=(x, y, z),
                yaw=yaw,
                scale=scale,
                params=params,
                solid=footprint is not None,
                footprint=footprint,
                wild=wild,
            )
        )
        return node_id

    def furnish(
        self,
        prop: str,
        x: float,
        y: float,
        z: float = 0.0,
        yaw: float = 0.0,
        *,
        required: bool = True,
        **params: ParamValue,
    ) -> str:
        """Add a prop of ``catalog.props`` and return its id.

        Args:
            prop: Key of the prop.
            x: Where it stands, metres.
            y: Where it stands.
            z: Height of its foot.
            yaw: Degrees; 0 faces -Y.
            required: False for dressing, which is dropped first where room is short.
            **params: Parameters of the prop.
        """
        node_id = self.name(f"set_{prop}")
        self.furnishings.append(
            Furnishing(node_id=node_id, prop=prop, location=(x, y, z), yaw=yaw % 360, params=params, required=required)
        )
        return node_id

    def seats_around(
        self, prop: str, x: float, y: float, radius: float, yaws: Iterable[float], *, required: bool = True
    ) -> None:
        """Add seats on a circle, each facing its centre.

        Args:
            prop: Key of the seat.
            x: Centre of the circle, metres.
            y: Centre of the circle.
            radius: Metres.
            yaws: Where on the circle they stand, degrees from -Y.
            required: False for dressing.
        """
        for yaw in yaws:
            angle = math.radians(yaw)
            self.furnish(
                prop, x + radius * math.sin(angle), y - radius * math.cos(angle), yaw=yaw + 180, required=required
            )

    def lamp(
        self,
        name: str,
        location: Vec3,
        power: float,
        color: Color = WARM,
        *,
        kind: Literal["POINT", "SPOT", "AREA"] = "POINT",
        target: Vec3 | None = None,
        size: float = 0.1,
        cone: float = 120.0,
        glow: float = 0.0,
        role: Literal["set", "practical"] = "practical",
    ) -> None:
        """Add a light that belongs to the place.

        Args:
            name: Of the light.
            location: Metres.
            power: Watts at night.
            color: Scene-linear.
            kind: Blender's type of light.
            target: Where it points; None for straight down.
            size: Radius, or diameter of an area light, metres.
            cone: Full angle of a spot, degrees.
            glow: Strength of its halo in the air, 0 to 1.
            role: ``practical`` for a lamp that is seen, ``set`` for one that is not.
        """
        below = (location[0], location[1], 0.0)
        self.lamps.append(
            Light(
                name=self.name(name),
                kind=kind,
                role=role,
                location=location,
                target=below if target is None else target,
                power=power,
                color=color,
                size=size,
                cone=cone,
                glow=glow,
            )
        )

    def mark(self, name: str, x: float, y: float, yaw: float, *tags: str) -> None:
        """Name a place where people enter, stand or wait.

        Args:
            name: Of the place.
            x: Metres.
            y: Metres.
            yaw: Where people there face, degrees; 0 faces -Y.
            *tags: What the place is for; its name if there are none.
        """
        self.marks.append(PlanMark(name=name, location=(x, y, 0.0), yaw=yaw % 360, tags=tags or (name,)))

    def card(
        self,
        kind: Literal["skyline", "treeline", "hills", "sea", "facades", "stars", "deep", "plain"],
        left: Vec2,
        right: Vec2,
        bottom: float,
        top: float,
        emission: float = 1.0,
        *,
        right_top: float | None = None,
    ) -> None:
        """Hang a backdrop between two points, ``left`` and ``right`` as seen from the set.

        Args:
            kind: What it shows.
            left: Floor point of its left edge.
            right: And of its right edge.
            bottom: Height of its lower edge.
            top: Height of its upper edge; of its left end where ``right_top`` differs.
            emission: How bright it shines by day.
            right_top: Height of its upper right corner.
        """
        self.backdrops.append(
            Backdrop(
                node_id=self.name(f"backdrop_{kind}"),
                kind=kind,
                corners=((*left, bottom), (*right, bottom), (*right, right_top or top), (*left, top)),
                emission=emission,
            )
        )

    def ring(
        self,
        kind: Literal["skyline", "treeline", "hills", "sea", "facades", "stars", "deep"],
        radius: float,
        top: float,
        *,
        bottom: float = -2.0,
        centre: Vec2 = (0.0, 0.0),
        azimuths: tuple[float, float] = (0.0, 360.0),
        sides: int = 12,
    ) -> None:
        """Close the horizon with a ring of backdrops. Land that does not go all around slopes down at its ends.

        Args:
            kind: What the backdrops show.
            radius: Metres from the centre.
            top: Height of their upper edge.
            bottom: Height of their lower edge.
            centre: Floor point that they surround.
            azimuths: First and last azimuth in degrees; 0 is +Y, counter-clockwise.
            sides: Number of backdrops.
        """
        start, end = azimuths
        runs_out = kind in ("hills", "treeline") and end - start < 360 and sides > 2
        edges: list[tuple[Vec2, float]] = []
        for k in range(sides + 1):
            t = math.radians(start + (end - start) * k / sides)
            share = min(1.0, (min(k, sides - k) + 0.02) / 2) if runs_out else 1.0
            edges.append(((centre[0] - radius * math.sin(t), centre[1] + radius * math.cos(t)), share))
        for (right, low), (left, high) in pairwise(edges):
            tops = [bottom + (top - bottom) * share for share in (high, low)]
            self.card(kind, left, right, bottom, tops[0], right_top=tops[1])

    def finish(self) -> SetPlan:
        """Return the plan as drawn."""
        return SetPlan(
            kit=self.kit,
            indoor=self.indoor,
            size=self.size,
            walls=tuple(self.walls),
            slabs=tuple(self.slabs),
            pieces=tuple(self.pieces),
            backdrops=tuple(self.backdrops),
            furnishings=tuple(self.furnishings),
            lamps=tuple(self.lamps),
            marks=tuple(self.marks),
        )
