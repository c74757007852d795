"""Set kit: a basement: rough walls under the joists, the boiler and its pipes, stairs."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a basement: the stairs at the left wall, the boiler in the right corner, old things along the walls."""
    past = params.period == "past"
    look = (
        Finishes("stone", "flagstones", "ceiling_dark", beams=8)
        if past
        else Finishes("brick_brown", "concrete_dark", "ceiling_dark", beams=8, dado="plaster_soot", dado_height=1.1)
    )
    room = Room("basement", params, rng, look, view="none" if past else "facades", thickness=0.4)
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.5, style="plank", name="cellar_door")
    if not past:
        room.window("back", x * 0.1, width=0.9, height=0.4, sill=h - 0.62, style="grid", mark=True)
    run = min(3.4, params.depth - 1.4)
    room.piece(
        "stairs", -x + 0.5, y - run / 2 - 0.15, 0, 90, footprint=(run, 1.0), height=h, width=0.95, run=run,
        material="boards_grey", hatch=True,
    )  # fmt: skip
    room.mark("stairs", -x + 0.5, y - run - 0.6, 180, "enter", "exit", "stairs")
    if past:
        for index in range(3):
            room.furnish("barrel", x - 0.5, y - 0.5 - 0.72 * index, required=index == 0)
        room.furnish("barrel", x - 1.2, y - 0.5, required=False)
    else:
        room.furnish("boiler", x - 0.7, y - 0.7)
        room.piece("pipes", x * 0.1, y - 0.12, h - 0.32, 0, length=params.width - 0.4)
    room.piece("pipes", x - 0.12, 0, h - 0.32, 90, length=params.depth - 0.2)
    room.against("back", "store_shelf", -x + 1.9, 0.25, material="wood_gray", rows=4.0, fill=0.7)
    room.against("back", "workbench", 0.35, 0.4, required=False)
    for px, py, yaw, size in (
        (x - 0.5, -y + 0.5, 8, 0.55), (x - 1.15, -y + 0.45, -14, 0.45), (x - 0.45, y * 0.05 + 0.25, 20, 0.5),
        (-x + 1.1, -y + 0.4, 11, 0.4),        (-x + 0.45, -y + 0.45, -6, 0.6),
    ):  # fmt: skip
        room.furnish(
            "cardboard_box" if not past else "crate",
            px,
            py,
            yaw=yaw,
            required=False,
            width=size,
            depth=size * 0.85,
            height=size * 0.8,
        )
    room.furnish("chest", -x + 0.6, -y + 1.25, yaw=90, required=False)
    room.furnish("ladder", x - 0.14, -y * 0.02 - 0.75, yaw=-90, required=False)
    room.furnish("broom", -x + 1.25, y - 0.12, required=False)
    room.hang("lantern" if past else "pendant_lamp", 0.1, y * 0.25, low=1.95)
    room.lamp(
        "stairs_light", (-x + 0.6, y - 0.6, h - 0.25), 10, WARM, kind="AREA", size=0.7, target=(-x + 0.5, y - 2.0, 0)
    )
    return room.finish()


KIT = SetKit(
    key="basement", name="Basement", tags=("basement", "cellar", "boiler room", "coal cellar", "crawl space"),
    indoor=True, room="work", draw=draw, width=Span(6.2, 6.8, 10.0), depth=Span(5.8, 6.2, 9.0),
    height=Span(2.4, 2.6, 3.0), means={"jewel_box": "cardboard_box", "bookshelf": "store_shelf"},
)  # fmt: skip
