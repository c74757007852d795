"""Set kit: a bathroom: white tiles, basin under a mirror, tub along the back wall, frosted window."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a bathroom: the fittings along back and right walls, the floor free."""
    room = Room(
        "bathroom", params, rng, Finishes("plaster_mint", "tile", dado="wall_tile", dado_height=1.5), view="treeline"
    )
    x, y, h = room.half_x, room.half_y, params.height
    room.centre = (0.0, -y * 0.2)
    room.door("left", -y * 0.3)
    room.window("back", -x + 0.9, width=1.0, height=0.8, sill=1.55, style="frosted")
    room.furnish("bathtub", -x + 0.9, y - 0.45, yaw=90)
    room.against("back", "toilet", x - 0.45, 0.38)
    room.against("right", "sink", -0.2, 0.33)
    room.on_wall("right", "wall_mirror", -0.2, 1.2)
    room.mark("mirror", x - 1.0, -0.2, 90, "mirror", "sink")
    if y > 2:
        room.against("left", "cabinet", y * 0.3, 0.28, required=False)
    room.furnish("stool", -x + 0.5, y - 1.3, required=False)
    room.piece("ceiling_light", 0, 0, h, modern=params.period == "modern")
    room.lamp("ceiling_light", (0, 0, h - 0.16), 30, WARM, kind="AREA", size=0.4)
    return room.finish()


KIT = SetKit(
    key="bathroom", name="Bathroom",
    tags=("bathroom", "washroom", "restroom", "toilet", "shower", "men's room", "ladies' room"), indoor=True,
    room="bathroom", draw=draw, width=Span(2.9, 3.2, 7.0), depth=Span(2.8, 3.0, 6.0), height=Span(2.4, 2.7, 3.2),
)  # fmt: skip
