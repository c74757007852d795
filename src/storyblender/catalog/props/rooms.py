"""Catalog entries of props: furnishings of nurseries, sickrooms, Japanese rooms and offices."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held

ROOMS: tuple[PropEntry, ...] = (
    entry("furniture", "rocking_horse", "wooden horse, hobby horse, toy horse", (0.34, 1.05, 0.95),
        {"body": "wood_light", "runner": "wood_red", "saddle": "fabric_red", "mane": "plastic_black"},
        "A wooden horse on rockers.", seats=1),
    entry("furniture", "dolls_house", "doll's house, dollhouse, doll house, toy house, model house", (0.7, 0.4, 0.78),
        {"wall": "paint", "roof": "shingles", "pane": "glass_dark", "trim": "linen"}, "A doll's house.",
        params={"color": "#c98f8b"}),
    held("toy_blocks", "building blocks, toy bricks, alphabet blocks, wooden blocks, toys", (0.3, 0.3, 0.2),
        {"a": "fabric_red", "b": "fabric_blue", "c": "wood_light"}, "A heap of toy blocks."),
    entry("furniture", "heart_monitor",
        "heart monitor, hospital monitor, ecg monitor, patient monitor, vital signs monitor, ventilator, life "
        "support machine, respirator", (0.46, 0.5, 1.42),
        {"body": "plastic", "metal": "steel", "screen": "screen", "wheel": "rubber"},
        "A monitor with its curve on a wheeled stand."),
    entry("furniture", "drip_stand",
        "drip, iv, iv drip, iv stand, iv pole, iv bag, infusion stand, saline drip, blood bag", (0.5, 0.5, 1.85),
        {"metal": "chrome", "bag": "linen", "wheel": "rubber"}, "A bag on a wheeled pole."),
    held("clipboard", "medical chart, patient chart, chart on a board", (0.23, 0.32, 0.02),
        {"board": "wood", "paper": "paper", "clip": "steel"}, "A board with a clip and a sheet."),
    held("mop", "floor mop, string mop, swab", (0.3, 0.16, 1.42), {"handle": "wood_light", "strings": "linen"},
        "A mop."),
    held("tape_recorder",
        "reel-to-reel, tape machine, cassette recorder, dictaphone, tape deck, cassette player, voice recorder",
        (0.34, 0.26, 0.12), {"body": "leather_black", "metal": "steel", "reel": "plastic"},
        "A tape recorder with two reels."),
    entry("fitting", "whiteboard", "white board, marker board, tactics board, dry erase board, flip chart",
        (1.8, 0.1, 1.15), {"board": "enamel", "frame": "steel", "ink": "fabric_blue"}, "A white writing board.",
        placement="wall"),
    entry("street", "fishing_net", "net, fish net, trawl net, heap of nets, cargo net", (1.1, 0.9, 0.34),
        {"cord": "canvas", "float": "clay"}, "A heap of net with its floats."),
    entry("furniture", "brazier", "charcoal burner, hibachi, fire bowl, fire basket, coal fire, fire pit",
        (0.5, 0.5, 0.4), {"body": "iron", "coal": "ember"}, "An iron bowl of glowing coals.", lamp=(0, 0, 0.42)),
    entry("furniture", "floor_cushion",
        "zabuton, meditation cushion, floor pillow, sitting mat, prayer mat, tatami cushion", (0.6, 0.6, 0.09),
        {"cover": "fabric_blue"}, "A flat square cushion to sit on upon the floor."),
    entry("fitting", "hanging_scroll", "wall scroll, kakemono, calligraphy, silk painting", (0.5, 0.04, 1.2),
        {"silk": "canvas", "paper": "paper", "rod": "wood_black", "ink": "plastic_black"},
        "A scroll of calligraphy that hangs on a wall.", placement="wall"),
)  # fmt: skip
