"""Hollow props and where a thing put into them lies, so that it can still be seen. Data and pure arithmetic."""

from __future__ import annotations

from typing import NamedTuple

from storyblender.memory.base import Vec3


class Hollow(NamedTuple):
    """The inside of a thing, as shares of its width, depth and height.

    Attributes:
        floor: Height of the bottom inside.
        y: Middle of the inside, from the middle of the thing to its back; -0.5 is the face of a closed front, out of
            which what is inside shows by half.
        width: Width inside.
        depth: Depth inside.
    """

    floor: float
    y: float = 0.0
    width: float = 0.75
    depth: float = 0.75


_VESSELS = {
    "cup": 0.3, "glass": 0.15, "beer_mug": 0.2, "wine_glass": 0.6, "chalice": 0.65, "bowl": 0.35, "pot": 0.2,
    "pan": 0.4, "cauldron": 0.3, "jug": 0.4, "jar": 0.1, "tin_can": 0.3, "vase": 0.6, "beaker": 0.1, "ashtray": 0.4,
    "bucket": 0.3, "mug": 0.5, "paper_cup": 0.8, "lunch_box": 0.6, "tire": 0.1,
    "basket": 0.35, "laundry_basket": 0.6, "trash_can": 0.7, "dumpster": 0.75, "barrel": 0.8, "bathtub": 0.24,
    "sink": 0.7, "trough": 0.55, "fountain": 0.3, "well": 0.6, "cradle": 0.5, "pram": 0.5, "wheelbarrow": 0.5,
    "shopping_cart": 0.5, "cart": 0.5, "crate": 0.7, "cardboard_box": 0.25, "chest": 0.35, "jewel_box": 0.3,
    "toolbox": 0.6, "bag": 0.6, "sack": 0.75, "backpack": 0.75, "briefcase": 0.8, "hat": 0.2, "coffin": 0.6,
}  # fmt: skip
"""Height of the inner bottom as a share of the height, for props that are open above."""
_FRONTS = {
    "cabinet": 0.45, "wardrobe": 0.35, "locker": 0.45, "safe": 0.3, "filing_cabinet": 0.62, "dresser": 0.55,
    "nightstand": 0.5, "stove": 0.3, "wood_stove": 0.3, "microwave": 0.2, "mailbox": 0.75,
}  # fmt: skip
"""Share of the height of the shelf or drawer behind a closed front."""
HOLLOWS: dict[str, Hollow] = {
    **{key: Hollow(floor) for key, floor in _VESSELS.items()},
    **{key: Hollow(floor, -0.5) for key, floor in _FRONTS.items()},
    "suitcase": Hollow(0.04, -0.12, 0.9, 0.6),
    "fridge": Hollow(0.45, -0.2),
    "washing_machine": Hollow(0.36, -0.32, 0.5, 0.5),
    "fireplace": Hollow(0.06, -0.1, 0.5, 0.4),
    "nest_box": Hollow(0.2, -0.28, 0.9, 0.6),
}
"""By prop key."""
OPEN_ABOVE = frozenset({*_VESSELS, "suitcase"}) - {"hat", "bag", "backpack", "briefcase", "coffin"}
"""Keys of props that a thing put down on them falls into."""
_MOST = 1.6
"""A thing may be this many times as wide and deep as the inside: then it sticks out."""


def place_inside(key: str | None, size: Vec3, thing: Vec3, before: int = 0) -> Vec3 | None:
    """Return where a thing lies in a hollow one, in the hollow thing's frame; None if that is not hollow or too small.

    Args:
        key: Prop key of the hollow thing.
        size: Its width, depth and height in metres.
        thing: Width, depth and height of what is put into it.
        before: Number of things that are in it already; they lie side by side.
    """
    hollow = HOLLOWS.get(key or "")
    if hollow is None:
        return None
    room = hollow.width * size[0], hollow.depth * size[1]
    if max(thing[:2]) > _MOST * max(room) or min(thing[:2]) > _MOST * min(room):
        return None
    aside = 0.5 * max(0.0, room[0] - min(thing[:2])) * (0.0, 0.8, -0.8, 0.4, -0.4)[before % 5]
    return (aside, hollow.y * size[1], hollow.floor * size[2])
