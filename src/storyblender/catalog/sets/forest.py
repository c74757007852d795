"""Set kit: a forest clearing: rolling ground, broad trees and pines all around, a fallen log, stones, undergrowth."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a forest: a clearing; a lane in front stays open for the camera, one at the back for the sun."""
    wood = Ground("forest", params, rng)
    x, y = wood.half_x, wood.half_y
    edge = max(x, y)
    wood.land("forest_floor", relief=2.0, rise=0.05)
    lanes = (((0.0, -2.0), (4.0, -22.0), 3.0), ((0.0, 2.0), (-7.0, 26.0), 1.6))
    if params.option("palms"):
        kinds, under = ("palm_tree", "broad_tree"), ("fern", "fern", "grass_tuft")
    else:
        kinds = ("pine_tree",) if params.option("pines") else ("broad_tree", "pine_tree", "broad_tree")
        under = ("grass_tuft", "fern")
    wood.scatter(kinds, 90, inner=edge + 0.6, outer=50, gap=1.9, scale=(0.75, 1.25), clear=lanes, sunk=0.1, solid=0.7)
    wood.scatter(("bush",), 32, inner=edge - 0.4, outer=24, gap=1.3, scale=(0.6, 1.3), clear=lanes)
    wood.scatter(under, 300, inner=1.5, outer=18, gap=0.3, scale=(0.7, 1.5), sunk=0.02)
    wood.scatter(("rock",), 10, inner=3.2, outer=12, gap=1.4, scale=(0.4, 1.0), clear=lanes)
    wood.furnish("log", -x * 0.2, y * 0.45, wood.height(-x * 0.2, y * 0.45), 8)
    wood.mark("log", -x * 0.2, y * 0.45 - 0.7, 180, "table", "seat")
    wood.ring("treeline", 54, 17, sides=14)
    wood.ring("treeline", 62, 22, sides=14)
    wood.ring("hills", 84, 26)
    wood.entrances()
    return wood.finish()


KIT = SetKit(
    key="forest", name="Forest",
    tags=("forest", "wood", "woods", "clearing", "grove", "woodland", "trail", "path", "undergrowth", "wilderness"),
    indoor=False, draw=draw, width=Span(8.0, 9.0, 16.0), depth=Span(7.0, 8.0, 14.0),
    options={"pines": False, "palms": False},
)  # fmt: skip
