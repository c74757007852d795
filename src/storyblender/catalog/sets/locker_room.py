"""Set kit: a changing room: lockers and benches around the walls, a board for the trainer, tiles."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a changing room: a bench before each row of lockers, the middle free for the one who speaks."""
    look = Finishes("plaster_white", "tile_green", "ceiling_white", dado="paint_blue", dado_height=1.3)
    room = Room("locker_room", params, rng, look, view="none")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", -y + 1.0, width=1.2, style="panel")
    room.door("right", -y + 1.0, width=1.0, height=2.2, style="arch", name="showers", tags=("showers", "exit"))
    count = int((2 * x - 0.4) // 0.92)
    for index in range(count):
        room.against("back", "locker", (index - (count - 1) / 2) * 0.92, 0.26, required=False)
    benches = max(2, int((2 * x - 1.0) // 2.0))
    for index in range(benches):
        room.against("back", "bench", (index - (benches - 1) / 2) * 2.0, 0.85)
    room.mark("bench", 0, y - 1.6, 180, "bench", "locker")
    for side, wall in ((-1, "left"), (1, "right")):
        room.piece("peg_rail", side * (x - 0.01), 0.2, 1.65, -90.0 * side, length=2.6)
        room.against("left" if side < 0 else "right", "bench", 0.2, 0.4, width=2.4, required=wall == "left")
    room.on_wall("right", "blackboard", 0.2, 1.0, color="#e4e2dc", width=1.7)
    room.mark("board", x - 1.3, 0.2, 270, "board", "whiteboard")
    room.furnish("ball", -x + 0.6, y - 1.5, required=False)
    room.furnish("bag", x - 0.6, y - 1.4, yaw=20, required=False)
    room.furnish("trash_can", -x + 0.45, -y + 0.3, required=False)
    room.on_wall("left", "wall_clock", 0.2, 2.15)
    for px in (-x * 0.45, x * 0.45):
        room.piece("ceiling_light", px, 0.2, h, modern=True)
        room.lamp("ceiling_light", (px, 0.2, h - 0.12), 34, COOL, kind="AREA", size=1.0)
    return room.finish()


KIT = SetKit(
    key="locker_room", name="Changing room",
    tags=("changing room", "locker room", "changing rooms", "team room", "shower room"), indoor=True, room="public",
    draw=draw, width=Span(6.6, 7.4, 11.0), depth=Span(5.6, 6.2, 9.0), height=Span(2.6, 2.8, 3.4), period="modern",
    has=("peg", "hook", "shower"), means={"bin": "trash_can"},
)  # fmt: skip
