"""Set kit: a railway platform under the sky: its roof on posts, benches, lamps, rails and a train behind."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span

_DROP = 1.1
"""Metres from the platform down to the track."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a railway platform: two tracks behind it, the train on the far one unless it has come in."""
    platform = Ground("platform", params, rng)
    x, y = platform.half_x, platform.half_y
    edge, modern = y + 0.5, params.period == "modern"
    platform.slab("ground", rectangle(-REACH, -REACH, REACH, edge), "concrete" if modern else "paving", wet=True)
    platform.slab("ground", rectangle(-REACH * 1.6, edge, REACH * 1.6, REACH * 1.6), "gravel", z=-_DROP)
    platform.piece("quay_edge", 0, edge, length=120.0, drop=1.4, material="concrete_light")
    platform.slab(
        "patch", rectangle(-60, edge - 0.8, 60, edge - 0.62), "paint_yellow" if modern else "paint_white", z=0.005
    )
    for track in (0, 1):
        platform.piece("rails", 0, edge + 1.75 + 4.2 * track, -_DROP, length=120.0)
    near = bool(params.option("train"))
    platform.piece("train", 3.0, edge + (1.6 if near else 5.95), 0.0, carriages=3.0, modern=modern)
    roof = edge - 2.3
    platform.piece("canopy", 0, roof, length=42.0, depth=4.2, height=3.5)
    for index in range(-3, 4):
        at = index * 5.2 + 2.6
        platform.piece(
            "column", at, roof, footprint=(0.4, 0.4), height=3.6, width=0.22, material="iron", style="girder"
        )
        platform.lamp("canopy_lamp", (at - 2.6, roof, 3.3), 60, WARM, size=0.12, glow=0.15)
    for index, px in enumerate((-2.6, 2.6)):
        platform.furnish("park_bench", px * 1.55, roof + 0.1, required=index == 0)
    platform.furnish("trash_can", 0.0, roof, required=False)
    platform.furnish("lamppost", -x * 0.85, -y * 0.7, required=False)
    platform.furnish("lamppost", x * 0.85, -y * 0.7, required=False)
    platform.furnish("cart", x * 0.86, y * 0.1, yaw=75, required=False)
    platform.mark("edge", 0, y - 0.4, 180, "window", "edge")
    platform.ring("treeline", 70, 9, bottom=-3, azimuths=(-110, 110), sides=10)
    platform.ring("facades", 36, 11, azimuths=(96, 264), sides=8)
    platform.ring("skyline", 60, 15, azimuths=(86, 274), sides=8)
    platform.entrances(back=False)
    return platform.finish()


KIT = SetKit(
    key="platform", name="Railway platform",
    tags=("train platform", "railway platform", "railroad platform", "station platform", "train tracks",
        "railway tracks", "railway", "railroad", "tracks", "rail yard"),
    indoor=False, draw=draw, width=Span(11.0, 14.0, 22.0), depth=Span(6.5, 7.5, 11.0), options={"train": False},
)  # fmt: skip
