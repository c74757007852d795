"""Set kit: the cabin of a bus or an aeroplane: rows of seats on both sides of an aisle."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_PITCH = 0.98
"""Metres from row to row."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a coach: the seats facing the front, windows along both sides, racks or bins over them."""
    air = bool(params.option("air"))
    look = (
        Finishes("plaster_white", "carpet", "ceiling_white", dado="paint_grey", dado_height=0.5)
        if air
        else Finishes("paint_cream", "lino_grey", "ceiling_white", dado="paint_blue", dado_height=0.8)
    )
    room = Room("coach", params, rng, look, view="hills" if air else "facades")
    x, y, h = room.half_x, room.half_y, params.height
    rows = max(3, int((2 * y - 2.2) // _PITCH))
    wide, tall, sill = (0.34, 0.46, 1.0) if air else (_PITCH - 0.16, 0.85, 0.85)
    cloth = "#2f3f5c" if air else "#33506b"
    for row in range(rows):
        py = y - 0.75 - _PITCH * row
        for side in (-1, 1):
            room.furnish("carriage_seat", side * (x - 0.6), py, color=cloth)
        for side in ("left", "right"):
            room.window(side, py - 0.2, width=wide, height=tall, sill=sill, style="rubber")
    for side in (-1, 1):
        bin_y = 0.35
        if air:
            room.piece("overhead_bin", side * x, bin_y, h - 0.12, -90.0 * side, length=2 * y - 1.6)
        else:
            room.piece("hand_rail", side * 0.42, bin_y, 1.92, 90, length=2 * y - 1.6, drop=round(h - 1.92, 2))
    room.door("right", -y + 0.6, width=0.85, height=1.95, style="lift" if air else "bus", name="cabin_door")
    room.door("back", 0, width=0.7, height=1.95, style="lift", name="rear_door", tags=("enter", "exit", "back"))
    room.furnish("car_seat", 0.95 - (x - 0.6) + 0.3 if air else -x + 0.75, -y + 0.65, required=False, color=cloth)
    room.mark("front_seat", -x + 0.75, -y + 0.4, 0, "driver", "pilot")
    room.mark("aisle", 0, -y + 1.5, 0, "steward", "stewardess", "attendant", "conductor", "hostess")
    for row in range(0, rows, 2):
        py = y - 0.9 - _PITCH * row
        room.piece("ceiling_light", 0, py, h, modern=True)
        room.lamp("ceiling_light", (0, py, h - 0.12), 16, COOL, kind="AREA", size=0.7)
    return room.finish()


KIT = SetKit(
    key="coach", name="Coach", means={"seat": "carriage_seat", "bench": "carriage_seat", "sofa": "carriage_seat"},
    tags=("bus", "coach", "minibus", "school bus", "city bus", "night bus", "plane", "airplane", "aeroplane",
        "airliner", "airplane cabin", "plane cabin", "aircraft", "jet", "private jet", "helicopter"),
    indoor=True, draw=draw, width=Span(3.7, 3.8, 4.4), depth=Span(6.8, 7.6, 12.0), height=Span(2.25, 2.35, 2.6),
    period="modern", options={"air": False},
    has=("window", "aisle", "wheel", "rail", "door", "bus", "plane", "overhead bin"), seated=True,
    on_foot=("steward", "stewardess", "attendant", "attendants", "conductor", "hostess", "inspector"),
)  # fmt: skip
