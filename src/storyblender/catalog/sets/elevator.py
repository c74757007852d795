"""Set kit: a lift: steel panels, the doors at the back, a rail, a panel of buttons, light from above."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a lift: an empty car: everything is on its walls."""
    modern = params.period == "modern"
    look = (
        Finishes("sheet_metal", "lino_grey", "ceiling_white", dado="metal_grey", dado_height=0.9)
        if modern
        else Finishes("wood_red", "carpet", "paint_cream", dado="dado_dark", dado_height=0.95)
    )
    room = Room("elevator", params, rng, look, view="none")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("back", -0.1, width=1.3, height=2.12, style="lift", tags=("enter", "exit", "door", "back"))
    room.piece("lift_panel", x - 0.42, y, 0.95, floors=12.0)
    room.mark("buttons", x - 0.55, y - 0.6, 180, "table", "button")
    for side in (-1, 1):
        room.piece("grab_rail", side * x, 0, 0.95, -90.0 * side, length=round(2 * y - 0.5, 2), modern=modern)
        room.piece(
            "lift_mirror", side * x, 0, 1.08, -90.0 * side, width=round(2 * y - 0.7, 2), height=round(h - 1.4, 2)
        )
    for px in (-x * 0.45, x * 0.45):
        room.piece("ceiling_light", px, 0, h, modern=modern)
        room.lamp("ceiling_light", (px, 0, h - 0.14), 16, COOL if modern else WARM, kind="AREA", size=0.7)
    return room.finish()


KIT = SetKit(
    key="elevator", name="Lift", tags=("elevator", "lift", "elevator car", "freight elevator", "service elevator"),
    indoor=True, draw=draw, width=Span(2.8, 2.8, 3.6), depth=Span(2.7, 2.7, 3.6), height=Span(2.4, 2.5, 2.8),
    period="modern", means={"phone": "smartphone", "camera": "security_camera"},
    has=("button", "door", "panel", "elevator", "lift", "mirror", "wall", "handrail", "rail", "hatch"),
)  # fmt: skip
