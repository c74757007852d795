"""Set kit: a warehouse: brick and steel, high windows, stacks of crates and barrels, lamps on long cords."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a warehouse: stacks along the walls, columns at the quarter points, the middle free."""
    past = params.period == "past"
    look = Finishes(
        "boards_grey" if past else "brick_brown", "boards_grey" if past else "concrete", "ceiling_dark", beams=6
    )
    room = Room("warehouse", params, rng, look, view="skyline", thickness=0.3)
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.35, width=2.6, height=2.9, style="double", name="gate")
    room.door("left", -y * 0.55, style="panel")
    for at in (-x * 0.55, 0.0, x * 0.55):
        room.window("back", at, width=2.0, height=1.1, sill=h - 1.75, style="grid")
    room.window("left", y * 0.2, width=2.0, height=1.1, sill=h - 1.75, style="grid")
    for px in (-x * 0.52, x * 0.52):
        for py in (-y * 0.5, y * 0.45):
            room.piece(
                "column", px, py, footprint=(0.35, 0.35), height=h, width=0.28,
                material="wood_dark" if past else "iron", style="post" if past else "girder",
            )  # fmt: skip
    for index in range(7):
        cx = -x + 0.75 + index * (2 * x - 1.5) / 6
        size = room.between(0.75, 1.0)
        room.furnish(
            "crate",
            cx,
            y - 0.7,
            yaw=room.between(-12, 12),
            required=index % 3 == 0,
            width=size,
            depth=size,
            height=size,
        )
        if index % 2:
            room.furnish(
                "crate",
                cx + 0.05,
                y - 0.7,
                size,
                room.between(-25, 25),
                required=False,
                width=0.6,
                depth=0.6,
                height=0.6,
            )
    for index in range(3):
        room.furnish("barrel", x - 0.55, y - 1.7 - 0.72 * index, required=False)
    room.furnish("cart" if past else "barrel", x - 1.3, -y + (1.6 if past else 0.9), required=False)
    room.furnish("crate", -x + 0.9, -y + 0.9, yaw=20, required=False, width=0.9, depth=0.9, height=0.9)
    for at in (-0.1, 0.45):  # pallets of goods on shelves down the left wall
        room.piece("stock_shelf", *room.spot("left", y * at, 0.0), 0.0, 90, length=y * 0.5, height=2.6, kind="parcels",
                   color="#5c5f63", seed=3.0 + at)  # fmt: skip
    room.on_wall("right", "wall_clock", y * 0.75, 2.4)
    room.mark("stack", -x * 0.4, y - 1.7, 0, "table", "crates")
    if not past:
        room.piece("pipes", 0, y - 0.15, h - 0.45, length=2 * x - 0.4)
    for px, py in ((0, 0), (-x * 0.5, -y * 0.1), (x * 0.5, -y * 0.1), (0, y * 0.55)):
        room.hang("lantern" if past else "pendant_lamp", px, py)
    return room.finish()


KIT = SetKit(
    key="warehouse", means={"jewel_box": "cardboard_box"}, name="Warehouse",
    tags=("warehouse", "factory", "hangar", "depot", "storage", "storeroom"), indoor=True, room="work", draw=draw,
    width=Span(9.0, 11.0, 18.0), depth=Span(8.0, 10.0, 16.0), height=Span(3.8, 4.8, 6.5),
)  # fmt: skip
