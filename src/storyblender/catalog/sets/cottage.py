"""Set kit: a cottage: one timbered room with a hearth, a table, a bed in the corner, small windows to the trees."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a cottage: hearth at the back, table left, bed right; the floor before the hearth stays free."""
    log = bool(params.option("log"))
    room = Room(
        "cottage",
        params,
        rng,
        Finishes("log_wall" if log else "limewash", "boards", "boards_dark", beams=5, outside="grass"),
        view="treeline",
        thickness=0.25,
    )
    x, y, lamp = room.half_x, room.half_y, "pendant_lamp" if params.period == "modern" else "lantern"
    room.door("left", -y * 0.4, style="plank")
    room.window("left", y * 0.35, width=1.0, height=1.0, sill=1.0, style="grid", mark=True)
    room.window("back", x * 0.55, width=1.0, height=1.0, sill=1.0, style="grid")
    room.window("right", -y * 0.35, width=1.0, height=1.0, sill=1.0, style="grid")
    room.against("back", "fireplace", -x * 0.1, 0.3)
    room.mark("hearth", -x * 0.1 + 0.2, y - 1.2, 180, "fireplace")
    room.furnish("armchair", -x * 0.1 + 1.3, y - 0.95, yaw=-60, required=False)
    room.furnish("dining_table", -x + 1.15, y - 1.25, yaw=90)
    room.furnish("chair", -x + 1.9, y - 1.0, yaw=-90)
    room.furnish("stool", -x + 1.15, y - 2.5, yaw=180, required=False)
    room.furnish(
        "candle_holder" if params.period != "modern" else "table_lamp", -x + 1.15, y - 1.2, 0.76, required=False
    )
    room.against("right", "bed", y - 0.85, 1.1)
    room.mark("bed", x - 1.9, y - 1.5, 270, "bed")
    room.furnish("chest", x - 0.55, -y * 0.0 - 0.35, yaw=-90, required=False)
    room.furnish("barrel", -x + 0.5, -y + 0.5, required=False)
    room.against("left", "cabinet", -y + 1.6, 0.28, required=False)
    room.furnish("rug", 0, 0, required=False)
    room.hang(lamp, 0.2, 0.2)
    return room.finish()


KIT = SetKit(
    key="cottage", name="Cottage", tags=("cottage", "hut", "cabin", "log cabin", "farmhouse", "farm house", "lodge"),
    indoor=True, room="rustic", draw=draw, width=Span(7.4, 7.6, 10.0), depth=Span(6.0, 6.4, 8.0),
    height=Span(2.4, 2.6, 3.2), period="past", options={"log": False},
)  # fmt: skip
