"""Set kit: a greenhouse: glass on all sides and above, benches of plants, a path between them."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room, Side

_SIDES: tuple[Side, ...] = ("back", "left", "right", "front")


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a greenhouse: glass bays round a free middle, planting before them, the glass roof rising to the ridge."""
    look = Finishes(
        "paint_white", "paving_light", "paint_white", dado="brick_pale", dado_height=0.5, outside="grass_lush"
    )
    room = Room("greenhouse", params, rng, look, view="treeline")
    x, y, h = room.half_x, room.half_y, params.height
    eave = 2.5
    for side in _SIDES:
        long = room.length(side)
        bays = int(long // 1.35)
        for bay in range(bays):
            at = long * ((bay + 0.5) / bays - 0.5)
            if side == "right" and bay == 0:
                room.door("right", at, width=0.95, height=2.1, style="glass")
            else:
                room.window(side, at, width=round(long / bays - 0.14, 3), height=eave - 0.75, sill=0.6, style="grid")
    for side in (-1, 1):
        room.piece("glass_roof", side * x, 0, 0, -90.0 * side, footprint=(2 * y, 0.2), wild=True, length=2 * y,
                   run=x, eave=eave, rise=h - eave)  # fmt: skip
    for index in range(int((2 * x - 1.2) // 1.0)):
        room.furnish("potted_plant", -x + 0.9 + index, y - 0.5, required=index % 2 == 0)
    long = round(2 * y - 2.6, 2)
    room.piece("plant_bench", -x + 0.5, 0.1, 0, 90, footprint=(long, 0.8), length=long, variant=1.0)
    room.piece(
        "plant_bench", x - 0.5, 0.7, 0, -90, footprint=(long - 1.2, 0.8), length=round(long - 1.2, 2), variant=2.0
    )
    for px in (-1.0, 1.0):
        room.slab("patch", rectangle(px - 0.35, y - 1.1, px + 0.35, y - 0.9), "mud", z=0.01)
    room.mark("bench", -x + 1.4, 0.1, 90, "table", "plants", "gardener", "botanist")
    room.furnish("bucket", x - 1.3, -y + 0.7, required=False)
    room.furnish("sack", -x + 0.7, -y + 0.6, required=False)
    room.hang("pendant_lamp", 0, y * 0.3, low=2.4)
    room.hang("pendant_lamp", 0, -y * 0.4, low=2.4)
    return room.finish()


KIT = SetKit(
    key="greenhouse", name="Greenhouse",
    tags=("greenhouse", "glasshouse", "hothouse", "conservatory", "orangery", "winter garden", "palm house",
        "plant nursery", "botanical garden", "hydroponics", "hydroponics bay", "hydroponic farm"),
    indoor=True, draw=draw, width=Span(6.2, 6.8, 10.0), depth=Span(6.6, 7.4, 12.0), height=Span(3.4, 3.7, 4.6),
    has=("flowers", "plants", "bench", "bed", "glass", "vine"),
)  # fmt: skip
