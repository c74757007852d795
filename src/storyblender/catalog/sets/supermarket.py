"""Set kit: a supermarket: shelves of goods along the walls and in islands, the checkout in front, flat bright light."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_SHELF = 1.22


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a supermarket: shelf walls, islands of shelves beside a free aisle, the till at the right front."""
    room = Room("supermarket", params, rng, Finishes("plaster_white", "lino_grey", dado="paint_red", dado_height=0.3))
    x, y, h = room.half_x, room.half_y, params.height
    room.door("front", -x * 0.3, width=1.6, height=2.3, style="glass", name="street_door")
    room.door("right", y * 0.55, name="stock_door", tags=("enter", "exit", "door", "staff"))
    room.window("front", x * 0.5, width=2.6, height=1.8, sill=0.6, style="shop", mark=True)
    for index in range(int(2 * (x - 0.3) // _SHELF)):
        at = -x + 0.3 + _SHELF * (index + 0.5)
        room.against("back", "store_shelf", at, 0.25, required=index % 2 == 0, fill=0.94 - 0.04 * (index % 2))
    for index in range(int((2 * y - 3.0) // _SHELF)):
        room.against("left", "store_shelf", y - 1.3 - _SHELF * index, 0.25, required=False)
    for side in (-1, 1):
        for index in range(max(1, int((y - 1.2) // _SHELF))):
            at = y - 2.4 - _SHELF * index
            for turn in (-1, 1):
                room.furnish(
                    "store_shelf", side * 2.35 + 0.24 * turn, at, yaw=90.0 * turn, required=index == 0,
                    height=1.3, rows=3.0,
                )  # fmt: skip
    room.furnish("counter", x - 1.3, -y + 1.7, yaw=90, material="enamel")
    room.furnish("cash_register", x - 1.3, -y + 1.5, 0.96, 90, required=False)
    room.mark("till", x - 0.7, -y + 1.7, 270, "bar", "counter", "staff")
    room.mark("counter", x - 2.2, -y + 1.7, 90, "bar", "counter")
    room.mark("aisle", 0, y - 1.4, 180, "table", "shelf")
    room.furnish("shopping_cart", -x + 1.4, -y + 0.8, yaw=90, required=False)
    room.furnish("crate", -x + 1.3, y * 0.05 - 2.2, required=False, height=0.5)
    for at, style in ((-y + 0.75, "picture"), (-y + 2.65, "notice_board")):
        room.on_wall("right", style, at, 1.5)
    room.against("front", "store_shelf", x - 0.75, 0.25, required=False, height=1.3, rows=3.0)
    room.furnish("basket", x - 2.35, -y + 0.45, required=False)
    room.against("right", "fridge", -y * 0.08, 0.36, required=False)
    room.against("right", "fridge", -y * 0.08 + 0.75, 0.36, required=False)
    room.on_wall("right", "wall_clock", y * 0.3, 2.2)
    for px in (-x * 0.6, 0.0, x * 0.6):
        for py in (-y * 0.5, y * 0.35):
            room.piece("ceiling_light", px, py, h, modern=True)
            room.lamp("ceiling_light", (px, py, h - 0.12), 26, COOL, kind="AREA", size=0.9)
    return room.finish()


KIT = SetKit(
    key="supermarket", name="Supermarket",
    tags=("supermarket", "grocery store", "convenience store", "minimart", "mini mart", "mall"), indoor=True,
    draw=draw, width=Span(9.0, 9.6, 14.0), depth=Span(7.6, 8.4, 12.0), height=Span(2.9, 3.2, 4.0), period="modern",
    means={"cart": "shopping_cart", "pram": "shopping_cart", "bookshelf": "store_shelf", "jewel_box": "cardboard_box"},
)  # fmt: skip
