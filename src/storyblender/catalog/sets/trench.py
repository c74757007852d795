"""Set kit: a trench: mud and duckboards between earth walls held by planks, sandbags on top."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import CANDLE, SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span

_DEEP = 1.75
"""Metres from the trench's floor to the land."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a trench along x: people on its floor, its far wall behind them, the near one away for cameras."""
    trench = Ground("trench", params, rng)
    x, y = trench.half_x, trench.half_y
    trench.slab("ground", rectangle(-REACH, -REACH, REACH, REACH), "mud")
    trench.slab("patch", rectangle(-14, -0.6, 14, 0.6), "planks_gray", z=0.012)
    for px in (-10.0, 0.0, 10.0):
        trench.piece("trench_wall", px, y + 0.1, 0, footprint=(10.0, 0.4), length=10.0, height=_DEEP, seed=px + 11)
    trench.piece("trench_wall", -x - 4.5, -1.0, 0, 65, length=10.0, height=_DEEP, seed=3.0)
    trench.piece("trench_wall", x + 4.5, -1.0, 0, -65, length=10.0, height=_DEEP, seed=4.0)
    for px in (-8.0, -2.5, 3.0, 8.5):
        trench.piece("barbed_wire", px, y + 3.0, _DEEP, length=5.4)
    trench.furnish("crate", -x + 0.8, y - 0.7)
    trench.furnish("ladder", x * 0.45, y - 0.45, required=False)
    trench.furnish("crate", -x + 1.75, y - 0.6, yaw=12, required=False)
    trench.furnish("barrel", x - 0.7, y - 0.6, required=False)
    trench.mark("parapet", 0.0, y - 0.55, 180, "window", "parapet", "edge", "sandbags", "bar")
    trench.lamp("lantern", (-x + 0.8, y - 0.9, 1.2), 14, CANDLE, glow=0.2)
    for px, py in ((-9.0, 12.0), (5.0, 15.0), (13.0, 11.0)):
        trench.furnish("dead_tree", px, py, _DEEP - 0.1, required=False)
    trench.ring("hills", 46, 5.5)
    trench.ring("hills", 70, 9.0)
    trench.entrances(back=False)
    return trench.finish()


KIT = SetKit(
    key="trench", name="Trench",
    tags=("trench", "battlefield", "trenches", "front line", "no man's land", "foxhole", "dugout", "war zone"),
    indoor=False, draw=draw, width=Span(8.0, 9.0, 16.0), depth=Span(3.0, 3.4, 5.0),
    has=("sandbag", "wire", "parapet", "trench", "wall", "duckboard"),
)  # fmt: skip
