"""Set kit: a stadium: the pitch with its lines and goal, stands full of people on three sides, floodlights."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SetParams, rectangle
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a stadium: the grass in stripes, the goal at the back, stands beyond the touchlines."""
    field = Ground("stadium", params, rng)
    y = field.half_y
    field.level("tarmac")
    for index in range(-7, 8):
        skin = "grass_lush" if index % 2 else "grass"
        field.slab("patch", rectangle(3.0 * index - 1.5, -24, 3.0 * index + 1.5, y + 7), skin, z=0.006)
    for py, long in ((y + 5.5, 42.0), (y - 0.8, 16.0)):
        field.piece("runway_paint", 0, py, 0.01, length=long)
    for px in (-8.0, 8.0):
        field.piece("runway_paint", px, y + 2.35, 0.01, 90, length=6.3)
    field.piece("goal", 0, y + 5.6)
    field.piece("stands", 0, y + 11, 0, length=46.0, seed=1.0)
    for side in (-1, 1):
        field.piece("stands", side * 25, -4, 0, -90.0 * side, length=36.0, seed=2.0 + side)
        field.piece("flood_mast", side * 22, y + 9.5, 3.0, -25.0 * side)
        field.lamp("flood", (side * 16, y + 4, 12.0), 1500, COOL, kind="SPOT", target=(0, 0, 0), cone=70, size=0.6)
    field.lamp("stand_light", (0, y - 2, 14.0), 5200, COOL, kind="SPOT", target=(0, y + 13, 3.0), cone=130, size=1.0)
    field.piece("stands", 0, -27, 0, 180, length=46.0, seed=5.0)
    field.ring("skyline", 80, 20)
    field.entrances()
    return field.finish()


KIT = SetKit(
    key="stadium", name="Stadium",
    tags=("stadium", "football field", "soccer field", "pitch", "soccer pitch", "football pitch", "baseball field",
        "racetrack", "playing field", "track field", "sports field", "ballpark"),
    indoor=False, draw=draw, width=Span(10.0, 14.0, 26.0), depth=Span(8.0, 10.0, 20.0), period="modern",
    has=("goal", "crowd", "stand", "stands", "bleacher", "floodlight", "field", "pitch"),
)  # fmt: skip
