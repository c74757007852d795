"""Set kit: a motel room: two beds, a television on a low chest, the door and its one window to the car park."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a motel room: beds at the left wall, door and window at the right, the floor between free."""
    modern = params.period == "modern"
    room = Room("motel_room", params, rng, Finishes("wall_planks" if not modern else "plaster_ochre", "carpet_worn"),
                view="facades")  # fmt: skip
    x, y = room.half_x, room.half_y
    room.door("right", -y * 0.5, style="panel")
    room.window("right", y * 0.3, width=1.7, height=1.35, sill=0.85, style="blinds", mark=True)
    room.against("right", "radiator", y * 0.3, 0.12, required=False)
    room.door("back", x - 0.85, width=0.8, name="bathroom_door", tags=("bathroom", "exit"))
    for index, at in enumerate((y - 1.1, -0.75)):
        room.against("left", "bed", at, 1.1, required=index == 0, width=1.35, color="#7a4632")
        room.on_wall("left", "picture", at, 1.5, width=0.7, height=0.45)
    between = (y - 1.85) / 2
    room.against("left", "nightstand", between, 0.3)
    room.against("left", "table_lamp", between, 0.3, z=0.58)
    room.mark("bed", -x + 2.65, y - 1.2, 90, "bed")
    room.against("back", "dresser", 0.1, 0.3, width=1.3, height=0.66, rows=2.0)
    room.against("back", "television", 0.1, 0.3, z=0.66, required=False, flat=modern)
    room.furnish("round_table", x - 0.8, y - 0.95, required=False)
    room.furnish("chair", x - 1.0, y - 1.75, yaw=195, required=False)
    room.piece("ceiling_light", 0, 0, params.height, modern=False)
    room.lamp("ceiling_light", (0, 0, params.height - 0.2), 20, kind="AREA", size=0.4)
    return room.finish()


KIT = SetKit(
    key="motel_room", name="Motel room",
    tags=("motel room", "motel", "hostel room", "cheap hotel room", "roadside inn room"), indoor=True, room="home",
    draw=draw, width=Span(6.8, 7.0, 9.0), depth=Span(5.6, 5.8, 8.0), height=Span(2.4, 2.6, 3.0),
    has=("bathroom door", "blind", "slat", "headlight", "neon"), means={"tv": "television", "lamp": "table_lamp"},
)  # fmt: skip
