"""Set kit: an airfield: concrete to the horizon, an airliner, a hangar, the tower, runway lights, floodlights."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, WARM, SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an airfield: the apron with its airliner behind the stage."""
    field = Ground("airfield", params, rng)
    x, y = field.half_x, field.half_y
    field.level("tarmac", wet=True)
    field.piece("runway_paint", 0, -1.6, length=120.0, color="#b8912c")
    field.piece("runway_paint", 0, 2.3, length=120.0, color="#d9d5ca")
    field.furnish("airliner", -1.5, y + 17.5, yaw=98)
    field.piece("air_stairs", -6.4, y + 14.0, yaw=8)
    field.piece("hangar", -30, y + 46, yaw=-14, footprint=(34, 30), width=34.0, depth=30.0, height=11.0)
    field.lamp("hangar", (-26, y + 43, 4.5), 1500, WARM, kind="AREA", size=12, target=(-18, y + 14, 0), glow=0.1)
    field.piece("control_tower", 26, y + 44, footprint=(6, 6))
    for index in range(-10, 11):
        field.piece("runway_light", index * 6.0, y + 24, cool=index % 2 == 0)
        field.piece("runway_light", index * 6.0 + 3, -y - 9, cool=False)
        if abs(index) < 5:
            field.lamp("runway_light", (index * 6.0, y + 24, 0.45), 8, COOL if index % 2 == 0 else WARM, glow=0.8)
    for px, py, yaw in ((-x - 6, y + 9, 40.0), (x + 9, y + 11, -35.0)):
        field.piece("flood_mast", px, py, yaw=yaw, footprint=(0.5, 0.5))
        field.lamp("flood", (px, py - 0.3, 9.0), 2400, COOL, kind="SPOT", target=(px * 0.1, 2, 0), cone=80, size=0.5,
                   glow=0.12)  # fmt: skip
    field.vehicle(x - 0.5, y * 0.35, -100, "#1c2024")
    for index, (px, py, size) in enumerate(
        ((-x + 0.9, y - 0.6, 0.8), (-x + 0.1, y - 0.4, 0.7), (-x + 0.8, y - 0.6, 0.0))
    ):
        if size:
            field.furnish("crate", px, py, yaw=10.0 + 30 * index, required=False, width=size, depth=size, height=size)
    for px, py in ((-x + 1.9, y - 0.3), (-x + 2.4, y + 0.2)):
        field.furnish("barrel", px, py, required=False)
    field.mark("stairs", min(5.4, x - 0.6), y - 0.2, 190, "door", "enter", "exit")
    field.ring("hills", 86, 8)
    field.ring("treeline", 82, 5, azimuths=(90, 270), sides=8)
    field.entrances()
    return field.finish()


KIT = SetKit(
    key="airfield", name="Airfield",
    tags=("airfield", "airport", "runway", "tarmac", "airstrip", "landing strip", "air base", "military base",
        "helipad", "launch pad"),
    indoor=False, draw=draw, width=Span(10.0, 14.0, 24.0), depth=Span(6.0, 8.0, 14.0),
)  # fmt: skip
