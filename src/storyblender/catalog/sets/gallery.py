"""Set kit: a museum: white rooms with paintings under spots, statues, a glass case, benches to look from."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a museum: paintings along the walls, statues in the corners, cases at the sides, the middle free."""
    look = Finishes("plaster_red" if params.period != "modern" else "plaster_white", "parquet", "ceiling_white",
                    dado="dado_white", dado_height=0.7)  # fmt: skip
    room = Room("gallery", params, rng, look, view="none")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y * 0.5, width=1.6, height=2.7, style="arch")
    room.door("left", -y * 0.5, width=1.6, height=2.7, style="arch", name="next_room")
    sizes = ((1.1, 1.5), (2.4, 1.6), (1.1, 1.5))
    for at, (wide, tall) in zip((-x * 0.58, 0.0, x * 0.58), sizes, strict=True):
        room.on_wall("back", "picture", at, 1.05, width=wide, height=tall)
        room.lamp("spot", (at, y - 1.5, h - 0.2), 24, WARM, kind="SPOT", target=(at, y, 1.7), cone=60, role="set")
        room.mark(f"picture_{len(room.marks)}", at, y - 1.3, 180, "window", "painting", "picture")
    for side in ("left", "right"):
        room.on_wall(side, "picture", y * 0.3, 1.15, width=1.5, height=1.2)
    room.piece("barrier_rope", 0, y - 0.8, length=round(x * 1.6, 2))
    for side in (-1, 1):
        room.furnish("statue", side * (x - 0.7), y - 0.7, yaw=-25.0 * side, required=side < 0)
        room.piece("glass_case", side * (x - 1.0), -y * 0.1, 0, -90.0 * side, footprint=(1.2, 0.7), variant=1.0 + side)
    room.furnish("bench", -1.0, -y + 1.6, yaw=180, required=False)
    room.furnish("bench", 1.2, -y + 1.6, yaw=180, required=False)
    for px in (-x * 0.5, x * 0.5):
        for py in (-y * 0.4, y * 0.3):
            room.piece("ceiling_light", px, py, h, modern=True)
            room.lamp("ceiling_light", (px, py, h - 0.15), 34, WARM, kind="AREA", size=1.0)
    return room.finish()


KIT = SetKit(
    key="gallery", name="Museum",
    tags=("museum", "gallery", "art gallery", "exhibition", "exhibition hall", "museum hall", "museum gallery"),
    indoor=True, draw=draw, width=Span(8.4, 9.6, 15.0), depth=Span(7.6, 8.6, 14.0), height=Span(3.4, 3.8, 5.0),
    has=("display case", "glass case", "rope", "showcase", "case", "plinth", "exhibit"),
)  # fmt: skip
