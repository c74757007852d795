"""Set kit: a church: pews either side of the aisle, columns, an altar on steps under tall windows."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import CANDLE, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a church: altar at the back, pews from the middle towards the audience, a wide crossing between."""
    room = Room(
        "church",
        params,
        rng,
        Finishes("limewash", "flagstones", "ceiling_dark", beams=7),
        view="treeline",
        thickness=0.5,
    )
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", y * 0.3, width=1.0, height=2.2, style="plank")
    room.door("front", 0, width=1.8, height=2.8, style="double", name="porch")
    for at in (-x * 0.6, 0.0, x * 0.6):
        room.window("back", at, width=1.1, height=3.0, sill=1.7, style="stained")
    for at in (-y * 0.55, y * 0.05, y * 0.62):
        room.window("right", at, width=1.0, height=2.6, sill=1.7, style="arched")
    for step in range(2):
        room.slab(
            "block", rectangle(-x + 0.02, y - 2.9 + 0.4 * step, x - 0.02, y - 0.02), "stone_light",
            z=0.03 * (step + 1), thickness=0.03,
        )  # fmt: skip
    room.furnish("altar", 0, y - 1.2, 0.06)
    for px in (-0.7, 0.7):
        room.furnish("candle_holder", px, y - 1.2, 0.06 + 1.02, required=False)
    room.mark("altar", 0, y - 2.2, 0, "altar", "bar", "priest", "reverend", "vicar", "pastor", "bishop")
    rows = max(1, int((2 * y - 5.2) // 1.15))
    for row in range(rows):
        py = -y + 0.9 + 1.15 * row
        beside = abs(py) < 2.0  # the crossing stays free for people: pews beside it are shorter
        for side in (-1, 1):
            left, right = (1.9 if beside else 0.9), x - 0.75
            room.furnish(
                "pew",
                side * (left + right) / 2,
                py,
                yaw=180,
                required=not beside and py < 0,
                width=round(right - left, 2),
            )
    for side in (-1, 1):
        for py in (-y * 0.3, y * 0.35):
            room.piece(
                "column", side * (x - 0.45), py, footprint=(0.6, 0.6), height=h, width=0.45, material="stone_light",
                style="gothic",
            )  # fmt: skip
        room.furnish(
            "floor_lamp" if params.period == "modern" else "candle_holder", side * 2.4, y - 0.7, 0.06, required=False
        )
    for py in (-y * 0.4, y * 0.2):
        room.hang("chandelier", 0, py)
    room.lamp("altar_light", (0, y - 1.9, h - 0.8), 45, CANDLE, kind="AREA", size=1.5, target=(0, y - 0.8, 1.0))
    return room.finish()


KIT = SetKit(
    key="church", means={"bench": "pew"}, name="Church",
    tags=("church", "chapel", "cathedral", "monastery", "abbey", "synagogue", "mosque", "sanctuary", "funeral home"),
    indoor=True, draw=draw, width=Span(8.0, 9.0, 14.0), depth=Span(12.0, 13.5, 20.0), height=Span(4.8, 5.6, 8.0),
    period="past",
)  # fmt: skip
