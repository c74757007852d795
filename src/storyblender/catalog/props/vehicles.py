"""Cars, boats, aeroplanes, carts."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry

VEHICLES: tuple[PropEntry, ...] = (
    entry(
        "vehicle",
        "car",
        "motorcar, automobile, sedan, taxi, cab, police car, limousine, vehicle, convertible, roadster, sports car",
        (1.8, 4.5, 1.5),
        {"body": "paint", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber", "lamp": "lamp_warm"},
        "A four-door car; period 1940s or modern.",
        params={"period": "modern"},
    ),
    entry(
        "vehicle",
        "van",
        "delivery van, minibus, ambulance, camper, police van",
        (1.95, 4.9, 2.15),
        {"body": "paint", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber", "lamp": "lamp_warm"},
        "A van.",
    ),
    entry(
        "vehicle",
        "truck",
        "lorry, pickup, pickup truck, army truck",
        (2.2, 6.2, 2.5),
        {
            "body": "paint",
            "glass": "glass_dark",
            "chrome": "chrome",
            "tyre": "rubber",
            "lamp": "lamp_warm",
            "bed": "wood",
        },
        "A truck with a wooden bed.",
    ),
    entry(
        "vehicle",
        "bus",
        "coach, school bus, city bus",
        (2.5, 9.0, 3.0),
        {"body": "paint", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber", "lamp": "lamp_warm"},
        "A bus.",
    ),
    entry(
        "vehicle",
        "airliner",
        "airplane, plane, aeroplane, aircraft, passenger plane, propeller plane",
        (29.0, 19.6, 5.2),
        {"body": "sheet_metal", "dark": "iron", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber"},
        "A twin-engine airliner of the 1940s.",
    ),
    entry(
        "vehicle",
        "bicycle",
        "bike, push bike, tricycle, tandem",
        (0.6, 1.75, 1.05),
        {"frame": "paint", "tyre": "rubber", "metal": "chrome", "saddle": "leather"},
        "A bicycle.",
    ),
    entry(
        "vehicle",
        "motorcycle",
        "motorbike, scooter, moped",
        (0.75, 2.1, 1.1),
        {"body": "paint", "tyre": "rubber", "metal": "chrome", "saddle": "leather_black", "lamp": "lamp_warm"},
        "A motorcycle.",
        seats=1,
    ),
    entry(
        "vehicle",
        "cart",
        "wagon, handcart, carriage, horse cart, stagecoach, pushcart, rickshaw",
        (1.5, 3.0, 1.45),
        {"body": "wood", "wheel": "wood_dark", "iron": "iron"},
        "A two-wheeled cart with shafts.",
    ),
    entry(
        "vehicle",
        "rowing_boat",
        "rowboat, boat, dinghy, canoe, lifeboat, gondola, kayak, raft",
        (1.45, 4.0, 0.75),
        {"hull": "wood", "inside": "wood_light", "oar": "wood"},
        "A rowing boat with oars.",
        seats=2,
    ),
    entry(
        "vehicle",
        "pram",
        "baby carriage, stroller, pushchair",
        (0.6, 1.0, 1.05),
        {"body": "fabric_blue", "metal": "chrome", "tyre": "rubber"},
        "A baby carriage.",
    ),
)
