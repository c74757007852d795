"""Set kit: the kitchen of a restaurant: ranges under an extractor, steel counters, the pass under its lamps, tiles."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a restaurant kitchen: ranges at the back, a counter down either side, the middle free."""
    look = Finishes("wall_tile", "tile_terracotta", "ceiling_white", dado="paint_grey", dado_height=0.25)
    room = Room("restaurant_kitchen", params, rng, look, view="none")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", -y * 0.5, width=1.4, height=2.1, style="double")
    room.door("right", -y * 0.62, name="yard", style="glass")
    wide = round(2 * x - 3.4, 2)
    room.piece("steel_counter", -0.2, y - 0.42, footprint=(wide, 0.8), length=wide, range=True)
    room.piece("extractor", -0.2, y - 0.5, 1.98, length=wide, duct=round(h - 2.4, 2))
    room.mark("stove", -0.2, y - 1.3, 180, "stove", "chef", "cook")
    long = round(2 * y - 2.9, 2)
    room.piece("steel_counter", x - 0.42, 0.55, 0, -90, footprint=(long, 0.8), length=long)
    room.mark("counter", x - 1.3, 0.55, 270, "table", "counter", "dishwasher")
    passing = round(min(2 * y - 4.4, 3.0), 2)
    room.piece("steel_counter", -x + 0.42, y * 0.38, 0, 90, footprint=(passing, 0.8), length=passing, **{"pass": True})
    room.mark("pass", -x + 1.35, y * 0.38, 90, "bar", "pass", "waiter", "waitress")
    room.against("back", "fridge", x - 0.62, 0.4)
    room.against("back", "sink", -x + 0.8, 0.35)
    room.against("front", "store_shelf", -x * 0.35, 0.45, required=False)
    room.against("front", "crate", x * 0.45, 0.5, required=False)
    room.furnish("sack", x * 0.45 + 0.9, -y + 0.5, yaw=20, required=False)
    room.on_wall("left", "wall_clock", -y * 0.05, 2.1)
    for px in (-x * 0.45, x * 0.45):
        for py in (-y * 0.4, y * 0.25):
            room.piece("ceiling_light", px, py, h, modern=True)
            room.lamp("ceiling_light", (px, py, h - 0.12), 30, COOL, kind="AREA", size=0.9)
    room.lamp("extractor", (-0.2, y - 0.55, 1.9), 14, WARM, kind="AREA", size=1.0)
    room.lamp("pass", (-x + 0.6, y * 0.38, 1.5), 10, WARM, kind="AREA", size=0.6, target=(-x + 1.4, y * 0.38, 0.9))
    return room.finish()


KIT = SetKit(
    key="restaurant_kitchen", name="Restaurant kitchen",
    tags=("restaurant kitchen", "hotel kitchen", "restaurant galley", "diner kitchen", "commercial kitchen",
        "cafe kitchen", "palace kitchen", "school kitchen", "prison kitchen"),
    indoor=True, draw=draw, width=Span(7.4, 8.2, 12.0), depth=Span(6.8, 7.2, 10.0), height=Span(2.8, 3.0, 3.6),
    period="modern", has=("stove", "range", "oven", "counter", "pass", "hood", "burner", "grill"),
)  # fmt: skip
