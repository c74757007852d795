"""Set kit: an underground platform: tiled walls, columns along the edge, the track in its pit, tunnels at both ends."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_TRACK = 3.4
"""Metres of pit before the far wall."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an underground platform: the track at the back, benches and columns before it, the stairs at the right."""
    modern = params.period == "modern"
    look = (
        Finishes("concrete_light", "lino_grey", "concrete_light", dado="paint_grey", dado_height=1.2)
        if modern
        else Finishes("tile_green", "paving_light", "ceiling_white", beams=5)
    )
    room = Room("subway", params, rng, look, view="none", thickness=0.3, pit=_TRACK)
    x, y, h, edge = room.half_x, room.half_y, params.height, room.size.y
    room.door("right", -y * 0.55, width=1.8, height=2.4, style="arch", name="stairs", tags=("enter", "exit", "door"))
    room.door("left", -y * 0.62, style="panel")
    middle = y - _TRACK / 2
    for side, px, yaw in (("left", -x, 180.0), ("right", x, 0.0)):
        room.gap("left" if side == "left" else "right", middle, _TRACK - 0.02, 2.5)
        room.piece("tunnel", px, middle, -1.1, yaw, width=_TRACK, height=3.6)
    room.piece("rails", 0.0, middle, -1.1, length=2 * x + 26.0)
    room.slab("patch", rectangle(-x, edge - 0.75, x, edge - 0.55), "paint_yellow", z=0.004)
    if params.option("train"):
        room.piece("train", 2.0, middle, 0.0, carriages=3.0, modern=True)
    for index, px in enumerate(np.linspace(-x * 0.78, x * 0.78, 4)):
        column = {"width": 0.34, "material": "metal_green", "style": "girder"}
        room.piece("column", round(float(px), 3), edge - 1.1, footprint=(0.5, 0.5), height=h, **column)
        room.piece("poster", round(float(px), 3), y, 0.75, width=1.5, height=1.1, variant=float(index))
    for px in (-x * 0.5, x * 0.5):
        room.piece("station_sign", px * 1.04, y, 2.35, width=2.6)
    for index, px in enumerate((-x * 0.52, x * 0.52)):
        room.furnish("bench", px, edge - 1.1, required=index == 0, width=1.8)
    room.against("front", "bench", x * 0.3, 0.35, required=False, width=1.8)
    room.furnish("trash_can", -x * 0.24, edge - 1.1, required=False)
    room.piece("timetable", x, -y * 0.12, 1.2, 270, modern=modern)
    room.piece("poster", -x, -y * 0.12, 1.0, 90, width=1.1, height=1.5, variant=2.0)
    if modern:
        room.piece("vending_machine", -x, y * 0.12, 0.0, 90, footprint=(1.0, 1.6), color="#23446b")
    room.mark("edge", 0.0, edge - 0.9, 180, "window", "edge")
    for px in np.linspace(-x * 0.7, x * 0.7, 4):
        at = round(float(px), 3)
        for py in (-y * 0.4, edge - 0.9):
            room.piece("ceiling_light", at, py, h, modern=True)
            room.lamp("ceiling_light", (at, py, h - 0.14), 26, COOL if modern else WARM, kind="AREA", size=0.8)
    return room.finish()


KIT = SetKit(
    key="subway", name="Underground platform",
    tags=("subway", "subway platform", "subway station", "metro station", "underground station", "tube station",
        "metro platform", "underground platform", "tube platform"),
    indoor=True, draw=draw, width=Span(10.0, 13.0, 20.0), depth=Span(12.0, 12.6, 15.0), height=Span(3.1, 3.3, 4.0),
    period="modern", options={"train": False},
)  # fmt: skip
