"""Set kit: a barn or stable: board walls, posts with stalls between them, hay, a lantern, a wide door to the yard."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a barn: stalls along the back and hay at both sides; the threshing floor stays free."""
    room = Room("barn", params, rng, Finishes("dado_brown", "dust", "boards_dark", beams=6), view="treeline")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.3, width=2.6, height=2.8, style="double", name="gate")
    room.door("left", -y * 0.55, style="plank")
    room.window("left", y * 0.3, width=1.0, height=0.8, sill=h - 1.4, style="grid")
    room.window("back", 0.0, width=1.0, height=0.8, sill=h - 1.4, style="grid")
    for index in range(4):
        px = -x + 1.4 + index * (2 * x - 2.8) / 3
        room.piece(
            "column", px, y - 2.4, footprint=(0.3, 0.3), height=h, width=0.22, material="wood_dark", style="post"
        )
        room.piece("fence", px, y - 1.25, 0.0, 90.0, width=2.2, style="rail", footprint=(0.15, 2.2))
    for index, px in enumerate((-x * 0.62, 0.0, x * 0.62)):
        room.furnish("hay_bale", px, y - 0.6, yaw=room.between(-8, 8), required=index == 0)
    room.furnish("hay_bale", -x + 0.8, y * 0.1, yaw=90, required=False)
    room.furnish("hay_bale", -x + 0.85, y * 0.1 - 1.3, yaw=80, required=False)
    room.furnish("trough", x - 0.6, y * 0.25, yaw=-90, required=False)
    room.furnish("wheelbarrow", x - 1.2, -y + 1.1, yaw=-30, required=False)
    room.furnish("barrel", -x + 0.55, -y + 0.6, required=False)
    room.mark("stalls", -x * 0.3, y - 3.1, 180, "stall", "horse")
    for px, py in ((-x * 0.4, -y * 0.1), (x * 0.4, -y * 0.1)):
        room.hang("lantern" if params.period != "modern" else "pendant_lamp", px, py)
    return room.finish()


KIT = SetKit(
    key="barn", name="Barn", tags=("barn", "cowshed", "granary", "pigsty"), indoor=True, room="farm", draw=draw,
    width=Span(8.0, 9.0, 15.0), depth=Span(7.6, 8.4, 13.0), height=Span(3.4, 4.0, 5.5),
)  # fmt: skip
