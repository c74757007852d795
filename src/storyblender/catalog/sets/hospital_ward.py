"""Set kit: a hospital ward: two beds with their heads to the back wall, a screen between, window, cool even light."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a hospital ward: beds along the back wall and the doctors' floor before them."""
    modern = params.period == "modern"
    look = Finishes("plaster_white", "lino_grey" if modern else "tile_green", dado="plaster_mint", dado_height=1.3)
    room = Room("hospital_ward", params, rng, look, view="treeline")
    x, y = room.half_x, room.half_y
    room.door("left", -y * 0.45, width=1.2, style="glass")
    room.window("right", y * 0.1, width=1.6, style="blinds" if modern else "grid", mark=True)
    beds = (-x * 0.5, x * 0.5)
    for index, at in enumerate(beds):
        room.against("back", "hospital_bed", at, 1.15, required=index == 0)
        room.against("back", "nightstand", at + 0.85, 0.3, required=False)
        if modern:
            stand = "heart_monitor" if index else "drip_stand"
            room.against("back", stand, at - 0.8, 0.35, required=False)
        room.piece("bed_rail_light", at, y - 0.05, 1.75)
        room.lamp("bed_light", (at, y - 0.3, 1.85), 5, WARM, kind="AREA", size=0.5, target=(at, y - 1.0, 0.6))
        room.mark(f"bedside_{index + 1}", at + 0.95, y - 1.5, 270, "bed")
        room.piece("bed_curtain", at - 1.15, y - 1.15, 0.0, 90, width=1.9, height=2.1)
    room.piece("medicine_cabinet", *room.spot("left", y * 0.62, 0.0), 0.0, 90, footprint=(0.95, 0.8), tall=1.9)
    room.piece("anatomy_chart", *room.spot("left", -y * 0.1, 0.0), 1.2, 90)
    room.piece("eye_chart", *room.spot("right", y * 0.62, 0.0), 1.2, 270)
    room.furnish("wheelchair", x - 0.7, -y * 0.2, yaw=-80, required=False)
    room.on_wall("right", "notice_board", -y * 0.78, 1.2, width=1.0, height=0.7)
    room.furnish("chair", beds[0] - 1.2, y - 1.3, yaw=90)
    room.against("left", "cabinet", y * 0.2, 0.3, required=False)
    room.furnish("stool", beds[1] + 1.25, y - 1.6, required=False)
    room.against("right", "sink", -y * 0.5, 0.33, required=False)
    room.on_wall("left", "wall_clock", y * 0.2, 2.1)
    for px in (-x * 0.45, x * 0.45):
        for py in (-y * 0.4, y * 0.3):
            room.piece("ceiling_light", px, py, params.height, modern=True)
            room.lamp("ceiling_light", (px, py, params.height - 0.12), 26, COOL, kind="AREA", size=0.9)
    return room.finish()


KIT = SetKit(
    key="hospital_ward", name="Hospital ward",
    tags=("hospital", "ward", "clinic", "infirmary", "operating room", "surgery", "er", "emergency room", "sickbay",
        "morgue", "asylum"),
    indoor=True, room="public", draw=draw, width=Span(7.4, 7.8, 12.0), depth=Span(6.8, 7.2, 9.0),
    height=Span(2.7, 3.0, 3.6), period="modern",
    means={"bed": "hospital_bed", "monitor": "heart_monitor", "screen": "folding_screen"},
)  # fmt: skip
