"""Set kit: a bar: long counter along the back wall under bottles, booths on the left, small tables, low warm light."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a bar: the counter across the back with its stools, booths at the left wall, the middle free."""
    past = params.period == "past"
    look = (
        Finishes("log_wall", "boards_dark", "ceiling_dark", beams=5)
        if past
        else Finishes("plaster_red", "boards_dark", "ceiling_dark", dado="dado_dark", dado_height=1.2)
    )
    room = Room("bar", params, rng, look, view="facades")
    x, y = room.half_x, room.half_y
    room.door("right", -y * 0.45, width=1.1, height=2.2, style="double" if past else "glass", name="street_door")
    room.door("left", y - 0.9, name="back_door", tags=("enter", "exit", "door"))
    room.window("front", -x * 0.4, width=2.2, height=1.5, style="shop")
    room.window("right", y * 0.12, width=1.3, height=1.4, style="grid", mark=True)
    for at in (-1.55, 1.55):
        room.against("back", "back_bar", at, 0.28)
        room.against("back", "bar_counter", at, 1.5)
    for at in (-2.3, -1.45, -0.6, 0.6, 1.45, 2.3):
        stool, height = ("stool", 0.72) if past else ("bar_stool", 0.76)
        room.against("back", stool, at, 2.15, required=abs(at) < 2, height=height)
    room.mark("behind_bar", 0.4, y - 0.85, 0, "bar", "staff", "bartender", "barman", "barmaid", "barkeep", "innkeeper")
    room.mark("bar", 0.0, y - 2.25, 180, "bar")
    for at in (-y * 0.45, 0.3):
        room.against("left", "round_table", at, 1.0)
        bx, by = room.spot("left", at, 1.0)
        room.seats_around("chair", bx, by, 0.68, (0, 180), required=False)
        room.furnish("candle_holder" if past else "table_lamp", bx, by + 0.08, 0.75, required=False)
    room.mark("table", -x + 1.9, -y * 0.3, 270, "table")
    room.furnish("round_table", x - 1.2, -y + 1.15, required=False)
    room.seats_around("chair", x - 1.2, -y + 1.15, 0.68, (70, 250), required=False)
    if past:
        room.furnish("barrel", x - 0.5, y - 0.6, required=False)
        room.against("right", "piano", -y * 0.12 + 0.9, 0.65, required=False)
    else:
        room.on_wall("right", "neon_sign", 1.6, 1.75, off=0.1)
    room.on_wall("left", "picture", -y * 0.1, 1.5)
    room.on_wall("left", "wall_mirror", -y * 0.6, 1.5)
    lamp = "lantern" if past else "pendant_lamp"
    for px in (-2.0, 0.0, 2.0):
        room.hang(lamp, px, y - 1.5)
    for px, py in ((-x + 1.0, -y * 0.45), (-x + 1.0, 0.3), (x * 0.45, -y * 0.35)):
        room.hang(lamp, px, py)
    room.lamp(
        "bar_shelf", (0, y - 0.55, params.height - 0.4), 22, WARM, kind="AREA", size=2.4, target=(0, y - 0.1, 1.3)
    )
    return room.finish()


KIT = SetKit(
    key="bar", name="Bar",
    tags=("bar", "saloon", "pub", "tavern", "inn", "speakeasy", "cantina", "lounge bar", "casino", "wine cellar",
        "jazz club"),
    indoor=True, room="tavern", draw=draw, width=Span(8.0, 9.0, 12.0), depth=Span(7.4, 8.2, 11.0),
    height=Span(2.9, 3.2, 4.0),
)  # fmt: skip
