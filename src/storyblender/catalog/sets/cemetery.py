"""Set kit: a graveyard: rows of stones in rough grass, a path, an iron fence with its gate, bare and dark trees."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a cemetery: the stones behind and beside a free middle, the path in front, the fence across the back."""
    yard = Ground("cemetery", params, rng)
    x, y = yard.half_x, yard.half_y
    yard.level("grass")
    yard.slab("patch", rectangle(-REACH, -y * 0.75 - 1.0, REACH, -y * 0.75 + 0.4), "gravel", z=0.008)
    for row, py in enumerate((y * 0.5, y - 0.4, y + 1.6, y + 3.6)):
        for index in range(-4, 5):
            px = index * 1.75 + (0.6 if row % 2 else 0.0) + yard.between(-0.2, 0.2)
            if row or abs(px) > 1.6:
                yard.furnish("gravestone", px, py, yaw=yard.between(-7, 7), required=row == 0 and abs(px) < 4.0)
    for side in (-1, 1):
        for index in range(3):
            px = side * (2.5 + 1.7 * index)
            yard.furnish("gravestone", px, -0.3, yaw=yard.between(-8, 8), required=False)
    yard.furnish("statue", x - 1.0, y * 0.2, yaw=-40, required=False)
    yard.mark("grave", 0.9, y * 0.5 - 0.9, 180, "table", "grave", "gravestone")
    for index in range(-5, 6):
        if index:
            yard.piece("railing", index * 4.0, y + 6.2, length=4.0, height=1.5)
    for px in (-2.0, 2.0):
        yard.piece("column", px, y + 6.2, height=2.4, width=0.5, material="stone", style="post")
    lanes = (((-60.0, -y * 0.75), (60.0, -y * 0.75), 2.4),)
    yard.scatter(("broad_tree", "pine_tree"), 14, inner=y + 8, outer=40, gap=4.5, sector=(-80, 80), scale=(0.9, 1.3))
    yard.scatter(("broad_tree",), 8, inner=12, outer=40, gap=6, sector=(110, 250), clear=lanes)
    yard.scatter(("grass_tuft",), 150, inner=1.8, outer=16, gap=0.4, clear=lanes, scale=(0.4, 0.9), sunk=0.02)
    yard.furnish("dead_tree", -x - 5.0, y + 3.0, required=False)
    yard.ring("treeline", 50, 11, sides=14)
    yard.entrances()
    return yard.finish()


KIT = SetKit(
    key="cemetery", name="Cemetery",
    tags=("cemetery", "graveyard", "churchyard", "burial ground", "grave", "graveside", "funeral"), indoor=False,
    draw=draw, width=Span(9.0, 11.0, 20.0), depth=Span(6.0, 7.0, 14.0),
    has=("grave", "headstones", "gate", "fence", "tree"), means={"stone": "gravestone", "cross": "gravestone"},
)  # fmt: skip
