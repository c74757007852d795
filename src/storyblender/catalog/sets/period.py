"""Replaces what did not exist in a set's period by what people had instead: a fridge by a cabinet.

Kits that differ much between periods draw each period themselves; this pass corrects the rest.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.set_plan import Furnishing, Piece, SetPlan
from storyblender.catalog.sets.drawing import Period
from storyblender.catalog.sets.kit import SetKit
from storyblender.memory.vocabulary import Age

_OF_AGE: Final[Mapping[Age, Period]] = {
    "medieval": "past", "west": "past", "victorian": "past", "classic": "classic", "space": "modern", "today": "modern",
}  # fmt: skip
_INSTEAD: Final[Mapping[Period, Mapping[str, str]]] = {
    "past": {
        "pendant_lamp": "lantern", "table_lamp": "candle_holder", "bankers_lamp": "candle_holder", "floor_lamp": "",
        "wall_lamp": "", "fluorescent_light": "", "ceiling_fan": "", "electric_fan": "",
        "fridge": "cabinet", "microwave": "jar", "toaster": "bread", "coffee_machine": "jug",
        "washing_machine": "barrel",
        "television": "", "radio": "", "telephone": "", "phone_handset": "", "loudspeaker": "", "security_camera": "",
        "computer": "book", "laptop": "book", "tablet": "book", "keyboard": "", "typewriter": "book",
        "tape_recorder": "", "cash_register": "scales", "calendar": "picture", "poster": "picture",
        "whiteboard": "blackboard", "radiator": "", "water_cooler": "barrel", "office_chair": "chair",
        "trash_can": "basket", "dumpster": "crate", "shopping_cart": "basket", "neon_sign": "", "slot_machine": "",
        "fire_extinguisher": "bucket", "vacuum_cleaner": "broom", "bicycle": "", "motorcycle": "", "car": "cart",
        "taxi": "cart", "police_car": "cart", "convertible": "cart", "jeep": "cart", "pickup": "cart", "van": "cart",
        "ambulance": "cart", "truck": "cart", "bus": "cart", "tractor": "cart", "hydrant": "", "mailbox": "",
        "traffic_light": "", "traffic_cone": "", "phone_booth": "", "heart_monitor": "", "drip_stand": "",
    },
    "classic": {
        "computer": "typewriter", "laptop": "typewriter", "tablet": "book", "keyboard": "", "smartphone": "telephone",
        "microwave": "radio", "whiteboard": "blackboard", "security_camera": "", "shopping_cart": "basket",
        "memory_stick": "", "headset": "",
    },
    "modern": {},
}  # fmt: skip
"""Period -> prop that it lacks -> the prop in its place, or an empty string for none."""
_NO_PIECES: Final[Mapping[Period, frozenset[str]]] = {
    "past": frozenset({"ceiling_light", "wall_lamp", "vending_machine", "jukebox", "copier", "desk_screen",
                       "server_rack", "extractor", "road_marking", "parking_bays", "bay_sign"}),
    "classic": frozenset({"desk_screen", "server_rack", "vending_machine"}),
    "modern": frozenset(),
}  # fmt: skip
"""Period -> set pieces that it lacks."""
_DROP = 0.55
"""Metres from the ceiling to a lantern in place of an electric light."""


def period_of(kit: SetKit, age: Age | None) -> Period:
    """Return the period in which a kit is furnished: that of the story's age, or the kit's own if no age is known."""
    return kit.period if age is None else _OF_AGE[age]


def existed_in(prop: str, period: Period) -> bool:
    """Return whether there were props of a catalog key in a period."""
    return prop not in _INSTEAD[period]


def fit_to_period(plan: SetPlan, period: Period) -> SetPlan:
    """Return a plan without what did not exist in its period, such as lamps and cars of today.

    Args:
        plan: As its kit drew it.
        period: Period of the story.
    """
    instead, gone = _INSTEAD[period], _NO_PIECES[period]
    if not any(item.prop in instead for item in plan.furnishings) and not any(p.part in gone for p in plan.pieces):
        return plan
    furnishings: list[Furnishing] = []
    pieces: list[Piece] = [piece for piece in plan.pieces if piece.part not in gone]
    for item in plan.furnishings:
        itself = plan.kit in family_of(item.prop)  # the inside of a car has its car in every period
        prop = item.prop if itself else instead.get(item.prop, item.prop)
        if prop == item.prop:
            furnishings.append(item)
        elif prop:
            furnishings.append(item.model_copy(update={"prop": prop, "params": _sized(item, prop)}))
            if PROPS[item.prop].placement == "ceiling":
                pieces.append(_chain(item.node_id, item.location[0], item.location[1], item.location[2], plan))
    for number, (x, y, z) in enumerate(_lights(plan) if "ceiling_light" in gone else ()):
        furnishings.append(
            Furnishing(node_id=f"set_old_light_{number}", prop="lantern", location=(x, y, z), required=False)
        )
        pieces.append(_chain(f"old_light_{number}", x, y, z, plan))
    return plan.model_copy(update={"furnishings": tuple(furnishings), "pieces": tuple(pieces)})


def _sized(item: Furnishing, prop: str) -> dict[str, float | str | bool]:
    """Return the parameters of a substitute: as large as what stood there at most."""
    size, usual = PROPS[item.prop].size, PROPS[prop].size
    names = ("width", "depth", "height")
    there = [float(item.params.get(name, each)) for name, each in zip(names, size, strict=True)]
    if PROPS[item.prop].placement == "ceiling" or all(own <= old for own, old in zip(usual, there, strict=True)):
        return {}
    share = min(1.0, *(old / own for own, old in zip(usual[:2], there[:2], strict=True)))
    return {name: round(own * share, 3) for name, own in zip(names, usual, strict=True)}


def _lights(plan: SetPlan) -> Iterator[tuple[float, float, float]]:
    lights = [piece for piece in plan.pieces if piece.part == "ceiling_light"]
    for light in lights:
        yield (light.location[0], light.location[1], round(light.location[2] - _DROP, 3))


def _chain(name: str, x: float, y: float, z: float, plan: SetPlan) -> Piece:
    """Return the chain from the ceiling to a lantern."""
    ceiling = max((wall.base + wall.height for wall in plan.walls), default=z + 1.0)
    length = round(max(ceiling - z - 0.32, 0.1), 3)
    return Piece(
        node_id=f"chain_of_{name}", part="chain", location=(x, y, ceiling), params={"length": length}, solid=False
    )
