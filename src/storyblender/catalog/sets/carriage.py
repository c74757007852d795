"""Set kit: the inside of a vehicle: a long low cabin with benches either side of the aisle and a row of windows."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a carriage: seats along the back wall and at both ends; the aisle and the near side stay free."""
    modern = params.period == "modern"
    look = (
        Finishes("metal_grey", "lino_grey", "ceiling_white", dado="paint_blue", dado_height=0.8)
        if modern
        else Finishes("wood_red", "boards_dark", "paint_cream", dado="dado_dark", dado_height=0.8)
    )
    room = Room("carriage", params, rng, look, view="hills")
    x, y, h = room.half_x, room.half_y, params.height
    for side in ("left", "right"):
        room.door(
            side, 0, width=0.8, height=2.0, style="glass", name=f"{side}_door", tags=("enter", "exit", "door", side)
        )
    bays = max(2, int(2 * x // 1.9))
    for bay in range(bays):
        px = -x + 2 * x * (bay + 0.5) / bays
        room.window("back", px, width=1.25, height=0.9, sill=0.95, style="sash", mark=bay == bays // 2)
        room.window("front", px, width=1.25, height=0.9, sill=0.95, style="sash")
    for bay in range(bays):
        px = -x + 2 * x * (bay + 0.5) / bays
        for side in (-1, 1):
            cloth = "#33506b" if modern else "#6b1d1d"
            room.furnish("carriage_seat", px + side * 0.6, y - 0.62, yaw=-90.0 * side, color=cloth)
        room.mark(f"seat_{bay + 1}", px, y - 1.3, 0, "table", "seat")
    room.piece("luggage_rack", 0, y - 0.25, 1.95, length=2 * x - 0.3)
    for index in range(bays):
        px = -x + 2 * x * (index + 0.5) / bays
        room.piece("ceiling_light", px, 0, h, modern=modern)
        room.lamp("ceiling_light", (px, 0, h - 0.14), 14, WARM, kind="AREA", size=0.4)
    return room.finish()


KIT = SetKit(
    key="carriage", name="Carriage",
    means={"bench": "carriage_seat", "booth": "carriage_seat", "sofa": "carriage_seat"},
    tags=("train", "carriage", "railway carriage", "subway car", "train car", "railway car", "railroad car",
        "dining car", "sleeping car", "metro", "tram", "cabin of"),
    indoor=True, draw=draw, width=Span(5.6, 7.6, 14.0), depth=Span(3.6, 3.8, 4.6), height=Span(2.3, 2.5, 2.8),
)  # fmt: skip
