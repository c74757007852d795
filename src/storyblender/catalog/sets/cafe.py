"""Set kit: a cafe: bar on the left, tables around a free floor, an arcade before the back of the room, piano."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a cafe: bar, arcade and tables; the middle stays free."""
    modern = params.period == "modern"
    look = (
        Finishes("plaster_teal", "boards_light", "ceiling_white", dado="dado_white")
        if modern
        else Finishes("plaster_ochre", "tile_check", "ceiling_warm", dado="dado_dark", beams=6)
    )
    room = Room("cafe", params, rng, look, view="facades")
    x, y = room.half_x, room.half_y
    room.door("front", 0, width=1.3, height=2.3, style="glass", name="street_door")
    room.door("back", -x * 0.45, name="kitchen_door", tags=("enter", "exit", "door", "kitchen"))
    room.window("front", -x * 0.6, width=2.0, height=1.6, style="shop")
    room.window("front", x * 0.6, width=2.0, height=1.6, style="shop")
    room.window("right", -y * 0.45, width=1.5, height=1.6, style="grid")
    room.window("back", x * 0.42, width=1.5, height=1.5, style="grid", mark=True)
    arcade = y - 2.1
    room.piece(
        "arcade", 0, arcade, width=2 * x, height=params.height, arches=3.0, material=look.wall, trim="paint_cream",
        depth=0.32,
    )  # fmt: skip

    room.against("left", "bar_counter", -0.2, 1.5)
    room.against("left", "back_bar", -0.2, 0.3)
    room.mark("behind_bar", -x + 0.85, -0.2, 90, "bar", "staff", "barista", "bartender", "barman", "cashier")
    room.mark("bar", -x + 2.45, 0.45, 270, "bar")
    for at in (-1.2, -0.45, 0.7):
        room.against("left", "bar_stool", at, 2.1, required=False)

    tables = [
        (x - 1.35, -y * 0.12, 110),
        (0.3, arcade - 0.95, 90),
        (x - 1.35, -y * 0.58, 70),
        (-x * 0.12, -y + 1.5, 80),
    ]
    if x > 5.4:
        tables.append((x - 3.2, -y + 1.4, 20))
    for index, (tx, ty, yaw) in enumerate(tables):
        room.furnish("round_table", tx, ty, required=index < 3, cloth=not modern)
        room.seats_around("chair", tx, ty, 0.66, (yaw, yaw + 180), required=index < 3)
        if index < 4:
            room.furnish(
                "candle_holder" if params.period == "past" else "table_lamp", tx + 0.1, ty + 0.14, 0.75, required=False
            )
    room.mark("table", tables[0][0] - 0.9, tables[0][1] - 0.5, 45, "table")

    if not modern:
        room.against("right", "piano", y - 3.2, 0.65, required=False)
    room.furnish("potted_plant", x - 0.5, y - 0.5, required=False)
    room.furnish("potted_plant", -x + 0.45, arcade - 0.45, required=False)
    room.against("front", "hat_stand", x * 0.25, 0.4, required=False)
    room.on_wall("back", "picture", -0.1, 1.5)
    room.on_wall("right", "picture", -y * 0.02, 1.55)
    lamp = "lantern" if params.period == "past" else "pendant_lamp"
    for px, py in (
        (-x + 1.6, -1.3),
        (-x + 1.6, 0.9),
        (0, -0.2),
        (x - 1.35, -y * 0.58),
        (x - 1.35, -y * 0.08),
        (0, -y + 1.4),
    ):
        room.hang(lamp, px, py)
    room.lamp(
        "bar_shelf",
        (-x + 0.5, -0.2, params.height - 0.6),
        16,
        WARM,
        kind="AREA",
        size=1.6,
        target=(-x + 0.1, -0.2, 1.3),
    )
    room.lamp("back_room", (0, y - 1.0, params.height - 0.25), 32, WARM, kind="AREA", size=1.8)
    return room.finish()


KIT = SetKit(
    key="cafe", name="Cafe",
    tags=("cafe", "café", "restaurant", "bistro", "tea room", "canteen", "cafeteria", "pizzeria", "trattoria",
        "brasserie", "mess hall"),
    indoor=True, room="tavern", draw=draw, width=Span(8.6, 10.0, 13.0), depth=Span(9.4, 9.8, 12.0),
    height=Span(3.2, 3.5, 4.2),
)  # fmt: skip
