"""Set kit: a swimming pool: blue water with its lanes, light tiles around, loungers and sunshades, a diving board."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a swimming pool: the terrace people act on, the water behind it, hedges and palms around."""
    pool = Ground("pool", params, rng)
    x, y = pool.half_x, pool.half_y
    long, wide = x + 1.0, 6.5
    pool.slab("ground", rectangle(-REACH, -REACH, REACH, REACH), "grass_lush", z=-0.03)
    pool.slab("patch", rectangle(-x - 4, -y - 4, x + 4, y + wide + 3.5), "paving_light", z=0.0)
    pool.slab("patch", rectangle(-long, y + 0.3, long, y + 0.3 + wide), "pool_water", z=0.012, wet=True)
    pool.piece("pool_rim", 0, y + 0.3 + wide / 2, width=2 * long, depth=wide, lanes=4.0)
    pool.piece("diving_board", -long - 1.1, y + 0.3 + wide / 2, 0, 90)
    pool.mark("water", 0.4, y - 0.2, 180, "window", "water", "edge", "pool")
    for side in (-1, 1):
        for index, px in enumerate((x - 0.8, x - 2.1)):
            pool.furnish("deck_chair", side * px, y - 0.9, yaw=-12.0 * side, required=index == 0)
        pool.furnish("parasol", side * (x + 0.7), y - 0.7, required=False)
    pool.furnish("towel", x - 2.9, y - 2.2, required=False)
    for index in range(-6, 7):
        pool.piece("hedge", index * 2.6, y + wide + 4.0, width=2.6, height=1.4)
    pool.scatter(("palm_tree",), 9, inner=y + wide + 5, outer=30, gap=3.5, sector=(-70, 70))
    pool.scatter(("broad_tree",), 10, inner=16, outer=40, gap=5, sector=(95, 265))
    pool.ring("treeline", 50, 9, sides=14)
    pool.ring("facades", 64, 13)
    pool.entrances(back=False)
    return pool.finish()


KIT = SetKit(
    key="pool", name="Swimming pool", tags=("pool", "swimming pool", "poolside", "hotel pool", "pool deck"),
    indoor=False, draw=draw, width=Span(9.0, 10.0, 16.0), depth=Span(5.0, 6.0, 10.0), period="modern",
    has=("pool", "water", "diving board", "ladder", "swimming pool"),
    means={"chair": "deck_chair", "umbrella": "parasol", "lounger": "deck_chair"},
)  # fmt: skip
