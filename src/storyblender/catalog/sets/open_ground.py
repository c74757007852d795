"""Set kit: open ground: a field with grass, a fence, a few trees and hills far off. The outdoor fallback."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an open ground: a meadow with its middle free."""
    field = Ground("open_ground", params, rng)
    x, y = field.half_x, field.half_y
    field.land("grass_dry" if params.option("dry") else "grass_lush", relief=1.6, rise=0.02)
    field.scatter(("grass_tuft",), 260, inner=1.8, outer=20, gap=0.35, scale=(0.7, 1.4), sunk=0.02)
    field.scatter(("bush",), 14, inner=max(x, y) + 1, outer=34, gap=2.5, scale=(0.8, 1.6), sector=(-100, 100))
    field.scatter(("broad_tree",), 14, inner=max(x, y) + 5, outer=48, gap=6, scale=(0.8, 1.25), sector=(-110, 110))
    field.scatter(("broad_tree",), 8, inner=20, outer=45, gap=7, sector=(115, 245))
    field.scatter(("rock",), 8, inner=3.5, outer=16, gap=2, scale=(0.5, 1.2), solid=0.6)
    for index in range(5):
        px = -x + (index - 0.4) * 2.05
        field.piece("fence", px, y + 0.8, field.height(px, y + 0.8), width=2.05, style="rail", footprint=(2.05, 0.15))
    field.ring("hills", 80, 17)
    field.ring("treeline", 70, 9, sides=14)
    field.entrances()
    return field.finish()


KIT = SetKit(
    key="open_ground", name="Open ground",
    tags=("meadow", "countryside", "pasture", "open ground", "hillside", "plain", "prairie", "outside", "moor",
        "moorland", "heath", "snowy hill", "camp", "valley", "hill", "exterior"),
    indoor=False, draw=draw, width=Span(8.0, 12.0, 24.0), depth=Span(7.0, 10.0, 20.0), options={"dry": False},
)  # fmt: skip
