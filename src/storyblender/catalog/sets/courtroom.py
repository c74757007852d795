"""Set kit: a courtroom: the judge's bench under the seal, witness stand, jury, dock, counsel's tables."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a courtroom: the bench at the back, jury and dock at the sides, the well free, the public in front."""
    modern = params.period == "modern"
    look = Finishes("plaster_cream", "parquet", "ceiling_white", dado="dado_brown", dado_height=1.45)
    room = Room("courtroom", params, rng, look, view="facades")
    x, y, h = room.half_x, room.half_y, params.height
    room.door("right", -y + 1.2, width=1.5, height=2.4, style="double")
    room.door("back", x - 1.0, height=2.2, name="chambers")
    for at in (-y * 0.45, y * 0.1, y * 0.65):
        room.window("left", at, width=1.2, height=2.0, sill=min(2.1, h - 2.2), style="grid", mark=at < 0)
    for at in (-0.4, y * 0.55):
        room.window("right", at, width=1.2, height=1.6, sill=min(2.3, h - 1.8), style="grid")
    _public(room)
    _bench(room)
    _jury(room)
    room.piece("court_box", -x + 1.0, 0.4, yaw=90, width=1.7, depth=1.3, rail=True)
    room.mark("dock", -x + 0.95, 0.4, 90, "dock", "accused", "defendant", "prisoner")
    for side, tags in ((-1, ("defence", "lawyer", "attorney")), (1, ("prosecutor", "prosecution", "da"))):
        px, py = side * 2.3, -1.75
        room.furnish("dining_table", px, py, width=1.7, depth=0.75)
        for off in (-0.42, 0.42):
            room.furnish("chair", px + off, py - 0.62, yaw=180, required=off < 0)
        room.mark(f"counsel_{'left' if side < 0 else 'right'}", side * 1.05, -1.2, 180, "table", *tags)
    for px in (-x * 0.5, x * 0.5):
        for py in (-y * 0.4, y * 0.4):
            room.piece("ceiling_light", px, py, h, modern=modern)
            room.lamp("ceiling_light", (px, py, h - 0.3), 34, WARM, kind="AREA", size=0.6)
    return room.finish()


def _bench(room: Room) -> None:
    """Set the judge's bench, flags, seal, the witness stand and the clerk's place."""
    y, h = room.half_y, room.height
    room.piece("judges_bench", 0, y - 1.95, footprint=(3.3, 0.75), width=3.3)
    room.furnish("armchair", 0, y - 0.55, color="#3a2018", required=False)
    room.mark("judges_bench", 0, y - 1.28, 0, "judge", "magistrate", "justice", "bench")
    room.slab("patch", rectangle(-2.0, y - 2.5, 2.0, y - 0.05), "cloth_red", z=0.012)
    room.piece("court_seal", 0, y, min(h - 0.75, 2.75), footprint=(1.1, 0.2), wild=True)
    for side in (-1, 1):
        room.furnish("flag", side * 1.75, y - 0.45, required=False, color="#23385c" if side < 0 else "#7a1d20")
    room.piece("court_box", 2.65, y - 1.65, yaw=-12, width=1.25, depth=1.2)
    room.furnish("chair", 2.68, y - 1.45, yaw=-12)
    room.mark("witness", 2.65, y - 1.95, 348, "witness", "witness_stand", "witness_box", "stand")


def _jury(room: Room) -> None:
    """Set two rows of chairs behind the jury's panel along the right wall."""
    x = room.half_x
    room.piece("court_box", x - 1.15, 0.75, yaw=-90, width=3.0, depth=2.2)
    for row in range(2):
        for seat in range(4):
            room.furnish("chair", x - 0.45 - 0.85 * row, -0.3 + 0.7 * seat, yaw=270, required=False)
    room.mark("jury", x - 1.75, 0.75, 270, "juror", "jury", "foreman", "jury_box")


def _public(room: Room) -> None:
    """Fence off the public and seat it."""
    x, y = room.half_x, room.half_y
    py = -y + 2.2
    room.mark("gallery", 0.6, py - 0.3, 180, "gallery", "bench", "public", "spectator", "reporter")
    for side in (-1, 1):
        length = x - 0.75
        room.piece("court_rail", side * (0.65 + length / 2), py, length=round(length, 2))
        for row in range(2):
            for bench in range(max(1, int((x - 0.8) // 1.9))):
                px = side * (1.75 + 1.9 * bench)
                room.furnish("pew", px, py - 0.75 - 0.8 * row, yaw=180, required=False)


KIT = SetKit(
    key="courtroom", name="Courtroom",
    tags=("courtroom", "court room", "court", "courthouse", "tribunal", "court house", "trial", "hearing room",
        "courtroom gallery"),
    indoor=True, draw=draw, width=Span(10.4, 10.8, 14.0), depth=Span(10.4, 10.8, 14.0), height=Span(3.8, 4.2, 5.0),
    has=("dock", "jury box", "witness box", "witness stand", "judge's bench", "rail", "box", "stand", "bench",
        "public gallery", "gallery"),
    means={"bench": "pew", "podium": "lectern"},
)  # fmt: skip
