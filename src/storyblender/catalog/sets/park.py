"""Set kit: a park: lawn, a gravel path, benches, lampposts, hedges and old trees, houses beyond."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a park: the path across the stage, benches along it, planting behind."""
    park = Ground("park", params, rng)
    x, y = park.half_x, park.half_y
    park.level("grass_lush")
    park.slab("patch", rectangle(-REACH, -1.6, REACH, 1.3), "gravel", z=0.008)
    for px in (-x * 0.55, x * 0.55):
        park.furnish("park_bench", px, 2.0, required=px < 0)
        park.mark(f"bench_{'left' if px < 0 else 'right'}", px, 1.1, 0, "table", "seat")
    for px in (-x - 1.5, 0.0, x + 1.5):
        park.furnish("lamppost", px, 2.4, required=px == 0.0)
    for index in range(9):
        px = (index - 4) * 2.6
        park.piece("hedge", px, y + 0.6, width=2.6, height=park.between(0.95, 1.1), footprint=(2.6, 0.7))
    lanes = (((-60.0, -0.2), (60.0, -0.2), 2.6),)
    park.scatter(
        ("broad_tree",), 22, inner=y + 2, outer=46, gap=4.5, sector=(-105, 105), clear=lanes, scale=(0.85, 1.3)
    )
    park.scatter(("broad_tree",), 9, inner=12, outer=45, gap=6, sector=(120, 240), clear=lanes)
    park.scatter(
        ("flowers",), 36, inner=2.6, outer=10, gap=0.4, sector=(-85, 85), clear=lanes, scale=(0.7, 1.2), sunk=0.0
    )
    park.scatter(("grass_tuft",), 160, inner=2.2, outer=16, gap=0.4, clear=lanes, scale=(0.4, 0.8), sunk=0.02)
    park.furnish("trash_can", x * 0.55 + 1.4, 2.0, required=False)
    park.ring("treeline", 56, 13, sides=14)
    park.ring("facades", 70, 15)
    park.entrances()
    return park.finish()


KIT = SetKit(
    key="park", name="Park", tags=("park", "garden", "orchard", "courtyard", "estate"), indoor=False, draw=draw,
    width=Span(9.0, 12.0, 22.0), depth=Span(6.0, 8.0, 16.0), has=("house", "building", "hedge"),
)  # fmt: skip
