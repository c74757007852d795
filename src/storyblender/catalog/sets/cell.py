"""Set kit: a prison cell: stone or concrete, a cot, a bucket, a barred window high up."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a prison cell: the cell and its bars on the right, behind which a corridor runs."""
    past = params.period == "past"
    look = Finishes(
        "stone_dark" if past else "concrete_light", "flagstones" if past else "concrete_dark", "concrete_dark"
    )
    room = Room("cell", params, rng, look, view="skyline", thickness=0.3)
    x, y = room.half_x, room.half_y
    room.window("back", -x * 0.1, width=0.8, height=0.6, sill=params.height - 0.95, style="bars", mark=True)
    room.door("right", -0.2, width=1.1, height=2.1, style="cell")
    room.against("left", "bed", y - 0.62, 1.1, width=0.85)
    room.mark("bed", -x + 1.4, y - 1.3, 90, "bed")
    room.against("right", "stool", -y * 0.6, 0.5, required=False)
    room.against("back", "bucket" if past else "sink", x - 0.55, 0.35, required=False)
    if past:
        room.hang("lantern", 0.3, 0)
        room.piece("straw", -x * 0.1, -y * 0.55, scale=1.2)
    else:
        room.piece("ceiling_light", 0, 0, params.height, modern=False)
        room.lamp("ceiling_light", (0, 0, params.height - 0.16), 30, COOL, kind="AREA", size=0.35)
    return room.finish()


KIT = SetKit(
    key="cell", name="Prison cell",
    tags=("prison cell", "cell", "jail", "prison", "holding cell", "brig", "lockup", "cage", "bunker"), indoor=True,
    draw=draw, width=Span(4.0, 4.4, 7.0), depth=Span(4.9, 5.1, 7.0), height=Span(2.6, 2.8, 3.6),
)  # fmt: skip
