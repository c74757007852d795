"""Set kit: the inside of a car: a car of the catalog on a street, its nose to the audience."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import COOL, SODIUM, WARM, SetParams
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.room import Finishes, Room, Side

_SIDES: tuple[Side, ...] = ("back", "front", "left", "right")


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a car: the car alone; the walls of the set are open, so that cameras stand in the street around it."""
    modern, taxi = params.period == "modern", bool(params.option("taxi"))
    look = Finishes("plaster_dark", "tarmac", "cloth_cream", outside="tarmac")
    room = Room("car", params, rng, look, view="facades")
    for side in _SIDES:
        room.window(side, 0, width=room.length(side), sill=0.7, style="open")
    period = "modern" if modern else "1940s"
    color = room.choose(("#2c3f4c", "#5a2320", "#3d4a3a", "#585d61"))
    room.furnish("taxi", 0, 0) if taxi else room.furnish("car", 0, 0, color=color, period=period)
    for name, x in (("wheel", 0.4), ("beside", -0.4)):
        room.mark(name, x, -0.6, 0, name, *(("driver", "chauffeur", "cabbie", "cabby") if x > 0 else ()))
    room.mark("front", 0.3, -0.9, 0, "centre")
    room.mark("street_left", -room.half_x + 0.5, 0, 90, "enter", "exit", "left")
    room.mark("street_right", room.half_x - 0.5, 0, 270, "enter", "exit", "right")
    room.lamp("dials", (0.3, -0.55, 0.95), 1.2, COOL if modern else WARM, target=(0.2, 0.3, 1.2), size=0.2)
    for x, y in ((-room.half_x, 2.0), (room.half_x, -1.0)):
        room.lamp("street_lamp", (x, y, 2.6), 26, SODIUM, target=(0, 0, 1.0), size=0.3, role="set")
    plan = room.finish()
    return plan.model_copy(update={"slabs": tuple(slab for slab in plan.slabs if slab.role != "ceiling")})


KIT = SetKit(
    key="car", name="Car", means={"chair": "car_seat"},
    tags=("car", "taxi", "cab", "van", "truck", "limousine", "limo", "ambulance", "vehicle", "police car", "patrol car",
        "squad car", "pickup", "pickup truck", "jeep", "suv", "minivan", "back seat", "front seat", "sedan", "camper",
        "station wagon", "hatchback", "automobile", "uber", "cruiser", "taxicab", "rv", "hearse"),
    indoor=True, draw=draw, width=Span(4.0, 4.0, 4.0), depth=Span(6.0, 6.0, 6.0), height=Span(1.6, 1.6, 1.6),
    options={"taxi": False}, seated=True,
    has=("mirror", "rearview mirror", "wheel", "dashboard", "window", "windshield", "windscreen", "meter", "car",
        "taxi", "cab", "van", "truck", "door", "trunk", "hood", "engine", "seatbelt", "glovebox", "headlight"),
)  # fmt: skip
