"""Set kit: a bedroom: bed with its head to the back wall, nightstands, wardrobe, dressing table, window."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_WALLS = {"past": "paper_blue", "classic": "paper_green", "modern": "plaster_grey"}


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a bedroom: the bed at the left of the back wall, the floor at the right free."""
    room = Room("bedroom", params, rng, Finishes(_WALLS[params.period], "boards"), view="treeline")
    x, y = room.half_x, room.half_y
    wide = x > 3.3
    bed = -x + (1.35 if wide else 0.85)
    room.centre = (x * 0.22, -y * 0.33)
    light = "candle_holder" if params.period == "past" else "table_lamp"
    room.door("left", -y * 0.55)
    room.window("right", y * 0.25, width=1.4, style="curtains", mark=True)
    room.against("back", "bed", bed, 1.12)
    if wide:
        room.against("back", "nightstand", bed - 1.02, 0.3)
        room.window("back", 0.2, width=1.2, style="curtains")
    room.against("back", "nightstand", bed + 1.02, 0.3)
    room.against("back", light, bed + 1.02, 0.3, z=0.56)
    room.against("right", "dressing_table", -y * 0.35, 0.28)
    if wide:
        room.against("right", "stool", -y * 0.35, 0.95, required=False)
    room.on_wall("right", "wall_mirror", -y * 0.35, 1.05)
    room.against("back", "wardrobe", x - 0.75, 0.36)
    room.furnish("rug", bed + 0.4, y - 2.75, required=False)
    room.on_wall("back", "picture", bed, 1.5)
    room.hang("pendant_lamp" if params.period != "past" else "lantern", 0, 0)
    return room.finish()


KIT = SetKit(
    key="bedroom", name="Bedroom", tags=("bedroom", "bed chamber", "bedchamber", "guest room", "dormitory"),
    indoor=True, room="bedroom", draw=draw, width=Span(4.6, 4.8, 9.0), depth=Span(4.4, 4.6, 8.0),
)  # fmt: skip
