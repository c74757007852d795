"""Set kit: a kitchen: a run of counters with sink and stove along the back wall, fridge, a table to eat at."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a kitchen: the counter run, the table at the right wall, the middle free."""
    past = params.period == "past"
    look = (
        Finishes("limewash", "flagstones", "ceiling_dark", beams=4)
        if past
        else Finishes("plaster_cream", "tile_green", dado="wall_tile", dado_height=1.45)
    )
    room = Room("kitchen", params, rng, look, view="treeline")
    x, y = room.half_x, room.half_y
    room.door("left", -y * 0.3)
    room.window("back", -0.2, width=1.5, height=1.1, sill=1.15, style="curtains", mark=False)
    room.mark("sink", -0.2, y - 0.95, 180, "sink", "window")
    room.against("back", "cabinet" if past else "fridge", -x + (0.6 if past else 0.42), 0.4)
    start = -x + (1.17 if past else 0.85)
    left = -0.7 - start
    room.against("back", "counter", start + left / 2, 0.34, width=round(left, 2))
    room.against("back", "sink", -0.2, 0.33, width=1.0)
    room.against("back", "stove", 0.75, 0.36)
    room.against("back", "counter", (1.2 + x - 0.05) / 2, 0.34, required=False, width=round(x - 1.25, 2))
    room.mark("stove", 0.75, y - 0.95, 180, "stove")
    table_x, table_y = x - 0.47, -y * 0.33
    room.furnish("dining_table", table_x, table_y, yaw=90, width=1.3, depth=0.8)
    for dy, yaw in ((-0.95, 180), (0.95, 0)):
        room.furnish("chair", table_x, table_y + dy, yaw=yaw)
    if x > 2.9:
        room.furnish("chair", table_x - 0.66, table_y, yaw=90, required=False)
    room.against("left", "cabinet", y * 0.3, 0.3, required=False)
    room.on_wall("right", "picture", table_y, 1.45)
    room.on_wall("left", "wall_clock", y * 0.3, 1.95)
    room.hang("lantern" if past else "pendant_lamp", table_x, table_y)
    room.hang("lantern" if past else "pendant_lamp", 0, y * 0.3)
    return room.finish()


KIT = SetKit(
    key="kitchen", name="Kitchen", tags=("kitchen", "scullery", "pantry", "galley"), indoor=True, room="kitchen",
    draw=draw, width=Span(4.4, 4.6, 9.0), depth=Span(4.0, 4.2, 8.0),
)  # fmt: skip
