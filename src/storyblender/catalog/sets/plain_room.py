"""Set kit: a room of no particular kind: the indoor fallback. Door, window, a few plain things against the walls."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a room: a plain room with its middle free."""
    wall = ("plaster_cream", "plaster_grey", "plaster_green")[int(rng.integers(3))]
    room = Room("room", params, rng, Finishes(wall, "boards", dado="dado_brown" if rng.random() < 0.5 else None))
    x, y = room.half_x, room.half_y
    room.door("left", -y * 0.35)
    room.window("back", -x * 0.45, style="curtains", mark=True)
    room.window("back", x * 0.45, style="curtains")
    room.against("right", "cabinet", y * 0.45, 0.35, required=False)
    if params.period != "past":
        room.against("right", "table_lamp", y * 0.45 + 0.3, 0.35, z=0.9, required=False)
    room.against("right", "vase", y * 0.45 - 0.25, 0.35, z=0.9, required=False)
    room.against("right", "chair", -y * 0.1, 0.4, required=False)
    room.against("left", "bookshelf", y * 0.5, 0.24, required=False)
    if y > 2.3:
        room.against("back", "armchair", 0, 0.5, required=False)
    room.against("back", "floor_lamp", -0.75, 0.4, required=False)
    room.furnish("rug", 0, 0.1, required=False)
    if y > 2.8:
        room.furnish("potted_plant", x - 0.45, y - 0.45, required=False)
    room.on_wall("right", "picture", -y * 0.1, 1.45)
    room.on_wall("right", "picture", y * 0.45, 1.5, width=0.9, height=0.65)
    room.on_wall("left", "picture", -y * 0.35 + 1.1, 1.4, width=0.55, height=0.7)
    room.on_wall("left", "wall_mirror", -y * 0.78, 1.2)
    room.on_wall("back", "wall_clock", 0, 1.95)
    room.hang("pendant_lamp" if params.period != "past" else "lantern", 0, 0)
    return room.finish()


KIT = SetKit(
    key="room", name="Room", tags=("room", "house", "home", "interior", "chamber", "back room"), indoor=True,
    room="home", draw=draw, width=Span(3.8, 4.6, 12.0), depth=Span(3.8, 4.4, 10.0),
)  # fmt: skip
