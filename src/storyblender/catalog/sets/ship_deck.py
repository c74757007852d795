"""Set kit: the deck of a ship: planks, bulwarks, mast and rigging, hatch, wheel, the sea all around."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import WARM, SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a ship's deck: the deck along x, its cabin at the left, the sea to the horizon."""
    ship = Ground("ship_deck", params, rng)
    x, y, old = ship.half_x, ship.half_y, params.period == "past"
    bow = x + 9.0
    hull = (
        (-x - 7, -y - 0.6), (x + 3, -y - 0.6), (bow - 2.2, -y * 0.5), (bow, 0.0), (bow - 2.2, y * 0.5),
        (x + 3, y + 0.6), (-x - 7, y + 0.6),
    )  # fmt: skip
    ship.slab("ground", hull, "planks_gray" if old else "boards_light", wet=True)
    rail = "bulwark" if old else "railing"
    for (ax, ay), (bx, by) in pairwise(hull):
        length = float(np.hypot(bx - ax, by - ay))
        yaw = float(np.degrees(np.arctan2(by - ay, bx - ax)))
        ship.piece(
            rail,
            (ax + bx) / 2,
            (ay + by) / 2,
            yaw=yaw,
            length=length + 0.1,
            height=1.0,
            material="wood_dark" if old else "paint_white",
            wild=ay <= -y * 0.5 or by <= -y * 0.5,
        )
    ship.piece("deck_house", -x - 3.4, 0, yaw=90, footprint=(2 * y - 1.2, 5.0), width=2 * y - 1.2, depth=5.0, old=old)
    ship.lamp("cabin_lamp", (-x - 0.5, 0.0, 2.2), 55, WARM, size=0.1, glow=0.35)
    ship.mark("cabin_door", -x + 0.45, 0.0, 90, "door", "enter", "exit", "left")
    ship.piece("mast" if old else "funnel", x * 0.62, y * 0.35, footprint=(0.6, 0.6), height=13.0)
    ship.piece("hatch", x * 0.75, -y * 0.45, footprint=(1.6, 1.2))
    ship.piece("ships_wheel", -x + 1.2, y * 0.35, yaw=90, footprint=(0.9, 0.5))
    ship.mark("helm", -x + 0.55, y * 0.35, 90, "wheel", "helm", "helmsman", "skipper", "captain", "wheelhouse")
    for px, py in ((-x + 0.4, y - 0.1), (-x + 1.15, y - 0.1), (x - 0.2, y - 0.2)):
        ship.furnish("barrel" if old else "crate", px, py, required=False)
    ship.mark("rail", 0, y - 0.15, 180, "window", "railing", "bar")
    ship.slab("ground", rectangle(-REACH * 1.8, -REACH * 1.8, REACH * 1.8, REACH * 1.8), "water_deep", z=-3.5, wet=True)
    ship.ring("sea", 150, 1.6, bottom=-8, sides=14)
    ship.entrances(back=False)
    return ship.finish()


KIT = SetKit(
    key="ship_deck", name="Ship's deck",
    tags=("ship", "deck", "boat", "yacht", "ferry", "pirate ship", "sailing ship", "galleon", "steamer", "fishing boat",
        "trawler", "boat deck", "ship deck", "fishing vessel", "wheelhouse"),
    indoor=False, draw=draw, width=Span(7.0, 9.0, 14.0), depth=Span(4.6, 5.6, 8.0), period="past",
)  # fmt: skip
