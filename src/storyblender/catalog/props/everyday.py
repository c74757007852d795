"""Catalog entries of props: what scripts name in passing: gates, hooks, buttons, small gear."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held
from storyblender.look.surface import Surface

EVERYDAY: tuple[PropEntry, ...] = (
    entry("street", "gate", "garden gate, iron gate, farm gate, wooden gate, front gate", (1.9, 0.14, 1.35),
        {"metal": "iron", "post": "brick"}, "Two iron leaves between brick posts."),
    entry("street", "bollard", "mooring post, mooring bollard, capstan", (0.46, 0.46, 0.56), {"metal": "iron"},
        "An iron bollard with a broad head, low enough to sit on.", seats=1),
    entry("fitting", "wall_hook", "hook, coat hook, peg, coat peg", (0.06, 0.09, 0.12), {"metal": "brass"},
        "A double hook on a plate.", placement="wall"),
    entry("fitting", "button_panel",
        "button, alarm button, panel, lift panel, button board, switch, light switch, intercom, doorbell, fuse box, "
        "keypad, entryphone", (0.14, 0.04, 0.3), {"body": "steel", "key": "porcelain", "alarm": "fabric_red"},
        "A plate with two rows of buttons, the lowest red.", placement="wall"),
    entry("fitting", "security_camera", "surveillance camera, cctv, cctv camera, spy camera", (0.11, 0.3, 0.2),
        {"body": "plastic_black", "lens": "glass_dark", "lamp": "neon_red"},
        "A camera on a bracket that looks down into the room.", placement="wall"),
    entry("fitting", "loudspeaker", "speaker, wall speaker, tannoy, public address", (0.22, 0.16, 0.32),
        {"body": "plastic_black", "cone": "rubber", "ring": "steel"}, "A loudspeaker box with two cones.",
        placement="wall"),
    entry("fitting", "reactor", "engine core, reactor core, generator, turbine, ship's engine, dynamo", (1.5, 1.5, 2.3),
        {"body": "steel", "dark": "iron", "glow": "neon_blue", "pipe": "copper"},
        "A banded core that glows through slots, pipes around its foot."),
    entry("nature", "christmas_tree", "xmas tree, decorated tree", (1.15, 1.15, 2.1),
        {"leaf": "leaves_dark", "bark": "bark", "star": "gold", "ball": "fabric_red"},
        "A small fir in a bucket with balls and a star: what a tree is that somebody brought indoors.",
        surface=Surface.FOLIAGE),
    entry("street", "mast", "ship's mast, flagpole, flagstaff", (1.5, 0.24, 3.2), {"wood": "wood", "rope": "canvas"},
        "A mast with a yard, a furled sail and stays."),
    entry("vehicle", "sailing_ship",
        "ship, small ship, sailing boat, sailboat, yacht, sloop, schooner, galleon, fishing smack", (1.9, 5.2, 4.4),
        {"hull": "wood_dark", "deck": "planks", "sail": "canvas", "rope": "wood_gray"},
        "A small ship with one mast, its sail furled; the bow to -Y."),
    entry("vehicle", "sledge", "sled, sleigh, toboggan, snow sledge", (0.5, 1.15, 0.3),
        {"wood": "wood_light", "metal": "steel"}, "A wooden sledge on steel runners.", seats=1),
    held("headset", "headphones, earphones, ear defenders, earmuffs", (0.19, 0.09, 0.2),
        {"body": "plastic_black", "pad": "rubber"}, "A headset with a small microphone."),
    held("keyboard", "computer keyboard", (0.44, 0.15, 0.03), {"body": "plastic_black", "key": "plastic"},
        "A keyboard."),
    held("memory_stick", "usb stick, usb drive, flash drive, thumb drive, memory card, data chip",
        (0.024, 0.065, 0.012), {"body": "plastic_black", "metal": "steel"}, "A memory stick."),
    held("truncheon", "nightstick, police baton, cosh, blackjack", (0.04, 0.04, 0.46), {"body": "rubber"},
        "A truncheon, standing on its handle."),
    held("compass", "pocket compass, brass compass", (0.08, 0.095, 0.024),
        {"body": "brass", "face": "porcelain", "needle": "paint"}, "A compass, open, its ring to -Y."),
    held("plank", "board, wooden board, floorboard", (1.3, 0.18, 0.03), {"wood": "wood_gray"}, "A rough plank."),
    held("grapes", "grape, bunch of grapes, cluster of grapes", (0.13, 0.1, 0.19),
        {"fruit": "glass_dark", "stem": "wood"}, "A bunch of dark grapes."),
)  # fmt: skip
