"""Catalog entries of props: trees, rocks, fire, animals."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry
from storyblender.look.surface import Surface

NATURE: tuple[PropEntry, ...] = (
    entry("nature", "tree", "oak, broad-leaved tree, maple, elm, apple tree, birch", (5.2, 5.2, 7.0),
        {"leaf": "leaves", "bark": "bark"}, "A broad tree.", params={"kind": "broad"}, surface=Surface.FOLIAGE),
    entry("nature", "pine", "fir tree, pine tree, fir, conifer, spruce, evergreen", (3.0, 3.0, 8.0),
        {"leaf": "leaves_dark", "bark": "bark"}, "A conifer.", surface=Surface.FOLIAGE),
    entry("nature", "palm_tree", "palm, coconut palm", (4.4, 4.4, 7.0), {"leaf": "leaves", "bark": "bark"}, "A palm.",
        surface=Surface.FOLIAGE),
    entry("nature", "dead_tree", "bare tree, leafless tree, winter tree", (4.0, 4.0, 6.0), {"bark": "bark"},
        "A tree without leaves."),
    entry("nature", "bush", "shrub, hedge, thicket, undergrowth", (1.3, 1.2, 1.0), {"leaf": "leaves"}, "A bush.",
        surface=Surface.FOLIAGE),
    entry("nature", "tuft", "grass, tall grass, reeds, weeds, wheat", (0.5, 0.5, 0.42), {"leaf": "leaves"},
        "A tuft of grass.", surface=Surface.NO_INK),
    entry("nature", "rock", "stone, boulder, rocks", (1.2, 1.0, 0.8), {"rock": "rock"}, "A rock."),
    entry("nature", "standing_stone", "menhir, megalith, monolith, rune stone, stone circle, dolmen", (1.2, 0.7, 2.7),
        {"rock": "rock"}, "A stone that stands upright."),
    entry("nature", "log", "fallen tree, tree trunk, log seat, driftwood", (2.2, 0.46, 0.46),
        {"bark": "bark", "cut": "wood_light"}, "A log to sit on.", seats=2),
    entry("nature", "stump", "tree stump, chopping block", (0.6, 0.6, 0.45), {"bark": "bark", "cut": "wood_light"},
        "A tree stump.", seats=1),
    entry("nature", "campfire", "fire, bonfire, camp fire", (0.95, 0.95, 0.7),
        {"wood": "bark", "stone": "rock", "fire": "fire", "core": "flame", "ember": "ember"},
        "A fire in a ring of stones.", params={"lit": True}, lamp=(0, 0, 0.35)),
    entry("nature", "hay_bale", "haystack, straw bale, hay, sheaf", (1.1, 0.55, 0.5), {"straw": "thatch"},
        "A bale of hay.", seats=2),
    entry("nature", "cactus", "saguaro", (1.1, 0.5, 2.4), {"skin": "leaves_dark"}, "A cactus.",
        surface=Surface.FOLIAGE),
    entry("nature", "pumpkin", "jack-o'-lantern, gourd", (0.36, 0.36, 0.32), {"skin": "leaves_autumn", "stem": "bark"},
        "A pumpkin.", placement="surface", holdable=True),
    entry("nature", "snowman", "snow man", (0.8, 0.8, 1.6),
        {"snow": "snow", "coal": "plastic_black", "nose": "leaves_autumn"}, "A snowman."),
)  # fmt: skip

ANIMALS: tuple[PropEntry, ...] = (
    entry("animal", "dog", "puppy, hound, guard dog, german shepherd, lurcher, mongrel, terrier, spaniel, greyhound",
        (0.26, 0.95, 0.68), {"coat": "leather", "nose": "plastic_black"}, "A standing dog.", params={"asleep": False},
        surface=Surface.HAIR),
    entry("animal", "cat", "kitten, tomcat, stray cat", (0.2, 0.5, 0.42), {"coat": "fabric", "nose": "plastic_black"},
        "A sitting cat.", params={"asleep": False}, surface=Surface.HAIR),
    entry("animal", "horse", "pony, mare, stallion, foal, colt, steed, unicorn, racehorse", (0.6, 2.3, 2.15),
        {"coat": "leather", "mane": "leather_black", "hoof": "iron"}, "A standing horse.", surface=Surface.HAIR),
    entry("animal", "cow", "bull, ox, cattle, buffalo", (0.75, 2.3, 1.5),
        {"coat": "leather", "patch": "linen", "horn": "wax"}, "A standing cow.", params={"asleep": False},
        surface=Surface.HAIR),
    entry("animal", "bird", "birdie, thrush, starling, woodpecker, kingfisher, cuckoo", (0.14, 0.34, 0.26),
        {"coat": "fabric", "beak": "brass"}, "A standing bird.", placement="surface", surface=Surface.HAIR),
    entry("animal", "fish", "trout, salmon, goldfish, herring, cod, carp", (0.1, 0.5, 0.2),
        {"skin": "silver", "eye": "plastic_black"}, "A fish.", placement="surface", holdable=True),
)  # fmt: skip
