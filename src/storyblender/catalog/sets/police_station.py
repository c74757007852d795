"""Set kit: a police station: desks in rows, files along the walls, a board of cases, a barred cell at the side."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a police station: two desks before the windows, the cell at the left, the floor in front free."""
    modern, past = params.period == "modern", params.period == "past"
    look = (
        Finishes("plaster_grey", "lino_grey", "ceiling_white", dado="paint_blue", dado_height=1.1)
        if modern
        else Finishes("plaster_cream", "boards" if past else "lino_brown", "ceiling_warm", dado="dado_green")
    )
    room = Room("police_station", params, rng, look, view="facades")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.5, width=1.3, height=2.2, style="double" if past else "glass")
    room.door("left", y * 0.15, width=1.1, height=2.1, style="cell", name="cell_door", tags=("cell", "exit"))
    for at in (-x * 0.5, x * 0.5):
        room.window("back", at, width=1.5, height=1.4, sill=1.0, style="sash" if past else "blinds", mark=at > 0)
    for side in (-1, 1):
        px, py = side * (x * 0.5), y - 1.75
        room.furnish("desk", px, py)
        room.furnish("chair" if not modern else "office_chair", px, py + 0.75)
        room.furnish("chair", px - side * 0.35, py - 0.85, yaw=180 + side * 15)
        room.furnish("bankers_lamp" if not modern else "computer", px + side * 0.5, py + 0.1, 0.76, required=False)
        room.furnish("folder", px - side * 0.35, py - 0.1, 0.76, yaw=side * 12, required=False)
        if not past:
            room.furnish("telephone", px - 0.55 * side, py + 0.18, 0.76, required=False)
    room.mark("desk", x * 0.5 - 0.95, y - 2.7, 160, "desk", "table")
    room.on_wall("back", "notice_board", 0, 1.15, width=1.6)
    room.mark("board", 0.1, y - 0.7, 180, "board")
    for index in range(3):
        room.against("right", "filing_cabinet", y * 0.1 + 0.55 * index, 0.34, required=index == 0)
    room.on_wall("right", "wall_map", -y * 0.05 - 0.5, 1.35)
    room.against("left", "bench", -y * 0.35, 0.3, width=1.6)
    room.on_wall("left", "notice_board", -y * 0.35, 1.35)
    room.furnish("flag", -x + 0.75, y - 0.45, required=False, color="#23385c")
    room.furnish("water_cooler" if modern else "hat_stand", x - 0.4, y - 0.45, required=False)
    room.on_wall("back", "wall_clock", 0, 2.25)
    for px in (-x * 0.5, x * 0.5):
        for py in (-y * 0.4, y * 0.4):
            room.piece("ceiling_light", px, py, h, modern=not past)
            room.lamp("ceiling_light", (px, py, h - 0.14), 24, WARM if past else COOL, kind="AREA", size=0.9)
    return room.finish()


KIT = SetKit(
    key="police_station", name="Police station",
    tags=("police station", "precinct", "squad room", "police headquarters", "station house", "sheriff office",
        "detective bureau", "bullpen", "homicide", "booking room", "police post", "incident room"),
    indoor=True, room="office", draw=draw, width=Span(7.6, 8.2, 12.0), depth=Span(7.0, 7.4, 10.0),
    height=Span(2.8, 3.1, 3.8), has=("cell", "cell door"),
)  # fmt: skip
