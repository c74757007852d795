"""Set kit: a corridor running away from the audience: doors on both sides, ceiling lights, a window at its end."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_LOOKS = {
    "past": Finishes("stone", "flagstones", "ceiling_dark", beams=6),
    "classic": Finishes("plaster_cream", "tile_check", "ceiling_white", dado="dado_brown", dado_height=1.1),
    "modern": Finishes("plaster_grey", "lino_grey", "ceiling_white", dado="plaster_blue", dado_height=1.2),
}


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a corridor: doors every three metres and a light between each pair."""
    if params.option("space"):
        return _aboard(params, rng)
    room = Room("corridor", params, rng, _LOOKS[params.period], view="facades")
    y, past = room.half_y, params.period == "past"
    style = "panel" if params.period != "modern" else "glass"
    count = max(2, int(params.depth // 3.2))
    for index in range(count):
        at = -y + params.depth * (index + 0.5) / count
        room.door("left", at, style=style, name="left_door")
        room.door("right", at + (0.6 if index < count - 1 else -0.6), style=style, name="right_door")
    room.window("back", 0, width=1.1, height=1.5, sill=0.9, style="grid", mark=True)
    for index in range(count + 1):
        at = -y + params.depth * (index + 0.5) / (count + 1)
        if past:
            room.hang("lantern", 0, at)
        else:
            room.piece("ceiling_light", 0, at, params.height, modern=params.period == "modern")
            room.lamp(
                "ceiling_light",
                (0, at, params.height - 0.16),
                26,
                COOL if params.period == "modern" else WARM,
                kind="AREA",
                size=0.5,
            )
    for index in range(count - 1):  # between the doors of each side
        left, right = -y + params.depth * (index + 1) / count, -y + params.depth * (index + 1.5) / count - 0.75
        if params.period == "modern":
            room.piece(
                "poster", *room.spot("left", left + 0.9, 0.0), 1.2, 90, width=0.55, height=0.8, variant=float(index)
            )
        else:
            room.on_wall("left", "picture", left + 0.85, 1.45, width=0.6, height=0.75)
        room.on_wall("right", "picture", right, 1.5, width=0.7, height=0.5)
    room.piece("peg_rail", *room.spot("right", -y + 0.75, 0.0), 1.65, 270, length=0.9)
    room.against("left", "bench", -y + params.depth / count, 0.32, required=False)
    room.furnish("potted_plant", room.half_x - 0.42, y - 0.42, required=False)
    room.on_wall("right", "picture", -y + params.depth * 0.5 / count - 0.6, 1.5)
    room.mark("far_end", 0, y - 0.9, 0, "enter", "exit", "back")
    room.mark("near_end", 0, -y + 0.9, 180, "enter", "exit", "front")
    return room.finish()


def _aboard(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Draw the corridor of a ship in space: ribs with strips of light, sliding doors, the stars at its end."""
    room = Room("corridor", params, rng, Finishes("metal_grey", "concrete_dark", "metal_grey", dado="paint_grey",
                dado_height=0.9), view="none")  # fmt: skip
    x, y, h = room.half_x, room.half_y, params.height
    count = max(3, int(params.depth // 2.4))
    for index in range(count + 1):
        at = -y + 0.2 + (params.depth - 0.4) * index / count
        room.piece("ship_rib", 0, at, width=2 * x, height=h)
        if index < count:
            middle = at + (params.depth - 0.4) / count / 2
            side = "left" if index % 2 else "right"
            room.door(side, middle, width=1.1, style="lift", name="hatch")
            room.lamp("strip", (0, middle, h - 0.12), 18, COOL, kind="AREA", size=0.8)
            room.piece("ceiling_light", 0, middle, h, modern=True)
    room.card("stars", (-x * 0.62, y - 0.02), (x * 0.62, y - 0.02), 0.95, 2.05)
    room.piece("viewscreen", 0, y, 0.95, width=round(1.24 * x, 2), height=1.1)
    room.mark("far_end", 0, y - 0.9, 0, "enter", "exit", "back", "airlock", "window")
    room.mark("near_end", 0, -y + 0.9, 180, "enter", "exit", "front")
    return room.finish()


KIT = SetKit(
    key="corridor", name="Corridor",
    tags=("corridor", "hallway", "hall way", "hall", "passage", "passageway", "tunnel", "vestibule", "entrance hall"),
    indoor=True, draw=draw, width=Span(2.7, 2.9, 4.0), depth=Span(8.0, 12.0, 20.0), height=Span(2.5, 2.8, 3.6),
    options={"space": False},
)  # fmt: skip
