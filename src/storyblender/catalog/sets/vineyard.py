"""Set kit: a vineyard: rows of vines on wires along both sides of a grassy lane, hills behind."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.ground import Ground
from storyblender.catalog.sets.kit import SetKit, Span

_BETWEEN_ROWS, _ROW = 2.4, 6.0
"""Metres from row to row, and length of one piece of a row."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a vineyard: rows that run away from the viewer beside and behind the stage, which stays free."""
    land = Ground("vineyard", params, rng)
    x, y = land.half_x, land.half_y
    land.land("grass_dry", relief=1.4, rise=0.03)
    for index in range(-9, 10):
        px = (index + 0.5) * _BETWEEN_ROWS
        start = y + 1.2 if abs(px) < x + 0.8 else -y
        for step in range(5):
            py = start + (step + 0.5) * _ROW
            land.piece(
                "vine_row", px, py, land.height(px, py), 90.0, length=_ROW, variant=float(rng.integers(3)),
                footprint=(0.6, _ROW),
            )  # fmt: skip
    land.scatter(("grass_tuft",), 160, inner=1.8, outer=14, gap=0.35, scale=(0.6, 1.1), sunk=0.02)
    land.scatter(("broad_tree",), 9, inner=40, outer=55, gap=8, sector=(-90, 90), scale=(0.9, 1.3))
    land.scatter(("broad_tree",), 8, inner=18, outer=45, gap=7, sector=(115, 245))
    land.ring("hills", 80, 17)
    land.ring("treeline", 70, 9, sides=14)
    land.entrances()
    return land.finish()


KIT = SetKit(
    key="vineyard", name="Vineyard", tags=("vineyard", "vines", "winery", "wine estate"), indoor=False, draw=draw,
    width=Span(8.0, 11.0, 20.0), depth=Span(6.0, 8.0, 16.0),
)  # fmt: skip
