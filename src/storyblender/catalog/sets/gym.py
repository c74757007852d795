"""Set kit: a sports hall: a court with its lines, hoops at both ends, wall bars and benches at the back."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room

_LINE = 0.06


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a sports hall: the court free from wall to wall; everything else stands along the back."""
    modern = params.period == "modern"
    look = Finishes(
        "plaster_cream" if not modern else "plaster_white", "boards_light", "ceiling_white",
        dado="dado_green" if not modern else "paint_blue", dado_height=1.5, beams=6,
    )  # fmt: skip
    room = Room("gym", params, rng, look, view="treeline")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("left", -y * 0.7, width=1.6, height=2.3, style="double")
    room.door("back", x * 0.84, width=1.0, style="panel", name="locker_door")
    for at in np.linspace(-x * 0.7, x * 0.55, 4):
        room.window("back", round(float(at), 3), width=1.8, height=1.2, sill=h - 1.7, style="grid")
    _court(room)
    for side, yaw in ((-1, 90), (1, 270)):
        room.piece("basketball_hoop", side * x, 0.0, 0.0, yaw)
    for at in (-x * 0.62, -x * 0.2, x * 0.22):
        room.piece("wall_bars", at, y, footprint=(2.5, 0.4), width=2.4)
    for index, at in enumerate((-x * 0.42, x * 0.02)):
        room.furnish("bench", at, y - 0.85, required=index == 0, width=2.4)
    room.mark("bench", -x * 0.42, y - 1.7, 180, "bench")
    room.furnish("ball", x * 0.6, y - 1.6, required=False)
    room.furnish("ball", x * 0.52, y - 1.75, required=False)
    room.on_wall("left", "wall_clock", y * 0.55, 2.9, width=0.5, height=0.5)
    room.on_wall("right", "notice_board", -y * 0.55, 1.6)
    room.against("front", "bench", -x * 0.4, 0.4, required=False, width=2.4)
    for px in np.linspace(-x * 0.6, x * 0.6, 3):
        for py in (-y * 0.45, y * 0.4):
            at = round(float(px), 3)
            room.piece("ceiling_light", at, py, h, modern=True)
            room.lamp("ceiling_light", (at, py, h - 0.12), 70, COOL, kind="AREA", size=1.2)
    return room.finish()


def _court(room: Room) -> None:
    """Paint the lines of the court."""
    x, y = room.half_x - 0.9, room.half_y - 1.9
    edges = (
        (-x, -y, x, -y + _LINE), (-x, y - _LINE, x, y), (-x, -y, -x + _LINE, y), (x - _LINE, -y, x, y),
        (-_LINE / 2, -y, _LINE / 2, y),
    )  # fmt: skip
    for edge in edges:
        room.slab("patch", rectangle(*edge), "paint_white", z=0.004)
    for side in (-1, 1):
        near, far = sorted((side * x, side * (x - 3.0)))
        for at in (-1.6, 1.6 - _LINE):
            room.slab("patch", rectangle(near, at, far, at + _LINE), "paint_red", z=0.005)
        inner = side * (x - 3.0)
        room.slab("patch", rectangle(inner - _LINE / 2, -1.6, inner + _LINE / 2, 1.6), "paint_red", z=0.005)


KIT = SetKit(
    key="gym", name="Sports hall",
    tags=("gym", "gymnasium", "school gym", "sports hall", "basketball court", "dojo", "dance studio", "ballet studio",
        "rehearsal room", "training room"),
    indoor=True, draw=draw, width=Span(12.0, 14.0, 20.0), depth=Span(9.0, 10.5, 14.0), height=Span(4.4, 5.2, 6.5),
)  # fmt: skip
