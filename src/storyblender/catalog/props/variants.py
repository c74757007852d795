"""Words that vary a prop: colours, materials, states, ages. From a phrase to the builder's parameters."""

from __future__ import annotations

import re

from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.registry import ParamValue

COLORS: dict[str, str] = {
    "white": "#e4e0d6", "ivory": "#e2d9bf", "cream": "#e0d5b6", "black": "#1b1b1d", "grey": "#7d8084",
    "gray": "#7d8084", "red": "#9c2622", "crimson": "#861622", "scarlet": "#b3241c", "burgundy": "#5a1a24",
    "pink": "#d394a0", "orange": "#c4662a", "yellow": "#d0aa36", "green": "#3c6a42", "olive": "#5e6238",
    "turquoise": "#3a9a98", "teal": "#2a6a6e", "blue": "#2c5288", "navy": "#1d2b48", "purple": "#563a72",
    "violet": "#62498a", "brown": "#5c4028", "beige": "#c0ad8a", "tan": "#a5845c", "lemon": "#d8c13a",
    "lime": "#7f9a3a", "tomato": "#a8321e", "potato": "#a98a5c", "onion": "#b07a3c", "plum": "#4d2a4a",
    "blood": "#6d0f12", "tangerine": "#c9702a",
}  # fmt: skip

MATERIALS: dict[str, str] = {
    "wooden": "wood", "wood": "wood", "oak": "wood", "pine": "wood_light", "walnut": "wood_dark", "ebony": "wood_black",
    "mahogany": "wood_red", "cherry": "wood_red", "driftwood": "wood_gray", "leather": "leather",
    "velvet": "fabric_red", "silk": "linen", "marble": "marble", "stone": "rock", "granite": "rock", "brick": "brick",
    "concrete": "concrete", "steel": "steel", "metal": "steel", "metallic": "steel", "iron": "iron", "brass": "brass",
    "bronze": "copper", "copper": "copper", "silver": "silver", "gold": "gold", "golden": "gold", "gilded": "gold",
    "chrome": "chrome", "rusty": "rust", "rusted": "rust", "plastic": "plastic", "glass": "glass",
    "porcelain": "porcelain", "clay": "clay", "straw": "thatch", "wicker": "thatch", "canvas": "canvas",
    "paper": "paper", "cardboard": "cardboard",
}  # fmt: skip

PLAIN: frozenset[str] = frozenset(
    [
        "a", "an", "the", "his", "her", "their", "its", "my", "our", "your", "this", "that", "some", "old", "new",
        "ancient", "antique", "vintage", "modern", "contemporary", "young", "small", "little", "tiny", "big", "large",
        "huge", "giant", "enormous", "great", "long", "short", "tall", "high", "low", "wide", "narrow", "thick", "thin",
        "heavy", "light", "beautiful", "pretty", "ugly", "elegant", "ornate", "fancy", "simple", "plain", "basic",
        "cheap", "expensive", "worn", "battered", "broken", "cracked", "torn", "dirty", "dusty", "clean", "polished",
        "shiny", "dull", "dark", "pale", "bright", "faded", "empty", "full", "half", "open", "closed", "locked",
        "sealed", "lit", "unlit", "burning", "folded", "crumpled", "rolled", "single", "double", "round", "square",
        "oval", "bloody", "wet", "dry", "dead", "fallen", "loaded", "hidden", "secret", "private", "favorite",
        "favourite", "familiar", "strange", "mysterious", "special", "ordinary", "traditional", "classic", "typical",
        "rustic", "1920s", "1930s", "1940s", "1950s", "1960s", "1970s", "1980s", "1990s", "twin", "matching", "other",
        "second", "first", "last", "same", "soft", "hard", "cold", "hot", "warm", "steaming", "period", "mounted",
        "framed", "carved", "upholstered", "painted", "nearby", "distant", "lone", "lonely", "pair", "set", "piece",
        "bunch",
    ]
)  # fmt: skip
"""Words that change nothing about what a thing is."""

TOY_WORDS: frozenset[str] = frozenset(
    ["toy", "model", "rubber", "plush", "stuffed", "inflatable", "chocolate", "miniature", "clockwork", "tin", "paper"]
)
"""Words before a creature or a vehicle that make a small likeness of it."""

_PERIODS = {
    "1920s": "1940s", "1930s": "1940s", "1940s": "1940s", "1950s": "1940s", "vintage": "1940s", "old": "1940s",
    "antique": "1940s", "period": "1940s", "modern": "modern",
}  # fmt: skip
_YES: dict[str, tuple[str, ...]] = {
    "open": ("open", "opened"),
    "asleep": ("sleeping", "asleep", "dozing"),
    "flying": ("flying", "soaring", "gliding", "hovering", "swooping", "fluttering"),
    "up": ("open", "opened", "unfurled", "rain", "storm", "snow"),
    "lit": ("lit", "burning", "blazing", "on"),
    "on": ("flickering", "blaring", "on", "running"),
    "flat": ("flat", "flatscreen", "modern"),
    "wings": ("wing", "winged"),
    "cloth": ("tablecloth",),
    "pair": (
        "pair", "shoes", "sneakers", "trainers", "loafers", "slippers", "heels", "sandals", "flops", "socks",
        "stockings", "crutches", "drumsticks", "sticks", "footwear",
    ),
    "stacked": ("stack", "stacks", "stacked", "pile", "piles", "tower", "heap"),
    "stripes": ("striped",),
    "antlers": ("stag",),
    "money": ("tip", "tips", "money", "coins", "savings", "swear", "donation"),
    "revolver": ("revolver", "colt", "magnum"),
}  # fmt: skip
_NO: dict[str, tuple[str, ...]] = {
    "open": ("closed", "shut", "folded"),
    "up": ("closed", "furled", "folded", "rolled"),
    "lit": ("unlit", "dead", "cold", "off", "out"),
    "on": ("off",),
    "food": ("empty",),
    "stripes": ("leopard", "panther", "jaguar", "cheetah", "cougar", "lynx", "puma", "lioness"),
    "antlers": ("doe", "fawn", "hind"),
}


def words_of(phrase: str) -> list[str]:
    """Return the lower-case words of a phrase; a possessive loses its owner's mark and its owner."""
    phrase = re.sub(r"\b\w+(?:'s|s'|’s)\s+", "", phrase.lower().replace("_", " ").replace("-", " "))
    return re.findall(r"[a-z0-9]+", phrase)


def read_variant(entry: PropEntry, phrase: str) -> dict[str, ParamValue]:
    """Return the builder parameters that a phrase asks of a prop.

    Args:
        entry: The prop.
        phrase: Such as ``an old red leather armchair``.
    """
    words = words_of(phrase)
    params: dict[str, ParamValue] = {}
    own = {*entry.name.split(), *entry.tags}
    material = next((MATERIALS[word] for word in words if word in MATERIALS and word not in own), None)
    if material is not None and entry.materials and material != next(iter(entry.materials.values())):
        params["material"] = material
    color = next((COLORS[word] for word in words if word in COLORS and word not in entry.name.split()), None)
    if color is not None and entry.materials:
        params["color"] = color
    for name, default in entry.params.items():
        if isinstance(default, bool):
            if any(word in words for word in _YES.get(name, ())):
                params[name] = True
            elif any(word in words for word in _NO.get(name, ())):
                params[name] = False
        elif name == "period":
            found = next((_PERIODS[word] for word in words if word in _PERIODS), None)
            if found is not None and found != default:
                params[name] = found
    return params
