"""Set kit: a porch: the front of a wooden house, door and windows, posts and rail, steps down to the lawn."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span

_DROP = 0.5
"""Metres that the lawn lies lower."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a porch: the boards people stand on, the house behind them, the lawn below with its trees and fence."""
    porch = Ground("porch", params, rng)
    x, y = porch.half_x, porch.half_y
    steps = x * 0.36
    porch.slab("ground", rectangle(-REACH, -REACH, REACH, REACH), "grass", z=-_DROP)
    porch.slab("block", rectangle(-x - 0.05, -y - 0.05, x + 0.05, y + 0.3), "boards_grey", thickness=_DROP)
    porch.slab("patch", rectangle(steps - 0.7, -y - 14, steps + 0.7, -y - 0.9), "gravel", z=-_DROP + 0.012)
    color = porch.choose(("#b9bdb2", "#a9b7bd", "#c9bd9c", "#b6a79a"))
    porch.piece("house_front", 0, y + 0.12, 0, footprint=(2 * x + 1.6, 0.2), width=2 * x + 1.6, color=color, door=-0.6)
    porch.piece("porch_roof", 0, y + 0.1, 0, width=2 * x, depth=2 * y + 0.1, steps=steps)
    porch.furnish("porch_swing", -x * 0.62, y - 0.62)
    porch.furnish("rocking_chair", x * 0.72, y - 0.75, yaw=-15)
    porch.furnish("side_table", x * 0.72 - 0.75, y - 0.5, required=False)
    porch.furnish("potted_plant", 0.35, y - 0.35, required=False)
    porch.furnish("wall_lamp", -1.45, y + 0.05, 1.9, required=False)
    porch.lamp("porch_light", (0.2, y - 0.7, 2.5), 34, WARM, size=0.15, glow=0.2)
    for px in (-x - 2.5, x + 3.0):
        porch.piece("broad_tree", px, -y - 6.5, -_DROP, scale=0.9, variant=1.0 if px < 0 else 2.0)
    for index in range(-6, 7):
        if abs(2.0 * index - steps) > 1.2:
            porch.piece("fence", 2.0 * index, -y - 12.5, -_DROP, width=2.0)
    for px in (-x * 0.7, -x * 0.2, x * 0.85):
        porch.piece("bush", px, -y - 0.75, -_DROP, scale=0.55, variant=1.0)
    for azimuth in (60.0, 120.0, 240.0, 300.0):
        porch.scatter(("broad_tree",), 3, inner=16, outer=30, gap=4, sunk=_DROP, sector=(azimuth - 25, azimuth + 25))
    porch.ring("treeline", 46, 9.0)
    porch.mark("centre", 0.2, -0.1, 0, "centre")
    porch.mark("door", -0.6, y - 0.55, 0, "enter", "exit", "door", "back")
    porch.mark("steps", steps, -y + 0.4, 180, "enter", "exit", "steps")
    return porch.finish()


KIT = SetKit(
    key="porch", name="Porch",
    tags=("porch", "veranda", "verandah", "front porch", "back porch", "doorstep", "front door", "front steps", "stoop",
        "house porch"),
    indoor=False, draw=draw, width=Span(8.4, 9.0, 14.0), depth=Span(3.4, 3.6, 5.0),
    has=("step", "steps", "door", "front door", "rail", "railing", "porch", "house", "doorstep", "doorway", "post"),
    means={"swing": "porch_swing", "bench": "porch_swing", "chair": "rocking_chair"},
)  # fmt: skip
