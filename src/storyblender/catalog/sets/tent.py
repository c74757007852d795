"""Set kit: the inside of a tent: low canvas at both sides, poles, the flap open at the back, a camp bed."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_EAVE = 1.65
"""Metres: who sits on the bed, or stands beside it, has their head under the canvas."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a tent: the ridge from front to back, bed and chest under the canvas, the middle free."""
    room = Room("tent", params, rng, Finishes("canvas", "grass_dry", "canvas", outside="grass_dry"), view="treeline")
    x, y, h = room.half_x, room.half_y, params.height
    for side in (-1, 1):
        room.piece("roof_slope", side * x, 0, 0, -90.0 * side, footprint=(2 * y, 0.3), wild=True, material="canvas",
                   length=2 * y, run=x, eave=_EAVE, rise=h - _EAVE)  # fmt: skip
    room.piece("tent_pole", 0, 0, 0, 90, length=2 * y - 0.4, height=h - 0.06)
    room.window("back", 0.9, width=1.0, height=1.75, sill=0.02, style="mouth")
    room.mark("flap", 0.9, y - 0.6, 0, "enter", "exit", "door", "flap", "back")
    room.slab("patch", rectangle(-1.5, -y + 0.9, 1.5, y - 1.0), "planks_gray", z=0.01)
    room.furnish("rug", 0, 0, yaw=90, required=False)
    room.furnish("bed", -x + 0.62, 0.35, width=0.8, depth=1.9, color="#6d6a4c")
    room.furnish("chest", x - 0.62, 0.7, yaw=-90)
    room.furnish("crate", x - 0.62, -0.6, yaw=12, required=False)
    room.furnish("stool", x - 1.75, -y + 0.8, required=False)
    room.furnish("backpack", -x + 0.85, -y + 0.8, yaw=30, required=False)
    room.hang("lantern", 0, -0.1, low=1.9)
    return room.finish()


KIT = SetKit(
    key="tent", name="Tent",
    tags=("tent", "yurt", "marquee", "pavilion", "tepee", "teepee", "wigwam", "bivouac", "army tent", "command tent",
        "field hospital"),
    indoor=True, draw=draw, width=Span(5.0, 5.6, 8.0), depth=Span(4.6, 5.0, 8.0), height=Span(2.6, 2.9, 3.6),
    period="past", has=("flap", "tent", "canvas"), means={"cot": "bed"},
)  # fmt: skip
