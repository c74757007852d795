"""Catalog entries of props: jars, pots and food."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held
from storyblender.look.surface import Surface

PANTRY: tuple[PropEntry, ...] = (
    held("jar",
        "jam jar, cookie jar, biscuit jar, pickle jar, mason jar, tip jar, honey jar, preserving jar, candy jar, jam",
        (0.11, 0.11, 0.17), {"glass": "glass", "lid": "brass", "filling": "leather"},
        "A glass jar with a label; with tips in it, or filled and closed.", {"money": False}, Surface.GLASS),
    held("tin_can", "tin, can, tin of beans, can of beans, soda can, beer can, paint can, canister, caddy, soda, cola",
        (0.085, 0.085, 0.115), {"label": "fabric_red", "tin": "steel"}, "A tin with a label."),
    held("canteen", "flask, hip flask, wineskin, gourd bottle", (0.18, 0.07, 0.24),
        {"cover": "canvas", "metal": "steel"}, "A round flask on a strap."),
    held("jug", "pitcher, carafe, decanter, water jug, ewer, milk jug, milk bottle", (0.22, 0.15, 0.25),
        {"body": "porcelain", "drink": "water"}, "A jug.", {"drink": ""}),
    held("pot",
        "cooking pot, saucepan, stockpot, stewpot, casserole, soup pot, soup kettle, colander, tureen, soup tureen",
        (0.36, 0.28, 0.26), {"body": "steel", "handle": "plastic_black"}, "A pot with its lid."),
    entry("furniture", "cauldron", "witch's kettle, kettle pot, brewing pot", (0.7, 0.7, 0.62),
        {"iron": "iron", "brew": "leaves"}, "An iron cauldron on three feet."),
    held("ladle", "soup ladle, whisk, spatula, wooden spoon, tongs, kitchen spoon", (0.09, 0.34, 0.07),
        {"body": "steel"}, "A ladle."),
    held("rolling_pin", "dough roller", (0.42, 0.06, 0.06), {"wood": "wood_light"}, "A rolling pin."),
    held("cutting_board", "chopping board, bread board, breadboard", (0.28, 0.42, 0.022), {"wood": "wood"}, "A board."),
    held("pizza_box", "pizza, pizza carton, takeout box, takeaway box, take-out box, box of pizza", (0.36, 0.36, 0.045),
        {"card": "cardboard", "print": "fabric_red"}, "A flat pizza carton."),
    held("egg", "boiled egg, hen's egg, easter egg, golden egg", (0.045, 0.045, 0.06), {"shell": "linen"}, "An egg."),
    held("banana", "bananas, bunch of bananas", (0.13, 0.21, 0.07), {"skin": "plastic"}, "Three bananas.",
        {"color": "#d8b13a"}),
)  # fmt: skip
