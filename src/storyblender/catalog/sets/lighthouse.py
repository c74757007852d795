"""Set kit: the lamp room of a lighthouse: the great lens on its iron drum, windows to the sea."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a lighthouse's lamp room: the lens at the back, the keeper's things along the sides, the middle free."""
    finishes = Finishes("limewash", "boards", "boards_dark", beams=4, outside="water_deep")
    room = Room("lighthouse", params, rng, finishes, view="sea", thickness=0.3)
    x, y = room.half_x, room.half_y
    for at in (-x * 0.62, 0.0, x * 0.62):
        room.window("back", at, width=1.5, height=1.9, sill=0.8, style="grid", mark=at == 0.0)
    room.window("right", y * 0.58, width=1.4, height=1.9, sill=0.8, style="grid", mark=True)
    room.window("left", y * 0.55, width=1.4, height=1.9, sill=0.8, style="grid")
    room.door("left", -y * 0.4, style="plank")
    room.piece("great_lens", 0.0, y - 1.1, footprint=(1.3, 1.3))
    room.furnish("dining_table", -x + 0.75, y * 0.3, yaw=90)
    room.furnish("table_lamp" if params.period == "modern" else "lantern", -x + 0.7, y * 0.3 + 0.5, 0.75)
    room.furnish("chair", -x + 0.75, y * 0.3 - 1.25, yaw=180, required=False)
    _stairs(room)
    room.against("right", "bench", y * 0.62, 0.3)
    room.mark("bench", x - 0.9, y * 0.62, 270, "bench")
    room.against("front", "chest", x * 0.25, 0.35, required=False)
    room.furnish("barrel", -x + 0.5, -y + 0.5, required=False)
    room.furnish("rope", -x + 1.1, -y + 0.45, required=False)
    room.hang("lantern", -x * 0.3, -y * 0.2)
    return room.finish()


def _stairs(room: Room) -> None:
    """Lead iron stairs from the front up along the right wall."""
    run, wide = 3.7, 0.9
    foot = -room.half_y + 0.4
    room.piece(
        "stairs", room.half_x - 0.06 - wide / 2, foot + run / 2, 0.0, 90.0, footprint=(run, wide), width=wide, run=run,
        height=room.height, material="metal_grey", iron=True, hatch=True,
    )  # fmt: skip
    room.mark("stairs", room.half_x - 1.4, foot + 0.3, 270, "stairs", "enter", "exit")


KIT = SetKit(
    key="lighthouse", name="Lamp room of a lighthouse",
    tags=("lamp room", "light house", "lantern room", "light tower", "beacon"), indoor=True, draw=draw,
    width=Span(6.6, 7.4, 10.0), depth=Span(6.4, 7.0, 9.0), height=Span(2.9, 3.2, 4.0), period="past",
)  # fmt: skip
