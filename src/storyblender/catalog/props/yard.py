"""Catalog entries of props of smithies, stables, nurseries and feasts."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held

YARD: tuple[PropEntry, ...] = (
    entry("fitting", "paper_lantern", "chinese lantern, japanese lantern, lampion, hanging lantern, string of lanterns",
        (0.4, 0.4, 0.95), {"paper": "lampshade", "rim": "plastic_black"}, "A ribbed lantern of paper; it hangs.",
        placement="ceiling", lamp=(0, 0, 0.3)),
    held("birdcage", "cage, bird cage, parrot cage, small cage", (0.36, 0.36, 0.56),
        {"wire": "brass", "base": "wood_dark"}, "A domed cage."),
    held("chalice", "goblet, golden cup, grail, holy grail, wine cup", (0.1, 0.1, 0.17),
        {"metal": "gold", "drink": "fabric_red"}, "A goblet of gold."),
    entry("fitting", "water_pump", "pump, hand pump, village pump, well pump, yard pump", (0.42, 0.6, 1.25),
        {"iron": "iron", "foot": "stone"}, "A pump with its handle and spout."),
    entry("furniture", "anvil", "blacksmith's anvil, smith's anvil", (0.66, 0.4, 0.78),
        {"iron": "iron", "block": "bark"}, "An anvil on a block."),
    entry("vehicle", "wheelbarrow", "barrow, garden cart", (0.64, 1.5, 0.66),
        {"tray": "sheet_metal", "wood": "wood", "iron": "iron"}, "A wheelbarrow; pushed from +Y."),
    entry("furniture", "wagon_wheel", "wheel, cartwheel, cart wheel, spoked wheel, ship's wheel, spare wheel",
        (1.1, 0.2, 1.1), {"wood": "wood", "iron": "iron"}, "A spoked wheel on its rim."),
    entry("furniture", "spinning_wheel", "spinning jenny, spindle, distaff, loom", (0.95, 0.5, 1.1), {"wood": "wood"},
        "A spinning wheel; one spins at -Y."),
    entry("furniture", "stretcher", "litter, field stretcher, canvas stretcher, camp bed", (0.58, 2.2, 0.16),
        {"canvas": "canvas", "pole": "wood"}, "A canvas stretcher on two poles."),
    held("saddle", "horse saddle, western saddle, saddlebag, saddlebags", (0.5, 0.56, 0.44),
        {"leather": "leather", "metal": "steel"}, "A saddle with its stirrups."),
    entry("street", "trough", "water trough, horse trough, feeding trough, manger, watering trough", (1.6, 0.56, 0.5),
        {"wood": "wood_gray", "water": "water"}, "A trough full of water."),
    held("bone", "dog bone, thigh bone, femur, bones, rib", (0.22, 0.08, 0.045), {"body": "linen"}, "A bone."),
    entry("fitting", "water_cooler", "water dispenser, drinking fountain, cooler", (0.32, 0.36, 1.15),
        {"body": "enamel", "bottle": "glass"}, "A water cooler."),
)  # fmt: skip
