"""Set kit: outside a ship in space: plates under the feet, handrails, antennas, wings of solar cells, the Earth."""

from __future__ import annotations

import math

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams, rectangle
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span

_FAR = 70.0


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a hull in space: the hull along x, its tower and hatch at the left, the Earth behind it at the right."""
    hull = Ground("space_hull", params, rng)
    x, y = hull.half_x, hull.half_y
    hull.slab("ground", rectangle(-x - 9, -y - 1.2, x + 9, y + 1.2), "hull_plate", thickness=0.4)
    for index in range(-4, 5):
        hull.slab("patch", rectangle(index * 2.2 - 0.02, -y - 1.2, index * 2.2 + 0.02, y + 1.2), "paint_black", z=0.004)
    hull.slab("patch", rectangle(-x - 9, -0.02, x + 9, 0.02), "paint_black", z=0.004)
    for side in (-1, 1):
        hull.piece("hull_rail", 0, side * (y - 0.1), length=2 * x, wild=side < 0)
    hull.piece("hull_module", -x - 3.2, 0.3, yaw=90, footprint=(4.0, 4.0), radius=1.9, length=4.0)
    hull.piece("hull_module", x + 4.0, 1.2, yaw=90, footprint=(3.0, 3.0), radius=1.4, length=5.0)
    hull.mark("hatch", -x + 0.5, 0.3, 90, "hatch", "enter", "exit", "door", "airlock")
    hull.piece("solar_wing", -x * 0.3, y + 8.0, 0.9, length=13.0, width=3.4)
    hull.piece("solar_wing", x + 3.0, y + 8.0, 0.9, length=13.0, width=3.4)
    hull.piece("dish", x - 0.6, y - 0.2, footprint=(0.9, 0.9), radius=0.9)
    hull.piece("planet", 15.0, 40.0, -11.0, radius=22.0)
    hull.slab("ground", rectangle(-200, -200, 200, 200), "void", z=-62.0)
    for index in range(12):
        left, right = (math.radians(30 * index + turn) for turn in (15, -15))
        ends = [(-_FAR * math.sin(t), _FAR * math.cos(t)) for t in (left, right)]
        hull.card("stars", ends[0], ends[1], -62.0, 90.0)
    hull.lamp("work_light", (-x + 0.2, 0.8, 2.6), 60, COOL, kind="AREA", size=0.4, target=(0.0, 0.0, 0.6))
    hull.entrances(back=False)
    return hull.finish()


KIT = SetKit(
    key="space_hull", name="Hull in space",
    tags=("hull", "outer hull", "spacewalk", "space walk", "space", "outer space", "orbit", "deep space", "space hull",
        "outside the ship", "outside the station"),
    indoor=False, draw=draw, width=Span(7.0, 9.0, 14.0), depth=Span(4.0, 4.6, 7.0), period="modern",
    has=("hull", "star", "earth", "planet", "solar panel", "handrail"),
)  # fmt: skip
