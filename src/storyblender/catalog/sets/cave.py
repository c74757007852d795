"""Set kit: a cave: rock that leans over on all sides, stalactites, a mouth to the light, a fire."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import YAW_OF_SIDE, Finishes, Room, Side

_SIDES: tuple[Side, ...] = ("back", "left", "right", "front")


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a cave: rock before every wall, the mouth at the right of the back, boulders at the edges."""
    room = Room("cave", params, rng, Finishes("cave_rock", "mud", "cave_rock", outside="grass_dry"), view="hills")
    x, y, h = room.half_x, room.half_y, params.height
    room.window("left", 0.0, width=2.6, height=h - 0.75, sill=0.02, style="mouth", mark=True)
    for index, side in enumerate(_SIDES):
        px, py = room.spot(side, 0, 0)
        wide = room.length(side)
        across = side in ("back", "front")
        room.piece("cave_wall", px, py, 0, YAW_OF_SIDE[side], wild=True, footprint=(wide, 0.5), length=wide + 0.4,
                   height=h, vault=1.3 if across else 1.0, mouth=2.7 if side == "left" else 0.0,
                   seed=float(index + 1))  # fmt: skip
    room.mark("mouth", -x + 1.0, 0, 90, "enter", "exit", "left", "entrance")
    room.mark("deep", x - 1.2, -y * 0.4, 270, "enter", "exit", "right")
    for index, (px, py) in enumerate(((-x * 0.35, y * 0.5), (x * 0.4, y * 0.35), (x * 0.1, -y * 0.5))):
        room.piece("stalactites", px, py, h, reach=1.1, count=8.0, seed=float(index))
    for px, py, size in ((x - 1.1, y - 1.1, 1.5), (-x + 1.2, y - 1.2, 1.2), (x - 1.0, -y + 1.3, 1.1),
                         (x * 0.2, y - 0.95, 0.9), (-x + 1.1, -y + 1.2, 1.0)):  # fmt: skip
        room.piece("rock", px, py, -0.05, room.between(0, 360), scale=size, footprint=(0.7, 0.7), variant=size * 10)
    room.furnish("campfire", x * 0.36, y * 0.5)
    room.furnish("log", x * 0.36 + 1.5, y * 0.5 - 0.3, yaw=80, required=False)
    room.furnish("torch", x - 0.75, -y * 0.1, 1.5, 270, required=False)
    return room.finish()


KIT = SetKit(
    key="cave", name="Cave",
    tags=("cave", "cavern", "grotto", "mine", "mine shaft", "mineshaft", "lair", "underground lake", "catacomb",
        "underground chamber"),
    indoor=True, draw=draw, width=Span(8.6, 9.4, 14.0), depth=Span(8.0, 8.4, 12.0), height=Span(3.2, 3.6, 5.0),
    period="past", has=("wall", "rock wall", "stalactite", "mouth", "entrance"),
)  # fmt: skip
