"""Set kit: a dock: planks on posts, bollards and crates, a shed, boats on black water and the far shore."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SODIUM, SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.memory.scene_context import SceneSize

_WATER, _DRAUGHT = -0.05, 0.02
"""Metres: the water stands high, so that who sits in a boat is seen over the quay; a boat's boards are dry."""
_BEAM, _LENGTH = 1.5, 4.1
"""Metres of water that a boat takes beside the quay; its side lies at the edge, a step from where people stand."""
_FAR = 30.0
"""Metres to where nobody goes."""


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a dock: the quay along x; water behind it, the shed at the left."""
    dock = Ground("dock", params, rng)
    x, y, old = dock.half_x, dock.half_y, params.period == "past"
    edge = y + 0.05
    deck = "planks_gray" if old else "concrete"
    dock.slab("ground", rectangle(-REACH, -REACH, REACH, edge), deck, wet=True)
    dock.slab("ground", rectangle(-REACH * 1.6, edge, REACH * 1.6, REACH * 1.6), "water_deep", z=_WATER, wet=True)
    dock.piece("quay_edge", 0, edge, length=120.0, drop=1.6, material="boards_grey" if old else "concrete_dark")
    if params.option("cranes") and not old:
        for px, turn in ((-x - 14.0, 35), (-3.0, -20), (x + 15.0, 15)):
            dock.piece("harbour_crane", px, edge + 38.0, _WATER, turn, scale=1.4)
    for index in range(-4, 5):
        dock.piece("bollard", index * 4.0 + 1.5, edge - 0.35, footprint=(0.4, 0.4))
    dock.piece("shed", -x - 4.2, -1.0, yaw=90, footprint=(8.0, 6.0), width=8.0, depth=6.0, height=4.2)
    dock.piece("moored_ship" if not old else "mast_ship", x + 6.0, edge + 9.0, _WATER, 90, length=24.0)
    _moor(dock, edge)
    for index, (px, py, size) in enumerate(
        ((x - 1.0, y - 0.9, 0.9), (x - 2.0, y - 0.8, 0.75), (-x + 0.9, y - 0.8, 0.8))
    ):
        dock.furnish(
            "crate", px, py, yaw=dock.between(-15, 15), required=index == 0, width=size, depth=size, height=size
        )
    dock.furnish("crate", x - 1.0, y - 0.9, 0.9, 25, required=False, width=0.6, depth=0.6, height=0.6)
    for px, py in ((-x + 0.6, -y * 0.2), (-x + 0.7, -y * 0.2 + 0.75), (x - 0.6, -y * 0.4)):
        dock.furnish("barrel", px, py, required=False)
    for px in (-x * 0.4, x * 0.4):
        dock.furnish("lamppost", px, edge - 1.0)
    dock.lamp("shed_lamp", (-x - 0.7, -1.0, 3.2), 120, SODIUM, size=0.12, glow=0.4)
    dock.mark("boat", 0.9, y - 0.3, 180, "boat", "oar", "oars", "rower", "boatman", "ferryman")
    dock.mark("water_edge", 0, y - 0.3, 180, "window", "water")
    dock.ring("sea", 140, 1.6, bottom=-6, azimuths=(-95, 95), sides=8)
    dock.ring("skyline", 110, 12, bottom=-3, azimuths=(20, 80), sides=3)
    dock.ring("facades", 40, 11, azimuths=(90, 270), sides=8)
    dock.ring("skyline", 60, 15, azimuths=(86, 274), sides=8)
    dock.entrances(back=False)
    return dock.finish()


def _moor(dock: Ground, edge: float) -> None:
    """Moor two boats at the quay; they are part of the stage, the water between them is not."""
    x, reach = dock.half_x, edge + 0.3 + _BEAM
    dock.size = SceneSize(x=x, x_negative=-x, y=reach, y_negative=-dock.half_y)
    boats = (0.9 - 1.24 * x, 0.9)
    for px in boats:
        dock.furnish("rowing_boat", px, edge + 0.16 + _BEAM / 2, _WATER - _DRAUGHT, 90)
    shores = [-_FAR, *(px + side * _LENGTH / 2 for px in boats for side in (-1, 1)), _FAR]
    for left, right in zip(shores[::2], shores[1::2], strict=True):
        middle, length = round((left + right) / 2, 3), round(right - left, 3)
        dock.piece("boom", middle, edge + 0.45 + _BEAM / 2, _WATER, footprint=(length, _BEAM), length=length, tall=0.3)


KIT = SetKit(
    key="dock", name="Dock",
    tags=("dock", "docks", "pier", "harbor", "harbour", "wharf", "quay", "port", "marina", "jetty", "landing stage",
        "ferry landing", "mooring", "shipyard", "canal"),
    has=("pier", "jetty", "wharf", "quay", "dock"),
    indoor=False, draw=draw, width=Span(9.0, 12.0, 20.0), depth=Span(6.0, 8.0, 12.0), options={"cranes": True},
)  # fmt: skip
