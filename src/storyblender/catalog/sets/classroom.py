"""Set kit: a classroom: board and teacher's desk at the back, rows of desks at the sides, high windows on the left."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a classroom: the board wall and the desks; an aisle and the floor before the board stay free."""
    look = Finishes("plaster_cream", "boards", dado="dado_green" if params.period != "modern" else "plaster_blue")
    room = Room("classroom", params, rng, look, view="treeline")
    x, y = room.half_x, room.half_y
    room.door("right", y * 0.5, style="glass")
    for at in (-y * 0.55, 0.0, y * 0.55):
        room.window("left", at, width=1.5, height=1.7, style="grid", mark=at == 0.0)
    room.against("back", "blackboard", 0, 0.06, z=0.85, width=3.2, height=1.25)
    room.mark("board", -0.8, y - 0.75, 180, "board")
    room.against("back", "desk", x * 0.45, 1.2)
    room.against("back", "chair", x * 0.45, 0.5)
    room.mark("teacher", x * 0.1, y - 1.2, 0, "desk")
    rows = max(1, int((y + 0.9) // 1.35))
    for row in range(rows):
        at = -y + 0.75 + 1.35 * row
        for px in (-x + 1.0, -x + 2.35, x - 2.35, x - 1.0):
            if abs(px) < 1.75 and abs(at) < 2.0:
                continue
            room.furnish("school_desk", px, at + 0.3, yaw=180, required=row == 0)
            room.furnish("chair", px, at - 0.3, yaw=180, required=row == 0)
    room.against("right", "bookshelf", -y * 0.1, 0.24, required=False)
    room.furnish("globe", x * 0.45 + 1.2, y - 0.5, required=False)
    room.on_wall("back", "wall_clock", 2.1, 2.15)
    for px in (-x * 0.5, x * 0.5):
        for py in (-y * 0.5, y * 0.35):
            room.piece("ceiling_light", px, py, params.height, modern=params.period == "modern")
            room.lamp("ceiling_light", (px, py, params.height - 0.14), 26, COOL, kind="AREA", size=0.8)
    return room.finish()


KIT = SetKit(
    key="classroom", name="Classroom",
    tags=("classroom", "class", "school", "schoolroom", "lecture hall", "university", "auditorium", "kindergarten"),
    indoor=True, room="public", draw=draw, width=Span(7.6, 8.4, 12.0), depth=Span(6.6, 7.6, 11.0),
    height=Span(2.9, 3.2, 3.8),
)  # fmt: skip
