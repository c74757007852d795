"""Set kit: an interrogation room: one table, one hard lamp above it, a dark mirror in the wall."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an interrogation room: the table at the back third under its lamp; the floor before it stays free."""
    look = Finishes("plaster_teal", "concrete_dark", "ceiling_dark", dado="plaster_dark", dado_height=1.25)
    room = Room("interrogation", params, rng, look, view="none")
    x, y = room.half_x, room.half_y
    room.door("right", -y * 0.35, style="panel")
    room.piece("dark_mirror", 0, y - 0.02, 1.05, width=2.2, height=1.0)
    table_y = y - 1.05
    room.furnish("dining_table", 0, table_y)
    room.furnish("chair", -1.15, table_y, yaw=90)
    room.furnish("chair", 1.15, table_y, yaw=-90)
    room.mark("table", 0.9, table_y - 0.8, 200, "table")
    room.mark("wall", -x + 0.6, -y * 0.2, 90, "wall")
    room.against("left", "filing_cabinet", -y * 0.5, 0.34, required=False)
    room.on_wall("left", "wall_clock", y * 0.1, 1.95)
    room.hang("pendant_lamp", 0, table_y, low=1.75)
    room.piece("pipes", -x + 0.12, 0, params.height - 0.35, 90, length=params.depth - 0.2)
    return room.finish()


KIT = SetKit(
    key="interrogation", name="Interrogation room",
    tags=("interrogation room", "interview room", "questioning room", "visiting room", "safe house"), indoor=True,
    draw=draw, width=Span(4.8, 5.2, 8.0), depth=Span(5.6, 5.8, 8.0),
)  # fmt: skip
