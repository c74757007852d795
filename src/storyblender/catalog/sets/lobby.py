"""Set kit: a lobby: reception desk at the back, columns, benches and sofas. Hotel, bank, station, terminal."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a lobby: desk, columns and seating around a wide free floor."""
    modern = params.period == "modern"
    look = Finishes(
        "plaster_cream", "tile_check" if not modern else "lino_grey", dado="marble", dado_height=1.4, beams=0
    )
    room = Room("lobby", params, rng, look, view="skyline")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", -y * 0.35, width=1.8, height=2.5, style="glass", name="street_door")
    room.door("back", x * 0.62, width=1.3, height=2.3, style="double", name="lift_door")
    for at in (y * 0.15, y * 0.6):
        room.window("left", at, width=1.8, height=2.2, sill=0.7, style="shop", mark=at < y * 0.3)
    room.window("right", -y * 0.4, width=1.8, height=2.2, sill=0.7, style="shop")
    for at in (-x * 0.55, -x * 0.55 + 1.82, -x * 0.55 + 3.64):
        room.against("back", "counter", at, 1.7)
    room.mark("behind_desk", -x * 0.55 + 1.82, y - 0.95, 0, "bar", "staff", "receptionist", "clerk", "concierge")
    room.mark("desk", -x * 0.55 + 1.82, y - 2.55, 180, "bar", "desk")
    room.against("back", "cabinet", -x * 0.55 + 1.82, 0.3, required=False)
    room.on_wall("back", "wall_clock", -x * 0.55 + 1.82, 2.3)
    for px in (-x * 0.58, x * 0.58):
        for py in (-y * 0.55, y * 0.3):
            room.piece("column", px, py, footprint=(0.7, 0.7), height=h, width=0.5, material="marble", style="round")
    room.against("right", "sofa", y * 0.35, 0.6)
    room.furnish("armchair", x - 1.9, y * 0.35 - 1.75, yaw=20, required=False)
    room.furnish("coffee_table", x - 1.75, y * 0.35, yaw=90, required=False)
    room.against("front", "bench", -x * 0.3, 0.4, required=False)
    for px, py in ((x - 0.5, y - 0.5), (-x + 0.5, -y + 0.5), (x - 0.5, -y + 0.5)):
        room.furnish("potted_plant", px, py, required=False)
    room.furnish("rug", x - 1.9, y * 0.35, required=False)
    room.furnish("floor_lamp", x - 0.55, y * 0.35 + 1.6, required=False)
    for px in (-x * 0.3, x * 0.3):
        room.hang("chandelier" if not modern else "pendant_lamp", px, -y * 0.1)
    room.lamp("ceiling_wash", (0, 0, h - 0.1), 120, WARM, kind="AREA", size=4.0)
    return room.finish()


KIT = SetKit(
    key="lobby", name="Lobby",
    tags=("lobby", "hotel lobby", "hotel", "reception", "train station", "railway station", "station", "foyer",
        "waiting hall", "embassy", "city hall"),
    indoor=True, draw=draw, width=Span(9.0, 11.0, 16.0), depth=Span(8.0, 9.6, 14.0), height=Span(3.4, 4.0, 5.0),
)  # fmt: skip
