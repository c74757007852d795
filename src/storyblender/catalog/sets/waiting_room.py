"""Set kit: a waiting room: benches in rows around a free floor, a hatch, notices; at a station tickets, trains."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a waiting room: windows and a door at the back, benches under them and in rows, the hatch at the left."""
    modern, railway = params.period == "modern", bool(params.option("railway"))
    look = (
        Finishes("plaster_white", "lino_grey", dado="paint_grey", dado_height=1.1)
        if modern
        else Finishes("plaster_green", "tile_check", "ceiling_warm", dado="dado_brown", dado_height=1.25)
    )
    room = Room("waiting_room", params, rng, look, view="facades")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("back", x * 0.36, width=1.5, height=2.4, style="glass", name="back_door")
    room.door("left", -y * 0.62, width=1.1, height=2.2, style="glass", name="street_door")
    room.window("back", -x * 0.7, width=1.7, height=1.9, sill=1.0, style="grid")
    room.window("back", -x * 0.2, width=1.9, height=1.9, sill=1.0, style="grid", mark=True)
    room.window("back", x * 0.78, width=1.4, height=1.9, sill=1.0, style="grid")
    room.on_wall("back", "wall_clock", x * 0.09, 2.35, width=0.5, height=0.5)

    room.against("back", "bench", -x * 0.2, 0.34, width=1.8)
    room.against("back", "radiator", -x * 0.7, 0.1, required=False)
    for at in (-y * 0.28, y * 0.34):
        room.furnish("pew", x * 0.46, at, yaw=270, required=at > 0)
        room.furnish("pew", x * 0.46 + 0.6, at, yaw=90, required=False)
    room.against("right", "bench", -y * 0.28, 0.34, required=False, width=1.8)
    room.against("right", "bench", y * 0.34, 0.34, required=False, width=1.8)
    room.mark("bench", -x * 0.2, y - 1.2, 180, "bench")

    room.piece("ticket_window", -x, y * 0.12, 0.0, 90, footprint=(2.1, 0.76))
    room.mark("ticket_window", -x + 1.1, y * 0.12, 270, "bar", "desk")
    if railway:
        room.piece("timetable", -x, y * 0.7, 1.15, 90, modern=modern)
        room.piece("timetable", x, y * 0.03, 1.3, 270, modern=modern, width=1.3, height=1.0)
    else:
        room.on_wall("left", "notice_board", y * 0.7, 1.2)
        room.on_wall("right", "calendar", y * 0.03, 1.5)
    for index, (side, at) in enumerate((("right", -y * 0.5), ("right", y * 0.62), ("left", -y * 0.25))):
        yaw = 270 if side == "right" else 90
        room.piece("poster", x if side == "right" else -x, at, 1.35, yaw, width=0.75, height=1.05, variant=float(index))
    if modern:
        room.piece("vending_machine", x, y * 0.84, 0.0, 270, footprint=(1.0, 1.6))
    else:
        room.against("right", "wood_stove", y * 0.84, 0.45, required=False)
    room.against("front", "radiator", -x * 0.4, 0.1, required=False)
    room.furnish("potted_plant", -x + 0.5, y - 0.5, required=False)

    for px in (-x * 0.5, x * 0.05, x * 0.6):
        for py in (-y * 0.4, y * 0.45):
            if modern:
                room.piece("ceiling_light", px, py, h, modern=True)
                room.lamp("ceiling_light", (px, py, h - 0.12), 24, COOL, kind="AREA", size=0.9)
            else:
                room.hang("pendant_lamp", px, py, low=2.4)
    room.lamp("tickets", (-x + 0.5, y * 0.12, 2.3), 8, WARM, kind="AREA", size=0.6, target=(-x + 0.8, y * 0.12, 1.0))
    if railway:
        _platform(room, modern)
    return room.finish()


def _platform(room: Room, modern: bool) -> None:
    """Lay the platform behind the back wall: posts of its roof, lamps, a train that waits."""
    x, y = room.half_x, room.half_y
    room.slab("patch", rectangle(-x - 16, y + 0.2, x + 16, y + 3.6), "paving", z=-0.1)
    for px in np.arange(-x - 3.0, x + 4.0, 3.6):
        room.piece("column", round(float(px), 3), y + 2.6, -0.1, height=3.4, width=0.2, material="iron", style="girder")
    room.piece("train", 1.5, y + 5.6, -0.1, carriages=3.0, modern=modern)
    for px in (-x * 0.7, x * 0.36):
        room.lamp("platform", (px, y + 2.0, 3.1), 40, COOL if modern else WARM, kind="AREA", size=0.5, role="set")


KIT = SetKit(
    key="waiting_room", name="Waiting room",
    tags=("waiting room", "station waiting room", "ticket office", "ticket hall", "bus station", "bus depot",
        "train depot", "ferry terminal", "customs hall"),
    indoor=True, room="public", draw=draw, width=Span(9.4, 10.4, 14.0), depth=Span(6.8, 7.4, 10.0),
    height=Span(3.2, 3.6, 4.2), options={"railway": False},
)  # fmt: skip
