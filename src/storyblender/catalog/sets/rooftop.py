"""Set kit: a rooftop: parapet, chimneys, water tank, the city all around."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a rooftop: the flat roof with its stair house at the left and the skyline on every side."""
    roof = Ground("rooftop", params, rng)
    x, y = roof.half_x, roof.half_y
    roof.slab("ground", rectangle(-x - 3, -y - 9, x + 3, y + 0.6), "gravel", wet=True)
    for node, (px, py, yaw, length) in enumerate(
        ((0.0, y + 0.45, 0.0, 2 * x + 6), (-x - 2.9, -4.0, 90.0, 2 * y + 9), (x + 2.9, -4.0, -90.0, 2 * y + 9))
    ):
        roof.piece("parapet", px, py, yaw=yaw, length=length, height=0.95, material="brick_brown", wild=node > 0)
    roof.piece("stair_house", -x - 1.2, y * 0.15, yaw=90, footprint=(2.6, 2.6))
    roof.lamp("door_lamp", (-x + 0.35, y * 0.15, 2.35), 60, WARM, size=0.1, glow=0.35)
    roof.mark("stair_door", -x + 0.7, y * 0.15, 90, "door", "enter", "exit", "left")
    roof.piece("water_tank", x + 1.2, y - 1.6, footprint=(2.4, 2.4))
    for px, py in ((x - 1.2, y - 0.5), (-x + 2.4, y - 0.4)):
        roof.piece("chimney", px, py, footprint=(0.9, 0.7), height=roof.between(1.6, 2.2))
    roof.piece("vent", x - 0.8, -y * 0.3, footprint=(0.8, 0.8))
    roof.furnish("crate", -x + 0.8, -y * 0.5, yaw=12, required=False)
    roof.furnish("chair", x * 0.4, y - 1.1, yaw=20, required=False)
    roof.mark("edge", 0, y - 0.1, 180, "window", "edge", "bar")
    roof.slab("ground", rectangle(-88, -88, 88, 88), "tarmac", z=-16.0)
    roof.ring("facades", 30, 3, bottom=-16, sides=10)
    roof.ring("facades", 48, 8, bottom=-16, sides=10)
    roof.ring("skyline", 80, 26, bottom=-14)
    roof.entrances(back=False)
    return roof.finish()


KIT = SetKit(
    key="rooftop", name="Rooftop", tags=("rooftop", "roof", "battlements", "ramparts", "fire escape"), indoor=False,
    draw=draw, width=Span(7.0, 9.0, 16.0), depth=Span(6.0, 7.0, 12.0),
)  # fmt: skip
