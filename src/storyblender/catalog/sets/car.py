"""Set kit: the inside of a car: two seats before a bench, dashboard and wheel towards the audience."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.car_body import REAR, ROOF, SCREEN
from storyblender.catalog.sets.drawing import COOL, SODIUM, WARM, SetParams, rectangle
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
    color = "#c79a1e" if taxi else room.choose(("#2c3f4c", "#5a2320", "#3d4a3a", "#585d61"))
    room.piece("car_body", 0, 0, color=color, modern=modern, taxi=taxi)
    cloth = "#2a2b2d" if modern else "#5b3a26"
    for name, x in (("wheel", 0.4), ("beside", -0.4)):
        room.furnish("car_seat", x, -0.3, color=cloth)
        room.mark(name, x, -0.6, 0, name, *(("driver", "chauffeur", "cabbie", "cabby") if x > 0 else ()))
    room.furnish("carriage_seat", 0, 0.78, color=cloth, width=1.44, height=1.0)
    room.mark("front", 0.3, -0.9, 0, "centre")
    room.mark("street_left", -room.half_x + 0.5, 0, 90, "enter", "exit", "left")
    room.mark("street_right", room.half_x - 0.5, 0, 270, "enter", "exit", "right")
    room.lamp("dials", (0.3, SCREEN[0] + 0.45, 0.95), 1.2, COOL if modern else WARM, target=(0.2, 0.3, 1.2), size=0.2)
    for x, y in ((-room.half_x, 2.0), (room.half_x, -1.0)):
        room.lamp("street_lamp", (x, y, 2.6), 26, SODIUM, target=(0, 0, 1.0), size=0.3, role="set")
    plan = room.finish()
    roof = rectangle(-0.74, SCREEN[1], 0.74, REAR[1])
    slabs = [
        slab.model_copy(update={"polygon": roof, "z": ROOF}) if slab.role == "ceiling" else slab for slab in plan.slabs
    ]
    return plan.model_copy(update={"slabs": tuple(slabs)})


KIT = SetKit(
    key="car", name="Car", means={"bench": "carriage_seat", "sofa": "carriage_seat", "chair": "car_seat"},
    tags=("car", "taxi", "cab", "van", "truck", "limousine", "limo", "ambulance", "vehicle", "police car", "patrol car",
        "squad car", "pickup", "pickup truck", "jeep", "suv", "minivan", "back seat", "front seat", "sedan", "camper",
        "station wagon", "hatchback", "automobile", "uber", "cruiser", "taxicab", "rv", "hearse"),
    indoor=True, draw=draw, width=Span(4.0, 4.0, 4.0), depth=Span(6.0, 6.0, 6.0), height=Span(1.6, 1.6, 1.6),
    options={"taxi": False}, seated=True,
    has=("mirror", "rearview mirror", "wheel", "dashboard", "window", "windshield", "windscreen", "meter", "car",
        "taxi", "cab", "van", "truck", "door", "trunk", "hood", "engine", "seatbelt", "glovebox", "headlight"),
)  # fmt: skip
