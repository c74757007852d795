"""Set kit: a library: shelves to the ceiling on every wall, a reading table with lamps, a tall window."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a library: the book walls and the reading table; the middle stays free."""
    room = Room(
        "library",
        params,
        rng,
        Finishes("paper_green", "parquet", "ceiling_warm", dado="dado_dark", beams=4),
        view="treeline",
    )
    x, y = room.half_x, room.half_y
    room.door("left", -y * 0.55, width=1.2, style="double")
    room.window("back", 0, width=1.5, height=2.0, sill=0.7, style="grid", mark=True)
    room.window("right", -y * 0.5, width=1.3, height=1.9, sill=0.8, style="grid")
    count = int((x - 1.0) // 1.02)
    for index in range(count):
        for side in (-1, 1):
            room.against("back", "bookshelf", side * (1.45 + 1.02 * index), 0.22, required=index == 0)
    for index in range(int((y - 0.2) // 1.02)):
        room.against("left", "bookshelf", y - 1.0 - 1.02 * index, 0.22, required=False)
        room.against("right", "bookshelf", y - 1.0 - 1.02 * index, 0.22, required=False)
    room.furnish("dining_table", -x + 1.7, y - 1.75)
    for px, py, yaw in ((-0.4, 0.75, 0), (0.4, -0.75, 180)):
        room.furnish("chair", -x + 1.7 + px, y - 1.75 + py, yaw=yaw)
    lamp = "candle_holder" if params.period == "past" else "table_lamp"
    room.furnish(lamp, -x + 1.7, y - 1.75, 0.76)
    room.mark("table", -x + 1.7, y - 2.7, 180, "table")
    room.furnish("armchair", x - 1.3, y - 1.3, yaw=-40)
    room.furnish("floor_lamp" if params.period != "past" else "globe", x - 0.65, y - 0.75, required=False)
    room.furnish("globe", -x + 0.6, -y + 0.55, required=False)
    room.furnish("rug", 0, 0, required=False)
    room.hang("chandelier" if params.period != "modern" else "pendant_lamp", 0, 0)
    return room.finish()


KIT = SetKit(
    key="library", name="Library", tags=("library", "reading room", "bookstore", "bookshop"), indoor=True,
    draw=draw, width=Span(7.7, 8.2, 12.0), depth=Span(6.6, 7.2, 10.0), height=Span(2.9, 3.3, 4.2),
)  # fmt: skip
