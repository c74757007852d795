"""Catalog entries of props: what belongs to one sort of place: a shop's shelves and carts, a cellar's boiler."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry
from storyblender.look.surface import Surface

PLACES: tuple[PropEntry, ...] = (
    entry("furniture", "store_shelf",
        "supermarket shelf, shop shelf, store shelves, grocery shelf, aisle shelf, storage shelf, pantry shelf",
        (1.2, 0.46, 1.9), {"body": "enamel", "jar": "glass_amber", "tin": "steel"}, "Shelves of tins, jars and boxes.",
        params={"rows": 5.0, "fill": 0.94}),
    entry("vehicle", "shopping_cart", "shopping trolley, supermarket cart, grocery cart, trolley, baggage trolley",
        (0.56, 0.94, 1.02), {"wire": "chrome", "grip": "paint", "tyre": "rubber"},
        "A wire basket on four castors; pushed from +Y."),
    entry("fitting", "boiler", "furnace boiler, water heater, hot water tank, heating boiler", (0.9, 0.9, 2.1),
        {"body": "sheet_metal", "pipe": "copper", "iron": "iron"},
        "A round boiler with a fire door, gauges and pipes."),
    entry("fitting", "towel", "beach towel, bath towel, picnic blanket, picnic cloth", (0.9, 1.8, 0.014),
        {"cloth": "fabric_blue", "stripe": "linen"}, "A striped towel spread on the ground.", surface=Surface.CLOTH),
    entry("street", "parasol", "beach umbrella, sunshade, garden umbrella, patio umbrella, market umbrella",
        (2.2, 2.2, 2.15), {"cloth": "fabric_red", "stripe": "linen", "pole": "wood_light"},
        "A striped sunshade on a pole."),
)  # fmt: skip
