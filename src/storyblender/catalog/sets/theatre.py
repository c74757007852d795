"""Set kit: a theatre: the stage with curtains and footlights at the back, rows of seats towards the audience."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a theatre: a bare stage floor with its drapes: people act on it, the stalls lie in front."""
    room = Room(
        "theatre",
        params,
        rng,
        Finishes("plaster_red", "boards_dark", "ceiling_dark", dado="dado_dark", dado_height=1.2),
        view="none",
    )
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", y * 0.5, name="wing_left", tags=("enter", "exit", "door", "left"))
    room.door("right", y * 0.5, name="wing_right", tags=("enter", "exit", "door", "right"))
    room.slab("patch", rectangle(-x + 0.4, -1.9, x - 0.4, y - 0.4), "boards_light", z=0.006)
    room.piece("drape", 0, y - 0.35, width=2 * x - 1.4, height=h - 0.5, color="#741a22")
    for side in (-1, 1):
        room.piece("drape", side * (x - 0.8), y - 1.6, 0, 90.0 * -side, width=1.6, height=h - 0.5, color="#741a22")
        room.piece("drape", side * (x - 0.75), 0.2, 0, 90.0 * -side, width=1.4, height=h - 0.5, color="#5e141b")
    room.piece("valance", 0, -1.7, h - 1.15, width=2 * x - 0.6, height=0.9, color="#741a22")
    for index in range(7):
        px = -x + 1.2 + index * (2 * x - 2.4) / 6
        room.piece("footlight", px, -2.0)
        if index % 2 == 0:
            room.lamp("footlight", (px, -1.85, 0.25), 8, WARM, kind="SPOT", target=(px, 1.2, 1.4), cone=110, glow=0.05)
    for row in range(max(1, int((y - 2.6) // 1.0))):
        py = -2.95 - 1.0 * row
        for seat in range(int((2 * x - 1.2) // 0.62)):
            px = -x + 0.9 + 0.62 * seat
            if abs(px) > 0.5:
                room.furnish("chair", px, py, yaw=180, required=False)
    for px in (-x * 0.45, x * 0.45):
        room.lamp(
            "spotlight",
            (px * 1.3, -y + 0.6, h - 0.5),
            900,
            WARM,
            kind="SPOT",
            target=(px * 0.2, 0.6, 0.8),
            cone=34,
            glow=0.1,
            size=0.2,
        )
    room.lamp("stage_wash", (0, 0.2, h - 0.3), 90, WARM, kind="AREA", size=3.0)
    room.mark("front_of_stage", 0, -1.2, 0, "table", "bar")
    return room.finish()


KIT = SetKit(
    key="theatre", name="Theatre",
    tags=("theatre", "theater", "stage", "cinema", "opera", "concert hall", "dressing room", "backstage"),
    indoor=True, draw=draw, width=Span(9.0, 10.5, 16.0), depth=Span(9.0, 11.0, 16.0), height=Span(4.2, 5.0, 7.0),
)  # fmt: skip
