"""Set kit: a living room: sofa and armchairs around a low table, fireplace or television, window, floor lamp."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_WALLS = {"past": "paper_green", "classic": "paper_rose", "modern": "plaster_blue"}


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a living room: seats at the left, the hearth or the screen at the right, the floor before them free."""
    period = params.period
    floor = "parquet" if period != "modern" else "boards_light"
    room = Room("living_room", params, rng, Finishes(_WALLS[period], floor), view="treeline")
    x, y = room.half_x, room.half_y
    room.centre = (0.0, -y * 0.2)
    room.door("left", -y * 0.5)
    room.window("back", -x * 0.32, width=1.7, style="curtains", mark=True)
    room.window("right", y * 0.45, width=1.1, style="curtains")
    room.furnish("rug", -x * 0.1, y * 0.35, required=False)
    room.furnish("sofa", -x * 0.32, y - 0.6)
    room.furnish("coffee_table", -x * 0.32, y - 1.4, width=1.0, depth=0.5)
    room.furnish("armchair", -x + 0.5, y - 1.65, yaw=90)
    if period == "modern":
        room.against("right", "cabinet", -y * 0.25, 0.35)
        room.against("right", "television", -y * 0.25, 0.35, z=0.9, required=False)
    else:
        room.against("right", "fireplace", -y * 0.25, 0.28)
        room.on_wall("right", "wall_mirror", -y * 0.25, 1.45)
    room.furnish("armchair", x - (1.4 if x > 3.2 else 0.9), y - 0.9, yaw=-25)
    room.furnish("floor_lamp", x * 0.35, y - 0.4)
    room.against("left", "bookshelf", -y * 0.07, 0.24, required=False)
    room.against("left", "radio" if period == "classic" else "potted_plant", -y + 0.5, 0.4, required=False)
    if x > 3.2:
        room.furnish("potted_plant", x - 0.4, y - 0.4, required=False)
    room.on_wall("back", "picture", x * 0.3, 1.4)
    room.on_wall("left", "picture", y * 0.55, 1.4)
    room.hang("pendant_lamp" if period != "past" else "chandelier", 0, 0)
    return room.finish()


KIT = SetKit(
    key="living_room", name="Living room",
    tags=("living room", "lounge", "sitting room", "parlour", "parlor", "drawing room", "family room", "den", "salon"),
    indoor=True, room="home", draw=draw, width=Span(5.0, 5.2, 11.0), depth=Span(5.0, 5.2, 9.0),
)  # fmt: skip
