"""Colours by word, for clothes and hair."""

from __future__ import annotations

import re
from typing import Final

from storyblender.catalog.materials import hex_color
from storyblender.memory.base import Color

_CLOTH: Final = {
    "white": "#ece9e2", "ivory": "#e8e0cc", "cream": "#e6dcc3", "black": "#17171a", "charcoal": "#33353a",
    "grey": "#7c7f84", "gray": "#7c7f84", "silver": "#b4b8bd", "red": "#a3202a", "crimson": "#8e1524",
    "scarlet": "#b81f24", "burgundy": "#5c1626", "maroon": "#57191f", "wine": "#5c1626", "pink": "#d79aa6",
    "rose": "#c98a92", "orange": "#c8642a", "rust": "#9a4a26", "yellow": "#d4ac38", "mustard": "#b48a2c",
    "gold": "#b8923c", "golden": "#c39c45", "green": "#3f6b48", "olive": "#5f6238", "emerald": "#1f6b4a",
    "khaki": "#968a66", "teal": "#2b6a70", "turquoise": "#3d9a9c", "blue": "#2d5183", "navy": "#1d2a47",
    "indigo": "#2f3266", "purple": "#553a72", "violet": "#614a83", "lavender": "#a597c0", "brown": "#5a402c",
    "tan": "#a5865f", "beige": "#c2b08f", "sand": "#c4b18c", "camel": "#a98657", "copper": "#94572f",
    "denim": "#3b516e", "leather": "#3a2a20", "tweed": "#6b5f4c", "linen": "#cdc3ad",
}  # fmt: skip
_HAIR: Final = {
    "blond": "#a98c62", "blonde": "#a98c62", "fair": "#b09a74", "golden": "#a58350", "sandy": "#8a7252",
    "honey": "#94744c", "platinum": "#c4b596",
    "brown": "#3f2a1c", "brunette": "#33221a", "chestnut": "#4f2f1d", "auburn": "#5a2a1a", "red": "#7c3018",
    "ginger": "#93431f", "copper": "#86401f", "black": "#120f0e", "dark": "#1f1814", "raven": "#0e0d0f",
    "grey": "#8b8b8c", "gray": "#8b8b8c", "silver": "#a8aaad", "white": "#d6d5d1", "snow": "#d6d5d1",
}  # fmt: skip
_SHADES: Final = {"dark": 0.55, "deep": 0.6, "midnight": 0.45, "light": 1.5, "pale": 1.6, "bright": 1.25, "faded": 1.2}


def cloth_color(words: str) -> Color | None:
    """Return the scene-linear colour that a phrase such as ``dark green wool`` names, or None."""
    found = [word for word in re.findall(r"[a-z]+", words.lower()) if word in _CLOTH]
    if not found:
        return None
    named = next((word for word in found if word not in ("leather", "tweed", "linen", "denim")), found[0])
    shade = re.search(rf"\b({'|'.join(_SHADES)})(?:er)?[ -]{named}\b", words.lower())
    factor = _SHADES[shade[1]] if shade else 1.0
    red, green, blue = (min(1.0, value * factor) for value in hex_color(_CLOTH[named]))
    return (red, green, blue)


def hair_color(words: str) -> Color | None:
    """Return the scene-linear hair colour that a phrase names, or None."""
    found = [word for word in re.findall(r"[a-z]+", words.lower()) if word in _HAIR]
    named = next((word for word in found if word != "dark"), found[0] if found else None)
    return hex_color(_HAIR[named]) if named else None
