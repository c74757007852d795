"""Set kit: a control room: consoles in a half ring, the command chair, a wall of screens or the stars outside."""

from __future__ import annotations

import math

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a control room: screen at the back with the chair before it, consoles at both sides, the middle free."""
    space = bool(params.option("space"))
    look = (
        Finishes("metal_grey", "concrete_dark", "ceiling_dark", dado="paint_blue", dado_height=0.9)
        if space
        else Finishes("plaster_grey", "lino_grey", "ceiling_white", dado="paint_grey", dado_height=0.9)
    )
    room = Room("control_room", params, rng, look, view="none")
    x, y, h = room.half_x, room.half_y, params.height
    for side in ("left", "right"):
        room.door(side, -y * 0.55, width=1.3, height=2.2, style="lift" if space else "double", name=f"{side}_door")
    if space:
        room.card("stars", (-2.9, y - 0.02), (2.9, y - 0.02), 0.95, 2.75)
        room.piece("viewscreen", 0.0, y, 0.95, width=5.8, height=1.8)
    else:
        room.piece("screen_wall", 0.0, y, 0.95, width=5.4, height=1.9)
    room.mark("screen", 0.0, y - 0.9, 180, "window", "screen")
    room.furnish("office_chair", 0.0, y - 1.5)
    for side in (-1, 1):
        for index, (at, turn) in enumerate(((y * 0.42, 60), (-y * 0.02, 90))):
            px = side * (x - 0.84 + 0.28 * index)
            room.furnish("control_console", px, at, yaw=-side * turn, required=index == 0)
            angle = math.radians(turn)
            seat_x, seat_y = px - side * 0.95 * math.sin(angle), at - 0.95 * math.cos(angle)
            room.furnish("office_chair", seat_x, seat_y, yaw=180 - side * turn, required=False)
        room.piece("screen_wall", side * x, y * 0.2, 1.35, -90.0 * side, width=2.4, height=1.0, columns=3.0, rows=2.0)
    room.against("front", "locker", -x * 0.45, 0.3, required=False)
    room.against("front", "locker", x * 0.45, 0.3, required=False)
    for px in (-x * 0.45, x * 0.45):
        for py in (-y * 0.45, y * 0.35):
            room.piece("ceiling_light", px, py, h, modern=True)
            room.lamp("ceiling_light", (px, py, h - 0.12), 22, COOL, kind="AREA", size=0.9)
    for side in (-1, 1):
        spot = (side * (x - 0.9), y * 0.3, 1.25)
        room.lamp("console", spot, 7, COOL if space else WARM, kind="AREA", size=0.6, target=(0.0, y * 0.1, 1.3))
    return room.finish()


KIT = SetKit(
    key="control_room", name="Control room",
    tags=("control room", "control centre", "control center", "command center", "command centre", "command post",
        "mission control", "operations room", "war room", "situation room", "security room", "observation room",
        "surveillance room", "spaceship bridge", "starship bridge", "starship", "spacecraft", "space station",
        "space shuttle", "broadcast room", "spaceship", "airlock"),
    indoor=True, draw=draw, width=Span(7.6, 8.6, 12.0), depth=Span(6.8, 7.4, 10.0), height=Span(2.8, 3.1, 4.0),
    period="modern", options={"space": False}, has=("ship", "vessel", "spaceship", "starship", "shuttle", "submarine"),
    means={"chair": "office_chair", "armchair": "office_chair", "seat": "office_chair", "torch": "flashlight",
        "camera": "security_camera", "phone": "smartphone"},
)  # fmt: skip
