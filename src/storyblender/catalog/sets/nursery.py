"""Set kit: a nursery: a child's bed and a crib under pale paper, toys on a rug, a rocking chair to read in."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a nursery: the bed at the left of the back wall, the crib at its right, the rug before them free."""
    modern = params.period == "modern"
    look = Finishes("plaster_blue" if modern else "paper_rose", "boards_light", dado="dado_white", dado_height=0.85)
    room = Room("nursery", params, rng, look, view="treeline")
    x, y = room.half_x, room.half_y
    room.door("left", -y * 0.55)
    room.window("right", y * 0.2, width=1.3, style="curtains", mark=True)
    room.window("back", x * 0.1, width=1.1, style="curtains")
    bed = -x + 0.9
    room.against("back", "bed", bed, 0.98, width=1.0, depth=1.8, height=0.9, pillows=1.0, color="#8fa9bd")
    room.mark("bed", bed + 0.95, y - 1.2, 270, "bed")
    room.against("back", "nightstand", bed + 0.82, 0.3)
    room.against("back", "table_lamp", bed + 0.82, 0.3, z=0.58)
    room.furnish("cradle", x - 0.75, y - 0.85, yaw=-20)
    room.furnish("rocking_chair", -x + 0.75, -y * 0.05, yaw=60, required=False)
    room.against("right", "dresser", -y * 0.5, 0.3, required=False, color="#cfc4aa")
    room.against("right", "bookshelf", -y * 0.5 + 1.15, 0.22, required=False, height=1.1, rows=2.0)
    room.furnish("rug", 0.1, 0.1, required=False)
    room.furnish("rocking_horse", x - 1.0, -y + 0.8, yaw=-40, required=False)
    room.furnish("teddy_bear", -x + 0.5, -y * 0.3 - 0.8, yaw=60, required=False)
    room.furnish("ball", x - 1.9, y - 1.0, required=False, color="#b8452f")
    room.furnish("toy_blocks", -x + 0.5, -y + 0.5, yaw=20, required=False)
    room.on_wall("back", "picture", bed, 1.35, width=0.5, height=0.4)
    room.on_wall("left", "picture", y * 0.3, 1.3, width=0.5, height=0.4)
    room.hang("pendant_lamp" if params.period != "past" else "lantern", 0, 0)
    return room.finish()


KIT = SetKit(
    key="nursery", name="Nursery",
    tags=("nursery", "children room", "child bedroom", "child room", "kids room", "girl bedroom", "boy bedroom",
        "playroom", "toy room"),
    indoor=True, room="bedroom", draw=draw, width=Span(6.0, 6.4, 8.0), depth=Span(5.0, 5.4, 7.0),
    means={"bookcase": "bookshelf", "toy": "toy_blocks"}, has=("night light",),
)  # fmt: skip
