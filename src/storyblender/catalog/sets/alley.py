"""Set kit: an alley between two brick walls: fire escape, dumpster, crates, a lit street at the far end."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SODIUM, SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan an alley: the two rows of backs, the things along them, and the street beyond."""
    alley = Ground("alley", params, rng)
    x, y, old = alley.half_x, alley.half_y, params.period == "past"
    alley.level("cobbles" if old else "asphalt", wet=True)
    for side, wall in ((-1, "brick_brown"), (1, "brick_red")):
        at = -y - 5
        while at < y + 1:
            alley.piece(
                "facade", side * (x + 0.1), at + 5.0, yaw=90.0 * -side, footprint=(10.0, 0.1), width=10.0,
                floors=4.0, material=wall, shop=False, plain=True, seed=float(rng.integers(1000)),
            )  # fmt: skip
            at += 10.0
    alley.card("facades", (-14, y + 18), (14, y + 18), -1.0, 13.0)
    alley.card("skyline", (-24, y + 26), (24, y + 26), -1.0, 26.0)
    alley.card("facades", (16, -y - 20), (-16, -y - 20), -1.0, 15.0)
    for side, end in ((-1, y), (1, y)):
        alley.card("facades", (side * 14, end + side * 6 + 12), (side * 14, end - side * 6 + 12), -1.0, 14.0)
        alley.card("facades", (side * 16, -end + side * 8 - 12), (side * 16, -end - side * 8 - 12), -1.0, 14.0)
    if not old:
        alley.piece("fire_escape", -x + 0.05, 0.8, yaw=90, floors=3.0)
        alley.furnish("dumpster", x - 0.75, y * 0.55, yaw=-90)
        alley.furnish("trash_can", x - 0.45, y * 0.55 + 1.5, required=False)
    for index, (dx, py, size) in enumerate(
        ((0.5, -y * 0.45, 0.7), (0.55, -y * 0.45 + 0.85, 0.6), (0.5, y * 0.62, 0.75))
    ):
        alley.furnish(
            "crate", -x + dx, py, yaw=alley.between(-20, 20), required=index == 0, width=size, depth=size, height=size
        )
    alley.furnish("barrel", x - 0.5, -y * 0.3, required=False)
    alley.furnish("barrel", -x + 0.5, y * 0.82, required=False)
    alley.piece("pipes", x - 0.1, -y * 0.05, 0.0, 0, vertical=True, length=9.0)
    alley.piece("puddle", 0.3, -1.0, scale=1.3)
    for side, py, z in ((-1, -y * 0.25, 3.0), (1, y * 0.3, 3.1)):
        alley.piece("wall_lamp", side * (x - 0.02), py, z, 90.0 * -side)
        alley.lamp("wall_lamp", (side * (x - 0.4), py, z - 0.1), 90, SODIUM, size=0.1, glow=0.4)
    alley.lamp("street_beyond", (0, y + 3, 4.5), 420, SODIUM, kind="AREA", size=4.0, target=(0, y - 4, 0.5))
    alley.mark("centre", 0, 0, 0, "centre")
    alley.mark("far_end", 0, y - 0.5, 0, "enter", "exit", "back")
    alley.mark("near_end", 0, -y + 0.5, 180, "enter", "exit", "front")
    alley.mark("back_door", -x + 0.5, y * 0.1, 90, "enter", "exit", "door", "left")
    return alley.finish()


KIT = SetKit(
    key="alley", name="Alley",
    tags=("alley", "alleyway", "back alley", "backstreet", "back street", "loading bay", "back door", "ghetto"),
    indoor=False, draw=draw, width=Span(4.4, 4.8, 7.0), depth=Span(10.0, 13.0, 20.0),
)  # fmt: skip
