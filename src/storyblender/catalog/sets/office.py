"""Set kit: an office: desk before the windows with blinds, visitors' chairs, filing cabinets, books, hat stand."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_LOOKS = {
    "past": Finishes("paper_green", "boards", "ceiling_warm", dado="dado_brown"),
    "classic": Finishes("plaster_green", "boards", "ceiling_warm", dado="dado_brown"),
    "modern": Finishes("plaster_grey", "carpet", "ceiling_white"),
}


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an office: the desk under the back windows, cabinets at the left, the floor in front free."""
    room = Room("office", params, rng, _LOOKS[params.period], view="skyline")
    x, y, modern = room.half_x, room.half_y, params.period == "modern"
    room.centre = (0.0, -y * 0.25)
    room.door("right", -y * 0.5, style="glass" if params.period != "past" else "panel")
    for at in (-x * 0.42, x * 0.42):
        room.window("back", at, width=1.4, height=1.6, sill=0.85, style="blinds" if params.period != "past" else "sash",
                    mark=at < 0)  # fmt: skip
    desk_y = y - 1.3
    room.furnish("desk", 0, desk_y)
    room.furnish("chair", 0, desk_y + 0.68, yaw=0)
    room.mark("desk", 0, desk_y - 0.9, 180, "desk", "table")
    room.furnish("chair", -x + 0.55, desk_y - 0.65, yaw=115)
    room.furnish("chair", x - 0.66, desk_y - 0.55, yaw=-115, required=False)
    room.furnish("computer" if modern else "table_lamp", 0.52, desk_y + 0.12, 0.76, required=False)
    if not modern:
        room.furnish("telephone", -0.45, desk_y + 0.08, 0.76, required=False)
    for index in range(3):
        room.against("left", "filing_cabinet", -y * 0.35 - 0.55 * index, 0.34, required=index == 0)
    room.against("right", "bookshelf", y * 0.12, 0.24, required=False)
    room.against("right", "hat_stand", y - 0.5, 0.4, required=False)
    room.furnish("potted_plant" if modern else "globe", -x + 0.45, y - 0.45, required=False)
    if not modern:
        room.furnish("rug", 0, -0.1, required=False)
    room.on_wall("left", "picture", y * 0.2, 1.4)
    room.on_wall("left", "picture", y * 0.5, 1.45)
    room.on_wall("back", "wall_clock", 0, 2.0)
    room.hang("pendant_lamp" if params.period != "past" else "chandelier", 0, 0)
    return room.finish()


KIT = SetKit(
    key="office", name="Office", tags=("office", "study", "detective agency", "headquarters", "bureau"),
    indoor=True, room="office", draw=draw, width=Span(4.6, 4.8, 10.0), depth=Span(4.8, 5.0, 9.0),
)  # fmt: skip
