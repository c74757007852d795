"""Liquids of a story: their colours, what holds them, and where they run from. Data and pure arithmetic."""

from __future__ import annotations

import math

from storyblender.catalog.hollows import HOLLOWS
from storyblender.catalog.props.variants import COLORS, words_of
from storyblender.memory.base import Vec3

LIQUIDS: dict[str, str] = {
    "water": "#a9c0c9", "rain": "#a9c0c9", "milk": "#efeae0", "cream": "#efe6cf", "coffee": "#3a2417",
    "cocoa": "#5a3420", "tea": "#8a4f22", "wine": "#5a0f1e", "champagne": "#d9c26a", "beer": "#c98a2a",
    "whisky": "#a8641e", "whiskey": "#a8641e", "brandy": "#a8641e", "juice": "#d9862a", "lemonade": "#e0d27a",
    "soup": "#b5702e", "oil": "#1c1712", "petrol": "#6f6a3a", "gasoline": "#6f6a3a", "ink": "#14162c",
    "paint": "#c8c2b4", "blood": "#6d0f12", "honey": "#c9862a", "syrup": "#6a3a18", "sauce": "#8c2620",
    "mud": "#4a3826", "vinegar": "#b59a5a", "acid": "#9ab03a", "slime": "#6a9a3a",
}  # fmt: skip
"""Colour by name."""
_USUAL = {
    "cup": "coffee", "mug": "coffee", "paper_cup": "coffee", "thermos": "coffee", "coffee_machine": "coffee",
    "teapot": "tea", "wine_glass": "wine", "chalice": "wine", "beer_mug": "beer", "barrel": "beer", "pot": "soup",
}  # fmt: skip
"""What is in a thing, by prop key, where the script does not say; of others it is water."""
VESSELS = frozenset(HOLLOWS) & frozenset({
    "cup", "glass", "beer_mug", "wine_glass", "chalice", "bowl", "pot", "pan", "cauldron", "jug", "jar", "tin_can",
    "vase", "beaker", "bucket", "mug", "paper_cup", "barrel", "bathtub", "sink", "trough", "well",
}) | {"bottle", "water_bottle", "thermos", "teapot", "canteen", "aquarium"}  # fmt: skip
"""Keys of what liquids are kept in."""
_OBLONG = frozenset({"bathtub", "sink", "trough", "aquarium"})
SPOUTS: dict[str, tuple[Vec3, float, float]] = {
    "sink": ((0.0, 0.107, 0.92), 0.66, 0.0),
    "bathtub": ((0.0, 0.365, 0.9), 0.3, 0.0),
    "water_pump": ((0.0, -0.42, 0.56), 0.02, 0.0),
    "water_cooler": ((0.0, -0.5, 0.6), 0.45, 0.0),
    "hydrant": ((0.0, -0.5, 0.48), 0.0, 1.8),
    "hose": ((0.1, -0.5, 0.12), 0.0, 2.6),
}
"""By prop key, as shares of width, depth and height: where a liquid leaves it, at what height the stream ends, and how
far in metres it is thrown; 0 lets it fall straight down."""
_LEVEL = 0.82
"""Share of its height up to which a full vessel is filled."""


def liquid_named(words: str) -> str:
    """Return the hex colour of the liquid that words name: ``a glass of milk``; empty if they name none."""
    spoken = words_of(words)
    named = next((word for word in reversed(spoken) if word in LIQUIDS), "")
    paint = next((COLORS[word] for word in spoken if word in COLORS and word != "red"), "")
    return paint if paint and named in ("paint", "ink", "wine", "slime") else LIQUIDS.get(named, "")


def usual_liquid(key: str) -> str:
    """Return the hex colour of the liquid in a prop with this key, where the script does not name one."""
    return LIQUIDS[_USUAL.get(key, "water")]


def filling_of(key: str, size: Vec3) -> tuple[Vec3, float, bool] | None:
    """Return the surface of the liquid in a full vessel; None for what holds no liquid.

    Args:
        key: Prop key.
        size: Its width, depth and height in metres.

    Returns:
        Size of the liquid's surface and its height above the vessel's foot, metres; whether it is oblong, else round.
    """
    hollow = HOLLOWS.get(key)
    if key not in VESSELS or hollow is None:
        return None
    return (hollow.width * size[0] * 1.1, hollow.depth * size[1] * 1.1, 0.01), _LEVEL * size[2], key in _OBLONG


def spill_width(size: Vec3) -> float:
    """Return the width in metres of the puddle from a vessel of this (width, depth, height)."""
    held = size[0] * size[1] * size[2] * 0.5
    return min(max(math.sqrt(held / 0.004), 0.16), 1.8)
