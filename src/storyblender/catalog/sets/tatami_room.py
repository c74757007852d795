"""Set kit: a Japanese room: mats, paper screens, a low table with cushions, an alcove with a scroll and a vase."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_MAT = (0.91, 1.82)
"""Metres of a mat."""
_BORDER = 0.03


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a room of mats: screens along three sides, the alcove at the back, the table behind a free middle."""
    look = Finishes("plaster_ochre", "tatami", "boards_dark", beams=6, outside="gravel")
    room = Room("tatami_room", params, rng, look, view="treeline")
    x, y, h = room.half_x, room.half_y, params.height
    for at in (-x * 0.52, x * 0.06):
        room.window("back", at, width=1.7, height=1.75, sill=0.12, style="paper", mark=at > 0)
    for side in ("left", "right"):
        room.window(side, y * 0.3, width=2.2, height=1.75, sill=0.12, style="paper")
    room.door("left", -y * 0.5, width=1.1, height=1.9, style="paper")
    _mats(room)
    alcove = x - 0.85
    room.slab("patch", rectangle(alcove - 0.8, y - 0.75, alcove + 0.8, y), "boards_dark", z=0.02)
    for at in (alcove - 0.84, alcove + 0.82):
        room.piece("column_post", at, y - 0.7, footprint=(0.12, 0.12), height=h)
    room.on_wall("back", "hanging_scroll", alcove, 1.0)
    room.furnish("vase", alcove, y - 0.4, 0.02, required=False)
    room.furnish("coffee_table", -0.5, y - 0.95, height=0.34)
    for dx, dy, yaw in ((-0.95, 0.0, 90), (0.95, 0.0, 270)):
        room.furnish("floor_cushion", -0.5 + dx, y - 0.95 + dy, yaw=yaw)
    room.mark("table", -0.5, y - 1.9, 180, "table")
    room.furnish("brazier", -x + 0.75, y - 1.1, required=False)
    room.furnish("teapot", -x + 0.75, y - 1.1, 0.4, required=False)
    room.furnish("folding_screen", -x + 0.8, -y + 0.6, yaw=150, required=False)
    room.hang("paper_lantern", 0.0, 0.1, low=1.9)
    room.lamp("lantern", (0.0, 0.1, 1.9), 14, WARM)
    return room.finish()


def _mats(room: Room) -> None:
    """Lay the borders of mats, every other row turned by half a mat."""
    x, y = room.half_x, room.half_y
    row, at = 0, -y
    while at < y - 0.05:
        room.slab("patch", rectangle(-x, at, x, min(at + _BORDER, y)), "mat_border", z=0.004)
        left = -x + _MAT[1] * (0.5 if row % 2 else 1.0)
        while left < x - 0.05:
            room.slab("patch", rectangle(left, at, left + _BORDER, min(at + _MAT[0], y)), "mat_border", z=0.004)
            left += _MAT[1]
        row, at = row + 1, at + _MAT[0]


KIT = SetKit(
    key="tatami_room", name="Room of mats",
    tags=("tea house", "teahouse", "tea ceremony", "ryokan", "japanese house", "japanese room", "geisha house", "okiya",
        "zen temple", "washitsu", "minka"),
    indoor=True, draw=draw, width=Span(6.6, 7.2, 9.0), depth=Span(5.8, 6.2, 8.0), height=Span(2.3, 2.45, 2.8),
    period="past",
    means={"screen": "folding_screen", "cushion": "floor_cushion", "pillow": "floor_cushion", "kettle": "teapot",
        "table": "coffee_table"},
    has=("paper screen", "screen", "mat", "alcove"),
)  # fmt: skip
