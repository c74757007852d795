"""Set kit: a dining room: a long table under a lamp, chairs around it, a dresser, a fireplace, tall windows."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_WALLS = {"past": "plaster_ochre", "classic": "paper_green", "modern": "plaster_cream"}


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a dining room: table along the back, its near side open to the viewer; the floor before it stays free."""
    period = params.period
    look = Finishes(_WALLS[period], "boards" if period == "past" else "parquet", dado="dado_brown", dado_height=0.9)
    room = Room("dining_room", params, rng, look, view="treeline")
    x, y = room.half_x, room.half_y
    room.centre = (0.0, -y * 0.26)
    room.door("left", -y * 0.5)
    room.door("right", -y * 0.6)
    for side in ("left", "right"):
        room.window(side, y * 0.5, width=1.2, height=1.7, sill=0.7, style="curtains")
    table_y = y - 1.5
    long = round(min(2.6, 2 * x - 2.2), 2)
    room.furnish("dining_table", 0.0, table_y, width=long, depth=1.0)
    for px in (-0.7, 0.0, 0.7):
        room.furnish("chair", px, table_y + 0.75, required=px == 0.0)
    room.furnish("chair", -long / 2 - 0.3, table_y, yaw=90)
    room.furnish("chair", long / 2 + 0.3, table_y, yaw=-90)
    room.furnish("candelabra" if period == "past" else "vase", 0.0, table_y, 0.76, required=False)
    room.on_wall("back", "picture", 0.0, 1.5)
    room.against("right", "fireplace", -y * 0.1, 0.28)
    room.on_wall("right", "wall_mirror", -y * 0.1, 1.5)
    room.against("left", "dresser", -y * 0.05, 0.3, required=False)
    room.against("back", "grandfather_clock", x * 0.75, 0.3, required=False)
    room.hang("chandelier" if period != "modern" else "pendant_lamp", 0.0, table_y)
    return room.finish()


KIT = SetKit(
    key="dining_room", name="Dining room", tags=("dining room", "dining hall", "breakfast room"), indoor=True,
    room="home", draw=draw, width=Span(4.6, 5.0, 11.0), depth=Span(5.2, 5.4, 9.0), height=Span(2.6, 3.0, 4.0),
)  # fmt: skip
