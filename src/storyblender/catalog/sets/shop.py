"""Set kit: a shop: counter with till on the left, shelves along the walls, show windows to the street."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a shop: the counter, the shelves and the street door; the shop floor stays free."""
    modern = params.period == "modern"
    look = (
        Finishes("plaster_white", "lino_grey")
        if modern
        else Finishes("paper_green", "boards", "ceiling_warm", dado="dado_brown", dado_height=1.0)
    )
    room = Room("shop", params, rng, look, view="facades")
    x, y = room.half_x, room.half_y
    room.door("right", -y * 0.4, width=1.0, height=2.2, style="glass", name="street_door")
    room.door("back", -x * 0.55, name="back_door", tags=("enter", "exit", "door", "staff"))
    room.window("right", y * 0.35, width=2.0, height=1.7, sill=0.6, style="shop", mark=True)
    room.window("front", 0, width=2.6, height=1.7, sill=0.6, style="shop")
    room.against("left", "counter", -1.15, 1.5)
    room.against("left", "counter", 0.67, 1.5)
    room.mark("behind_counter", -x + 0.8, -0.2, 90, "bar", "counter", "staff")
    room.mark("counter", -x + 2.3, -0.2, 270, "bar", "counter")
    wood = "enamel" if modern else "wood"
    for at in (-1.44, -0.2, 1.04):
        room.against("left", "store_shelf", at, 0.25, required=at == -0.2, material=wood, fill=0.9)
    for at in (0.1, 1.34, 2.58):
        if at < x - 1.5:
            room.against("back", "store_shelf", at, 0.25, required=False, material=wood)
    room.furnish("barrel", x - 0.55, y - 0.55, required=False)
    room.furnish("crate", x - 1.2, y - 0.5, required=False)
    room.on_wall("back", "wall_clock", -0.6, 2.1)
    lamp = "lantern" if params.period == "past" else "pendant_lamp"
    for px, py in ((-x + 1.4, -0.3), (0.2, 0.5), (x * 0.5, -y * 0.45)):
        room.hang(lamp, px, py)
    room.lamp("shelf_light", (-x + 0.8, 0, params.height - 0.3), 20, WARM, kind="AREA", size=2.0, target=(-x, 0, 1.2))
    return room.finish()


KIT = SetKit(
    key="shop", name="Shop", tags=("shop", "store", "grocery", "general store", "pawn shop", "butcher", "showroom"),
    indoor=True, room="shop", draw=draw, width=Span(7.0, 7.6, 11.0), depth=Span(5.6, 6.4, 9.0),
    height=Span(2.8, 3.1, 3.8), means={"bookshelf": "store_shelf", "jewel_box": "cardboard_box"},
)  # fmt: skip
