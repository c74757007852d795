"""Catalog entries of props: wild animals, farm animals and a dragon."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry
from storyblender.look.surface import Surface
from storyblender.memory.base import Vec3

SLEEPERS = frozenset(["wolf", "fox", "bear", "lion", "tiger", "pig", "sheep"])
"""Beasts that can be built lying down; ``asleep`` asks for it."""


def _beast(
    key: str, words: str, size: Vec3, materials: dict[str, str], description: str, color: str = "", **flags: bool
) -> PropEntry:
    """Return the entry of an animal of one coat colour."""
    sleeps = {"asleep": False} if key in SLEEPERS else {}
    params = {**({"color": color} if color else {}), **flags, **sleeps}
    return entry("animal", key, words, size, materials, description, params=params, surface=Surface.HAIR)


BEASTS: tuple[PropEntry, ...] = (
    _beast("wolf", "werewolf, coyote, jackal, dingo, hyena", (0.3, 1.5, 0.95), {"coat": "fabric"}, "A standing wolf."),
    _beast("fox", "vixen, red fox", (0.2, 1.1, 0.5), {"coat": "clay"}, "A red fox.", "#b0602c"),
    _beast("bear", "grizzly, brown bear, polar bear", (0.85, 2.3, 1.5), {"coat": "leather"}, "A bear on four feet."),
    _beast("lion", "lion king", (0.7, 2.4, 1.3), {"coat": "sand", "mane": "leather"}, "A lion with a mane."),
    _beast("tiger", "leopard, panther, jaguar, cheetah, cougar, lynx, puma, lioness", (0.5, 2.3, 1.2), {"coat": "sand"},
        "A great cat; striped is a tiger.", "#b8763a", stripes=True),
    _beast("pig", "hog, sow, boar, wild boar, piglet, swine", (0.5, 1.4, 0.75), {"coat": "clay"}, "A pig.", "#d39c88"),
    _beast("goat", "billy goat, nanny goat", (0.34, 1.1, 1.1), {"coat": "linen", "horn": "wood_gray"}, "A goat."),
    _beast("sheep", "ram, ewe", (0.55, 1.3, 0.9), {"wool": "linen", "face": "leather_black"}, "A woolly sheep."),
    _beast("deer", "stag, doe, fawn, reindeer, antelope, gazelle", (0.75, 1.55, 2.05), {"coat": "leather"}, "A stag.",
        "#8a5f3c", antlers=True),
    _beast("rabbit", "hare, bunny", (0.18, 0.4, 0.32), {"coat": "fabric"}, "A sitting rabbit."),
    _beast("mouse", "hamster, mice, guinea pig, gerbil", (0.05, 0.25, 0.06), {"coat": "fabric"}, "A mouse."),
    _beast("elephant", "mammoth", (1.9, 4.4, 2.7), {"skin": "rock", "tusk": "porcelain"}, "An elephant."),
    _beast("snake", "serpent, rattlesnake, cobra, viper, python", (0.36, 0.4, 0.33), {"skin": "leather"},
        "A coiled snake.", "#5d6a34"),
    _beast("dragon", "wyvern, winged dragon", (4.6, 5.0, 3.0),
        {"skin": "leather", "wing": "leather", "horn": "wood_gray"}, "A winged dragon.", "#4c6a3a"),
)  # fmt: skip
