"""Set kit: a mountain ledge: rock and thin grass, pines, cliffs at the sides, peaks beyond."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a mountain: the ledge with a cliff at the left and open air at the right."""
    ledge = Ground("mountain", params, rng)
    x, y = ledge.half_x, ledge.half_y
    ledge.land("grass_dry", relief=2.6, rise=0.05)
    ledge.piece(
        "cliff", -x - 4.5, 2.0, -0.5, 75, footprint=(12, 5), width=13.0, height=9.0, seed=float(rng.integers(99))
    )
    ledge.piece(
        "cliff", -x + 1.0, y + 9.0, -0.5, 15, footprint=(12, 5), width=14.0, height=6.5, seed=float(rng.integers(99))
    )
    ledge.scatter(
        ("rock",), 26, inner=max(x, y) - 1.2, outer=26, gap=1.5, scale=(0.5, 2.0), sector=(-120, 120), solid=0.9
    )
    ledge.scatter(
        ("pine_tree",), 26, inner=max(x, y) + 1.5, outer=44, gap=2.6, scale=(0.5, 1.0), sector=(-110, 110), sunk=0.2
    )
    ledge.scatter(("pine_tree",), 10, inner=14, outer=40, gap=4, scale=(0.5, 1.0), sector=(120, 240), sunk=0.2)
    ledge.scatter(("grass_tuft",), 160, inner=1.6, outer=14, gap=0.4, scale=(0.5, 1.0), sunk=0.02)
    ledge.slab("patch", rectangle(-60, -0.8, 60, 0.9), "dirt", z=0.01)
    ledge.piece("signpost", x * 0.55, 1.5, footprint=(0.2, 0.2))
    ledge.piece("cliff", x + 9.0, y + 12.0, -0.5, -24, footprint=(12, 5), width=16.0, height=10.0, seed=5.0)
    ledge.furnish("rock", x * 0.2, y * 0.6, required=False)
    ledge.furnish("log", -x * 0.4, y * 0.55, yaw=8, required=False)
    ledge.mark("edge", x * 0.6, y - 0.6, 180, "window", "edge")
    ledge.ring("hills", 72, 22, sides=14)
    ledge.ring("hills", 86, 52, sides=14)
    ledge.entrances()
    return ledge.finish()


KIT = SetKit(
    key="mountain", name="Mountain",
    tags=("mountain", "mountains", "mountain pass", "ledge", "peak", "summit", "volcano", "ravine", "gorge"),
    indoor=False, draw=draw, width=Span(8.0, 10.0, 18.0), depth=Span(6.0, 8.0, 14.0),
)  # fmt: skip
