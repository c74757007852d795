"""Set kit: an attic: the roof comes down at both sides, beams across, a skylight, a hatch, what a house forgets."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

EAVE = 1.0
"""Metres: where the roof meets the walls at the sides."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an attic: the ridge from front to back, trunks and boxes under the slopes, the middle free."""
    room = Room("attic", params, rng, Finishes("boards_grey", "boards_grey", "boards_dark"), view="treeline")
    x, y, h = room.half_x, room.half_y, params.height
    for side in (-1, 1):
        gable = {"length": 2 * y, "run": x - 0.25, "eave": EAVE, "rise": h - EAVE, "material": "boards"}
        room.piece("roof_slope", side * x, 0, 0, -90.0 * side, footprint=(2 * y, 0.3), wild=True, rafters=7.0,
                   skylight=side > 0, **gable)  # fmt: skip
    for at in (-y * 0.6, y * 0.05, y * 0.7):
        room.piece("collar_beam", 0, at, h - 0.62, length=round(0.62 * 2 * x / (h - EAVE) + 0.3, 2), post=0.55)
    room.window("back", 0, width=0.8, height=1.0, sill=0.95, style="arched", mark=True)
    room.door("front", x - 1.3, width=0.85, height=1.95, style="plank")
    room.piece("floor_hatch", -x + 1.75, -y + 1.0, yaw=0, footprint=(1.1, 1.1))
    room.mark("hatch", -x + 1.75, -y + 1.9, 180, "enter", "exit", "trapdoor", "hatch")
    room.furnish("chest", x - 1.05, 0.95, yaw=-70)
    room.furnish("standing_mirror", -x + 1.15, y - 0.9, yaw=40)
    room.furnish("cardboard_box", x - 0.85, y - 0.75, yaw=15)
    room.furnish("cardboard_box", x - 1.35, y - 0.6, yaw=-20, required=False)
    room.furnish("suitcase", x - 0.75, -0.2, yaw=80, required=False)
    room.furnish("crate", -x + 0.85, 0.4, yaw=8, required=False)
    room.furnish("cardboard_box", -x + 0.8, 1.25, yaw=-12, required=False)
    room.furnish("rocking_chair", -x + 1.3, -0.25, yaw=70, required=False)
    room.furnish("dresser", -1.35, y - 0.32, required=False)
    room.furnish("floor_lamp", 1.2, y - 0.5, required=False)
    room.furnish("cradle", x - 1.0, -y + 1.9, yaw=-80, required=False)
    room.hang("lantern" if params.period == "past" else "pendant_lamp", 0, -y * 0.28, low=2.1)
    return room.finish()


KIT = SetKit(
    key="attic", name="Attic", tags=("attic", "loft", "garret", "hayloft", "crawlspace", "eaves", "attic room"),
    indoor=True, room="bedroom", draw=draw, width=Span(6.4, 6.8, 9.0), depth=Span(6.2, 7.0, 10.0),
    height=Span(3.1, 3.3, 3.8), has=("trapdoor", "skylight", "hatch", "beam", "rafter", "roof"),
    means={"trunk": "chest", "box": "cardboard_box"},
)  # fmt: skip
