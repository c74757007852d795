"""Set kit: a workshop: benches under the windows, shelves of boxes, a stove, tools and timber along the walls."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a workshop: work along three walls; the middle is free for what is worked on."""
    old = params.period == "past"
    look = (
        Finishes("log_wall", "boards_dark", "boards_dark", beams=4)
        if old
        else Finishes("brick_pale", "concrete", "ceiling_warm", dado="paint_grey", dado_height=1.1, beams=4)
    )
    room = Room("workshop", params, rng, look, view="facades")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.3, width=2.4, height=2.4, style="double", name="gate")
    room.door("left", -y * 0.6, style="plank" if old else "panel")
    for at in (-x * 0.45, x * 0.2):
        room.window("back", at, width=1.7, height=1.1, sill=1.15, style="grid", mark=at < 0)
    room.against("back", "workbench", -x * 0.45, 0.42)
    room.mark("bench", -x * 0.45, y - 1.3, 180, "table", "workbench")
    room.against("back", "workbench", x * 0.25, 0.42, required=False)
    room.against("back", "toolbox", x * 0.25, 0.42, z=0.9, required=False)
    room.against("back", "wood_stove", x - 0.6, 0.6, required=False)
    room.against("left", "bookshelf" if old else "store_shelf", y * 0.35, 0.3, required=False)
    room.against("left", "cabinet", -y * 0.15, 0.3, required=False)
    room.furnish("stool", -x * 0.45 + 1.2, y - 1.4, yaw=30, required=False)
    for index, size in enumerate((0.6, 0.5, 0.42)):
        px = x - 0.45 - 0.1 * index
        room.furnish("crate", px, y * 0.35 - 0.75 * index, yaw=room.between(-14, 14), required=False,
                     width=size, depth=size, height=size)  # fmt: skip
    room.furnish("barrel", -x + 0.5, -y + 0.6, required=False)
    if not old:
        room.against("right", "ladder", -y + 0.8, 0.2, required=False)
        room.piece("pipes", 0, y - 0.15, h - 0.35, length=2 * x - 0.4)
    for px in (-x * 0.45, x * 0.4):
        room.hang("lantern" if old else "pendant_lamp", px, y * 0.3)
    return room.finish()


KIT = SetKit(
    key="workshop", name="Workshop", tags=("workshop", "forge", "smithy", "shed", "carpentry"), indoor=True,
    room="work", draw=draw, width=Span(6.4, 7.6, 14.0), depth=Span(6.0, 6.8, 11.0), height=Span(2.8, 3.2, 4.5),
    means={"jewel_box": "cardboard_box", "table": "workbench", "torch": "flashlight"},
)  # fmt: skip
