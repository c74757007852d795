"""Set kit: a stairwell: a flight up along the back, a landing under a tall window, the next flight, doors of flats."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_LANDING, _DEEP = 1.62, 1.25
"""Metres: height and depth of the landing."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a stairwell: the flights at the back and the right, the floor before them free."""
    modern = params.period == "modern"
    look = (
        Finishes("plaster_grey", "concrete_light", "ceiling_white", dado="paint_blue", dado_height=1.3)
        if modern
        else Finishes("plaster_cream", "tile_check", "ceiling_white", dado="dado_green", dado_height=1.2)
    )
    room = Room("stairwell", params, rng, look, view="facades")
    x, y, h = room.half_x, room.half_y, params.height
    run = 2 * x - 2.6
    tread = "concrete_light" if modern else "boards_dark"
    room.piece("stairs", -x + 1.3 + run / 2, y - 0.62, footprint=(run, 1.2), height=_LANDING, width=1.15,
               run=round(run, 2), material=tread, iron=False)  # fmt: skip
    room.piece("landing", x - _DEEP / 2 - 0.02, y - 0.64, footprint=(_DEEP, 1.25), width=_DEEP, depth=1.25,
               height=_LANDING, material=tread)  # fmt: skip
    up = round(min(2 * y - 2.4, 3.4), 2)
    room.piece("stairs", x - 0.64, y - 1.25 - up / 2, _LANDING, -90, footprint=(up, 1.2), height=round(h - _LANDING, 2),
               width=1.15, run=up, material=tread)  # fmt: skip
    room.window("back", x - 0.75, width=0.9, height=1.4, sill=_LANDING + 0.9, style="grid")
    room.window("left", y * 0.55, width=1.0, height=1.6, sill=1.3, style="grid", mark=True)
    room.door("left", -y * 0.45, name="flat", style="panel")
    room.door("front", -x * 0.3, width=1.1, height=2.2, style="glass", name="street_door")
    room.mark("stairs", -x + 0.8, y - 0.65, 90, "enter", "exit", "stairs", "back")
    room.furnish("bicycle", -x + 0.45, y * 0.05, required=False)
    room.furnish("potted_plant", -x + 0.42, y - 0.42, required=False)
    room.on_wall("left", "notice_board", -y * 0.45 + 1.25, 1.35)
    for px, py in ((-x * 0.25, -y * 0.3), (-x * 0.25, y * 0.45)):
        room.piece("ceiling_light", px, py, h, modern=modern)
        room.lamp("ceiling_light", (px, py, h - 0.3), 34, WARM, kind="AREA", size=0.5)
    return room.finish()


KIT = SetKit(
    key="stairwell", name="Stairwell",
    tags=("stairwell", "staircase", "stairway", "stairs", "landing", "fire stairs", "emergency stairs", "stair hall"),
    indoor=True, draw=draw, width=Span(5.8, 6.2, 9.0), depth=Span(5.8, 6.2, 9.0), height=Span(3.9, 4.2, 5.0),
    has=("stair", "stairs", "step", "banister", "railing", "rail", "handrail", "landing"),
)  # fmt: skip
