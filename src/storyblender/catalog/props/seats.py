"""Catalog entries of props: things to sit on."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry

_WOOD = {"frame": "wood", "seat": "wood"}

SEATS: tuple[PropEntry, ...] = (
    entry("furniture", "chair", "wooden chair, dining chair, kitchen chair, seat, cafe chair", (0.46, 0.52, 0.92),
        _WOOD, "A plain wooden chair with a slatted or bentwood back.", params={"style": "slat"}, seats=1),
    entry("furniture", "armchair", "easy chair, lounge chair, upholstered chair, wing chair, comfy chair",
        (0.84, 0.86, 0.94), {"cover": "fabric_green", "leg": "wood_dark"}, "A stuffed chair with arms.",
        params={"wings": False}, seats=1),
    entry("furniture", "sofa", "couch, settee, loveseat, divan, chesterfield", (1.95, 0.9, 0.84),
        {"cover": "fabric_red", "leg": "wood_dark"}, "A stuffed sofa.", params={"cushions": 3.0}, seats=3),
    entry("furniture", "office_chair", "swivel chair, desk chair, computer chair", (0.62, 0.62, 1.02),
        {"cover": "leather_black", "metal": "steel"}, "A chair that turns, on five castors.", seats=1),
    entry("furniture", "stool", "footstool, milking stool, three-legged stool, piano stool, piano bench",
        (0.36, 0.36, 0.46), {"seat": "wood", "frame": "wood"}, "A round stool.", params={"cushion": False}, seats=1),
    entry("furniture", "bar_stool", "high stool, counter stool, pub stool", (0.4, 0.4, 0.76),
        {"cover": "leather", "metal": "chrome"}, "A tall stool on one foot.", seats=1),
    entry("furniture", "bench", "wooden bench, settle, hall bench, waiting bench", (1.8, 0.42, 0.46), _WOOD,
        "A plain bench without a back.", seats=3),
    entry("furniture", "pew", "church bench, courtroom bench, station bench", (1.8, 0.58, 0.94), _WOOD,
        "A high-backed wooden bench.", seats=4),
    entry("furniture", "rocking_chair", "rocker, porch chair", (0.62, 0.9, 1.08), _WOOD,
        "A wooden chair on curved runners.", seats=1),
    entry("furniture", "deck_chair", "beach chair, lounger, sun lounger, folding chair, camping chair, camp chair",
        (0.6, 1.05, 0.88), {"cover": "canvas", "frame": "wood_light"}, "A sling of canvas in a folding frame.",
        seats=1),
    entry("furniture", "wheelchair", "invalid chair, hospital chair", (0.66, 1.0, 0.92),
        {"cover": "leather_black", "metal": "steel", "tyre": "rubber"}, "A chair with two large wheels.", seats=1),
    entry("furniture", "booth", "banquette, diner booth, restaurant bench", (1.5, 0.66, 1.12),
        {"cover": "leather", "frame": "wood_dark"}, "A fixed upholstered bench with a high back.", seats=2),
    entry("furniture", "carriage_seat", "train seat, bus seat, compartment seat, back seat", (1.1, 0.6, 1.24),
        {"cover": "fabric_red", "frame": "wood_dark"}, "An upholstered bench for two with arms and a high back.",
        seats=2),
    entry("furniture", "car_seat", "front seat, passenger seat, driver's seat, bucket seat, driver seat",
        (0.58, 0.62, 1.22), {"cover": "leather", "frame": "iron"},
        "An upholstered seat for one with a headrest, as in the front of a car.", seats=1),
    entry("furniture", "porch_swing", "hanging bench, swing seat, garden swing, hammock seat", (1.5, 0.66, 2.66), _WOOD,
        "A bench with a back that hangs on chains.", seats=3),
    entry("furniture", "throne", "royal chair, king's chair, ceremonial seat", (0.96, 0.86, 1.9),
        {"frame": "gold", "cover": "fabric_red"}, "A carved state chair.", seats=1),
)  # fmt: skip
