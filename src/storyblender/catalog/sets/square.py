"""Set kit: a town square: cobbles, houses on three sides, a fountain, market stalls, a cart."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.street import row_of_facades


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a town square: the houses around and the market at the edges; the middle stays free."""
    square = Ground("square", params, rng)
    x, y, old = square.half_x, square.half_y, params.period == "past"
    square.level("cobbles" if params.period != "modern" else "paving_light", wet=True)
    floors = (2, 2, 3) if old else (3, 3, 4)
    row_of_facades(square, y + 4.5, 0, start=-x - 16, end=x + 16, floors=floors, shops=not old)
    row_of_facades(square, -y - 14, 180, start=-x - 22, end=x + 22, floors=floors)
    for side in (-1, 1):
        square.piece(
            "facade", side * (x + 6.5), 1.0, yaw=90.0 * -side, footprint=(9.6, 0.1), width=9.6, floors=float(floors[1]),
            material="limewash", shop=not old, seed=float(rng.integers(1000)),
        )  # fmt: skip
        square.card("facades", (side * (x + 24), side * 30.0), (side * (x + 24), side * -30.0), -1.0, 12.0)
    square.ring("hills", 84, 26, bottom=-1, azimuths=(-66, 66), sides=6)
    square.furnish("fountain", x * 0.45, y + 0.2)
    square.mark("fountain", x * 0.45 - 1.6, y * 0.75, 90, "fountain", "window")
    for index, px in enumerate((-x + 1.4, -x + 4.2)):
        square.furnish("market_stall", px, y - 0.6, required=index == 0)
        square.mark(f"stall_{index + 1}", px, y - 2.0, 180, "table", "bar")
    square.furnish("cart", x - 1.2, -y * 0.35, yaw=-60, required=False)
    square.furnish("barrel", -x + 0.6, y - 2.3, required=False)
    square.furnish("crate", -x + 0.7, -y * 0.1, yaw=14, required=False)
    square.furnish("bench", -x + 0.6, -y * 0.5, yaw=90, required=False)
    for px in (-2.2, -0.9, 0.4):
        square.furnish("park_bench" if px == -0.9 else "potted_plant", px, y + 1.4, required=False)
    if not old:
        square.furnish("round_table", -x * 0.3, y + 2.8, required=False)
        square.furnish("chair", -x * 0.3 + 0.7, y + 2.8, yaw=-90, required=False)
        square.furnish("chair", -x * 0.3 - 0.7, y + 2.8, yaw=90, required=False)
    square.piece("lamp_string", 0, y - 0.2, 5.2, length=2 * x + 8, sag=0.9, flags=True)
    for px in (-x - 0.5, x + 0.5):
        square.furnish("lamppost", px, y + 1.6, required=False)
    square.entrances()
    return square.finish()


KIT = SetKit(
    key="square", name="Town square", tags=("square", "plaza", "piazza", "town square", "fountain", "gate"),
    indoor=False, draw=draw, width=Span(10.0, 13.0, 22.0), depth=Span(8.0, 10.0, 18.0), has=("house", "building"),
    period="past",
)  # fmt: skip
