"""Set kit: a laboratory: benches with glassware along the walls, a fume hood, stools, white light."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a laboratory: benches at the back and the right, the hood in the corner, the middle free."""
    old = params.period == "past"
    look = (
        Finishes("limewash", "flagstones", "ceiling_dark", beams=4)
        if old
        else Finishes("plaster_grey", "lino_grey", "ceiling_white", dado="wall_tile", dado_height=1.4)
    )
    room = Room("laboratory", params, rng, look, view="facades")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", -y * 0.35, style="glass" if not old else "panel")
    for at in (-0.35 * y, 0.4 * y):
        room.window("right", at, width=1.3, height=1.1, sill=1.75 if h > 3.0 else 1.6, style="grid")
    back, right = round(2 * x - 2.6, 2), round(2 * y - 2.6, 2)
    room.piece("lab_bench", -x + 0.35 + back / 2, y - 0.4, footprint=(back, 0.75), length=back)
    room.piece("lab_bench", x - 0.4, -0.35, 0, -90, footprint=(right, 0.75), length=right, variant=2.0)
    room.piece("fume_hood", x - 1.05, y, footprint=(1.4, 1.6), height=h)
    room.mark("bench", -x * 0.3, y - 1.15, 180, "table", "bench", "scientist", "microscope")
    room.mark("hood", x - 1.05, y - 1.25, 180, "window")
    room.furnish("bar_stool", -x * 0.55, y - 1.05)
    room.furnish("bar_stool", x - 1.1, -y * 0.25, yaw=90, required=False)
    room.against("left", "cabinet", y * 0.45, 0.3)
    room.against("left", "filing_cabinet", y * 0.45 - 1.15, 0.32, required=False)
    room.against("front", "blackboard", -x * 0.3, 0.3, required=False)
    room.furnish("desk", -x + 1.0, -y + 0.7, yaw=180, required=False)
    for px in (-x * 0.45, x * 0.45):
        for py in (-y * 0.4, y * 0.4):
            if old:
                room.hang("lantern", px, py)
            else:
                room.piece("ceiling_light", px, py, h, modern=True)
                room.lamp("ceiling_light", (px, py, h - 0.12), 30, COOL, kind="AREA", size=0.9)
    room.lamp("hood", (x - 1.05, y - 0.5, 1.9), 6, WARM if old else COOL, kind="AREA", size=0.5, glow=0.05)
    return room.finish()


KIT = SetKit(
    key="laboratory", name="Laboratory",
    tags=("laboratory", "lab", "research lab", "research station", "clean room", "science lab", "pharmacy lab",
        "observatory", "crime lab", "alchemist's workshop"),
    indoor=True, draw=draw, width=Span(7.6, 8.4, 12.0), depth=Span(6.6, 7.2, 10.0), height=Span(2.8, 3.2, 4.0),
    period="modern",
    has=("bench", "lab bench", "shelf", "fume hood", "microscope", "flask", "beaker", "test tube", "burner"),
    means={"stool": "bar_stool", "table": "workbench"},
)  # fmt: skip
