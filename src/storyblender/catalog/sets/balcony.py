"""Set kit: a balcony high over a town: tiles, an iron railing, a house wall with a lit glass door."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a balcony: the railing along the back, the house at the left, the town below on every side."""
    place = Ground("balcony", params, rng)
    x, y = place.half_x, place.half_y
    place.slab("block", rectangle(-x - 0.3, -y - 4.0, x + 0.3, y + 0.25), "tile_terracotta", thickness=0.3)
    for px, py, yaw, length in ((0.0, y + 0.12, 0.0, 2 * x + 0.4), (x + 0.2, -2.0, 90.0, 2 * y + 4.0)):
        place.piece("railing", px, py, yaw=yaw, length=length, height=1.05)
    place.piece("house_front", -x - 0.2, 0, 0, 90, width=9.0, color="#b9a88c", door=0.3, footprint=(9.0, 0.3))
    place.mark("door", -x + 0.6, 0.3, 90, "door", "enter", "exit", "left")
    place.mark("railing", 0.4, y - 0.2, 180, "window", "railing", "edge", "bar", "rail", "balustrade")
    place.lamp("door_lamp", (-x + 0.4, 1.1, 2.3), 40, WARM, size=0.1, glow=0.3)
    place.furnish("potted_plant", -x + 0.45, y - 0.45)
    place.furnish("potted_plant", x - 0.4, y - 0.45, required=False)
    place.furnish("round_table", x - 0.75, -y + 0.75, required=False)
    place.furnish("chair", x - 1.45, -y + 0.75, yaw=90, required=False)
    place.slab("ground", rectangle(-88, -88, 88, 88), "tarmac", z=-13.0)
    place.ring("facades", 26, 0.5, bottom=-13, sides=10)
    place.ring("facades", 46, 6, bottom=-13, sides=10)
    place.ring("skyline", 78, 22, bottom=-12)
    place.mark("centre", 0.3, 0.0, 0, "centre")
    place.mark("right", x - 0.6, 0.0, 270, "enter", "exit", "right")
    return place.finish()


KIT = SetKit(
    key="balcony", name="Balcony", tags=("balcony", "hotel balcony"), indoor=False, draw=draw,
    width=Span(6.4, 6.8, 10.0), depth=Span(4.2, 4.4, 6.0),
    has=("railing", "rail", "balustrade", "door", "balcony", "glass door"),
)  # fmt: skip
