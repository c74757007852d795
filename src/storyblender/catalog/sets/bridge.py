"""Set kit: a bridge: a roadway across, railings and lampposts, water below, the city or the hills beyond."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a bridge: the deck along x with a railing behind and before the stage."""
    bridge = Ground("bridge", params, rng)
    x, y, old = bridge.half_x, bridge.half_y, params.period == "past"
    front = -y - 5.0
    bridge.slab("ground", rectangle(-REACH, front, REACH, y + 0.6), "cobbles" if old else "paving", wet=True)
    if not old:
        bridge.slab("patch", rectangle(-REACH, front + 0.6, REACH, -y + 0.4), "asphalt", z=0.004, wet=True)
    for py in (y + 0.4, front + 0.2):
        bridge.piece(
            "parapet" if old else "railing", 0, py, length=120.0, height=1.05,
            material="stone_light" if old else "iron", wild=py < 0,
        )  # fmt: skip
    for index in range(-3, 4):
        bridge.furnish("lamppost", index * 9.0 + 4.5, y + 0.05, required=abs(index) < 2)
        bridge.furnish("lamppost", index * 9.0, front + 0.6, required=False)
    bridge.slab(
        "ground", rectangle(-REACH * 1.6, -REACH * 1.6, REACH * 1.6, REACH * 1.6), "water_deep", z=-6.0, wet=True
    )
    for index in range(-3, 4):
        bridge.piece("pier", index * 18.0 + 9, (y + front) / 2, -6.0, depth=y - front + 0.6, material="stone")
    view = "hills" if old else "skyline"
    bridge.ring(view, 84, 20, bottom=-7, azimuths=(-80, 80), sides=6)
    bridge.ring(view, 84, 18, bottom=-7, azimuths=(100, 260), sides=6)
    bridge.ring("treeline", 62, 3, bottom=-7, azimuths=(35, 80), sides=3)
    bridge.ring("treeline", 62, 3, bottom=-7, azimuths=(-80, -35), sides=3)
    bridge.ring("facades", 70, 10, bottom=-7, azimuths=(78, 102), sides=1)
    bridge.ring("facades", 70, 10, bottom=-7, azimuths=(258, 282), sides=1)
    bridge.vehicle(-x - 1.0, -y - 2.2, 90)
    bridge.mark("railing", 0, y - 0.2, 180, "window", "railing", "bar")
    bridge.entrances(back=False)
    return bridge.finish()


KIT = SetKit(
    key="bridge", name="Bridge",
    tags=("bridge", "footbridge", "overpass", "viaduct", "embankment", "aqueduct", "promenade"), indoor=False,
    draw=draw, width=Span(9.0, 12.0, 22.0), depth=Span(4.0, 4.6, 7.0),
)  # fmt: skip
