"""Set kit: a desert: dunes, rocks, dry brush, mesas on the horizon."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a desert: sand with rocks to the sides and mesas far off."""
    desert = Ground("desert", params, rng)
    x, y = desert.half_x, desert.half_y
    desert.land("sand_desert", relief=3.2, rise=0.03, flat=max(x, y) + 1)
    desert.scatter(
        ("rock",), 22, inner=max(x, y) - 0.5, outer=34, gap=2.4, scale=(0.5, 2.2), sector=(-115, 115), solid=0.9
    )
    desert.scatter(("cactus",), 12, inner=max(x, y) + 1, outer=36, gap=4, scale=(0.7, 1.3), sector=(-110, 110))
    desert.scatter(("dry_bush", "rock"), 60, inner=3.2, outer=26, gap=1.6, scale=(0.5, 1.1))
    desert.furnish("rock", -x * 0.6, y * 0.5, required=False)
    desert.furnish("cactus", x * 0.55, y * 0.75, required=False)
    desert.furnish("skull", x * 0.3, y * 0.55, yaw=30, required=False, width=0.34, depth=0.4, height=0.34)
    for at, wide, tall in ((-30.0, 18.0, 16.0), (24.0, 14.0, 13.0), (48.0, 20.0, 18.0)):  # mesas
        desert.piece("cliff", at, 58.0 - 0.2 * abs(at), -1.0, -0.4 * at, width=wide, height=tall, seed=wide)
    desert.mark("rock", -x * 0.6 + 0.9, y * 0.3, 0, "table", "seat")
    desert.ring("hills", 86, 17, sides=14)
    desert.entrances()
    return desert.finish()


KIT = SetKit(
    key="desert", name="Desert", tags=("desert", "dunes", "wasteland", "canyon", "badlands", "oasis"), indoor=False,
    draw=draw, width=Span(9.0, 12.0, 24.0), depth=Span(7.0, 9.0, 18.0),
)  # fmt: skip
