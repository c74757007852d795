"""Set kit: a beach: sand down to the water, the sea to the horizon, dunes with grass behind the audience."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a beach: the waterline behind the stage; rocks and driftwood at the sides."""
    beach = Ground("beach", params, rng)
    x, y = beach.half_x, beach.half_y
    shore = y + 1.5
    beach.slab("ground", rectangle(-REACH, -REACH, REACH, shore + 4), "sand")
    beach.slab("patch", rectangle(-REACH, shore - 1.4, REACH, shore + 4), "gravel", z=0.006, wet=True)
    beach.slab("ground", rectangle(-REACH * 1.6, shore, REACH * 1.6, REACH * 1.6), "water", z=0.012, wet=True)
    beach.piece("surf", 0, shore, length=150.0)
    beach.scatter(("rock",), 12, inner=x + 0.5, outer=20, gap=1.6, sector=(-88, -60), scale=(0.6, 1.8), solid=0.8)
    beach.scatter(("rock",), 9, inner=x + 1, outer=24, gap=2.0, sector=(62, 88), scale=(0.6, 1.6), solid=0.8)
    beach.scatter(("reeds",), 70, inner=y + 4, outer=26, gap=0.7, sector=(120, 240), scale=(0.8, 1.5))
    if params.option("palms"):
        beach.scatter(
            ("palm_tree",), 9, inner=x + 1.5, outer=20, gap=3.2, sector=(-125, -75), scale=(0.8, 1.2), solid=0.4
        )
        beach.scatter(("palm_tree",), 6, inner=x + 2, outer=20, gap=3.2, sector=(75, 125), scale=(0.8, 1.2), solid=0.4)
    if params.option("lighthouse"):
        islet = (-x - 9.0, y + 46.0)  # far enough out that the whole tower is in a wide picture
        beach.piece("lighthouse", *islet, -0.3, footprint=(7.0, 7.0))
        beach.scatter(("rock",), 18, inner=4.0, outer=11.0, gap=1.5, scale=(1.2, 3.0), centre=islet)
    beach.furnish("log", -x * 0.74, y * 0.5, yaw=20, required=False)
    beach.furnish("rowing_boat", x * 0.82, y * 0.5, yaw=-55, required=False)
    beach.mark("water", 0, y - 0.3, 180, "window", "water")
    beach.ring("sea", 140, 1.6, bottom=-6, azimuths=(-95, 95), sides=8)
    beach.ring("hills", 84, 15, azimuths=(78, 282), sides=9)
    beach.ring("treeline", 60, 10, azimuths=(96, 264), sides=8)
    beach.entrances(back=False)
    return beach.finish()


KIT = SetKit(
    key="beach", means={"umbrella": "parasol"}, name="Beach",
    tags=("beach", "shore", "seaside", "coast", "island", "sea", "ocean", "cove", "lagoon", "waterfront"),
    indoor=False, draw=draw, width=Span(9.0, 12.0, 22.0), depth=Span(6.0, 8.0, 14.0),
    options={"palms": False, "lighthouse": False},
)  # fmt: skip
