"""Catalog entries of props of laboratories, courts and offices."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held
from storyblender.look.surface import Surface

LABORATORY: tuple[PropEntry, ...] = (
    held("microscope", "light microscope", (0.16, 0.22, 0.38), {"body": "plastic_black", "metal": "brass"},
        "A microscope; one looks into it from +Y."),
    held("test_tubes", "test tube, rack of test tubes, test tube rack, vials", (0.22, 0.06, 0.17),
        {"rack": "wood_light", "glass": "glass"}, "Test tubes in a rack.", None, Surface.GLASS),
    held("beaker", "erlenmeyer flask, conical flask, glass flask, potion, retort, petri dish, pipette",
        (0.11, 0.11, 0.17), {"glass": "glass", "liquid": "neon_blue"}, "A conical flask, part full.", None,
        Surface.GLASS),
    held("scales", "scale, balance, pair of scales, kitchen scales, weighing scale, scales of justice",
        (0.5, 0.18, 0.44), {"metal": "brass", "base": "wood_dark"}, "A balance with two pans."),
    entry("fitting", "robot", "android, droid, automaton, cyborg", (0.72, 0.42, 1.75),
        {"body": "enamel", "joint": "iron", "eye": "neon_blue"}, "A standing robot."),
    held("gavel", "judge's gavel, auctioneer's hammer", (0.13, 0.3, 0.09), {"wood": "wood_red", "band": "brass"},
        "A gavel on its block."),
    held("fire_extinguisher", "extinguisher", (0.24, 0.17, 0.5), {"body": "fabric_red", "hose": "plastic_black"},
        "A fire extinguisher.", {"color": "#a8231c"}),
)  # fmt: skip
