"""Set kit: a castle hall: stone, columns, a throne on steps under banners, tall windows, torches and a chandelier."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import CANDLE, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a great hall: the dais at the back, columns down both sides, a carpet along the middle."""
    room = Room(
        "great_hall", params, rng, Finishes("stone", "flagstones", "ceiling_dark", beams=7), view="hills", thickness=0.5
    )
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.55, width=1.7, height=2.9, style="double", name="gate")
    room.door("left", -y * 0.55, width=1.1, height=2.3, style="panel")
    for at in (-x * 0.62, x * 0.62):
        room.window("back", at, width=1.0, height=2.6, sill=1.5, style="arched")
    for at in (-y * 0.1, y * 0.5):
        room.window("left", at, width=1.0, height=2.6, sill=1.5, style="arched", mark=at > 0)
    for step in range(3):
        reach, depth = 2.4 - 0.35 * step, 2.5 - 0.4 * step
        room.slab(
            "block", rectangle(-reach, y - depth, reach, y - 0.02), "stone_light", z=0.03 * (step + 1),
            thickness=0.03,
        )  # fmt: skip
    room.furnish("throne", 0, y - 0.95, 0.09)
    room.mark("throne", 0, y - 3.1, 180, "throne", "audience")
    room.slab("patch", rectangle(-0.85, -y + 0.4, 0.85, y - 2.5), "cloth_red", z=0.012)
    for side in (-1, 1):
        for py in (-y * 0.62, -y * 0.08, y * 0.46):
            room.piece(
                "column", side * (x - 1.5), py, footprint=(0.8, 0.8), height=h, width=0.62, material="stone_light",
                style="gothic",
            )  # fmt: skip
            room.furnish("torch", side * (x - 1.5 - 0.5), py, 1.75, 90.0 * -side)
        room.piece("banner", side * 1.7, y - 0.06, h - 0.5, width=0.9, length=2.6, color="#7a1d20")
        room.piece(
            "banner", side * (x - 0.06), -y * 0.35, h - 0.6, -90.0 * side, width=0.9, length=2.2, color="#23385c"
        )
    if x > 5.9:
        _long_tables(room)
    room.furnish("chest", -x + 0.6, y - 0.6, required=False)
    room.furnish("bench", x - 0.5, y * 0.15, yaw=-90, required=False)
    room.hang("chandelier", 0, -y * 0.1)
    room.lamp("dais", (0, y - 1.6, h - 0.6), 60, CANDLE, kind="AREA", size=1.8, target=(0, y - 1.0, 0.8))
    return room.finish()


def _long_tables(room: Room) -> None:
    """Set a long table with benches before the columns on either side; the way to the throne stays free."""
    for side in (-1, 1):
        at, py = side * (room.half_x - 2.95), -room.half_y * 0.36
        room.furnish("dining_table", at, py, yaw=90, required=False, width=3.0, depth=0.8)
        for off in (-0.68, 0.68):
            room.furnish(
                "bench", at + off, py, yaw=-90.0 * side if off * side > 0 else 90.0 * side, required=False, width=2.6
            )
        for along in (-0.8, 0.8):
            room.furnish("candelabra", at, py + along, 0.76, 90, required=False)


KIT = SetKit(
    key="great_hall", name="Great hall",
    tags=("throne room", "great hall", "palace", "tower", "royal court", "council chamber", "state room",
        "banquet hall", "castle hall", "palace hall", "hall of the castle", "knights' hall", "feast hall"),
    indoor=True, draw=draw, width=Span(10.0, 12.0, 18.0), depth=Span(11.0, 13.0, 20.0), height=Span(4.8, 5.8, 7.5),
    period="past",
)  # fmt: skip
