"""Catalog entries of props: cars, boats, aeroplanes, carts."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry
from storyblender.memory.base import Vec3

_CAR = {"body": "paint", "trim": "plastic_black", "chrome": "chrome", "tyre": "rubber", "lamp": "lamp_warm"}


_PART = {"body": "plastic_black", "metal": "chrome"}


def _car(
    key: str, words: str, size: Vec3, description: str, color: str = "", band: str = "", **params: str
) -> PropEntry:
    """Return a car with seats; its option ``open`` names the open doors, or ``all``."""
    given = {"open": "", **({"color": color} if color else {}), **params}
    materials = _CAR | ({"band": band} if band else {})
    return entry("vehicle", key, words, size, materials, description, params=given, seats=2 if key in _TWO_SEATS else 4)


def _craft(
    key: str, words: str, size: Vec3, description: str, color: str, trim: str = "steel", seats: int = 0
) -> PropEntry:
    """Return an aircraft, vessel or work machine with one body colour and a trim."""
    materials = {"body": "paint", "trim": trim, "chrome": "chrome", "lamp": "lamp_warm"}
    return entry("vehicle", key, words, size, materials, description, params={"color": color}, seats=seats)


_TWO_SEATS = frozenset({"pickup", "van", "ambulance"})

VEHICLES: tuple[PropEntry, ...] = (
    _car("car", "motorcar, automobile, sedan, limousine, limo, vehicle, sports car, saloon, hatchback, station wagon, "
        "estate car, coupe, hearse, rental car, getaway car, race car, hot rod, auto", (1.82, 4.6, 1.56),
        "A four-door car to sit in; period 1940s or modern.", period="modern"),
    _car("taxi", "cab, taxicab, taxi cab, minicab, yellow cab, uber", (1.82, 4.6, 1.56), "A taxi to sit in.",
        "#c79a1e"),
    _car("police_car", "patrol car, squad car, police cruiser, cop car, panda car, sheriff's car", (1.82, 4.6, 1.56),
        "A police car to sit in.", "#e4e6e8", band="fabric_blue"),
    _car("convertible", "roadster, cabriolet, open-top car, open car, sports convertible, open sports car",
        (1.8, 4.4, 1.34), "An open car to sit in.", "#8c2320"),
    _car("jeep", "suv, land rover, four-by-four, 4x4, off-roader, army jeep", (1.84, 4.1, 1.78),
        "A car for rough ground.", "#5e6238"),
    _car("pickup", "pickup truck, pick-up, pick-up truck, ute, flatbed pickup", (1.9, 5.2, 1.76),
        "A pickup with an open bed.", "#7a2a22"),
    _car("van", "delivery van, minibus, camper, police van, camper van, minivan, motorhome, ice cream van, mail van, "
        "transit van, moving van, rv, food truck", (1.95, 5.0, 2.15), "A van to sit in."),
    _car("ambulance", "emergency ambulance, paramedics' van", (1.95, 5.2, 2.15), "An ambulance.", "#e8e8e4"),
    entry("vehicle", "truck", "lorry, army truck, dump truck, moving truck, semi, juggernaut", (2.2, 6.2, 2.5),
        {"body": "paint", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber", "lamp": "lamp_warm",
        "bed": "wood"}, "A truck with a wooden bed.", seats=2),
    entry("vehicle", "bus", "coach, school bus, city bus", (2.5, 9.0, 3.0),
        {"body": "paint", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber", "lamp": "lamp_warm"},
        "A bus to sit in.", params={"open": False}, seats=9),
    _craft("helicopter", "chopper, rescue helicopter, police helicopter", (8.9, 7.6, 2.95),
        "A helicopter with two open seats.", "#37506a", seats=2),
    _craft("light_plane",
        "small plane, cessna, biplane, propeller plane, seaplane, light aircraft, crop duster, glider",
        (10.2, 7.6, 2.7), "A small aeroplane with two seats.", "#e0dccf", "fabric_red", seats=2),
    _craft("jet", "jetliner, jumbo jet, private jet, passenger jet, jet plane, airbus, boeing, fighter jet",
        (32.0, 34.0, 10.5), "A jet airliner.", "#dfe2e4", "fabric_blue"),
    _craft("rocket", "spaceship, spacecraft, rocket ship, starship, space rocket, space shuttle, missile",
        (3.6, 3.6, 10.4), "A rocket on its fins.", "#d9d9d4", "fabric_red"),
    _craft("flying_saucer", "ufo, alien ship, alien craft", (8.0, 8.0, 3.65), "A flying saucer.", "#9aa4aa"),
    _craft("tractor", "farm tractor, combine harvester, harvester, lawn tractor", (1.9, 3.2, 2.15), "A tractor.",
        "#8c2a20", seats=1),
    _craft("fire_engine", "fire truck, firetruck, fire brigade", (2.4, 8.0, 3.1), "A fire engine.", "#a81c18", seats=2),
    _craft("locomotive",
        "steam engine, steam train, train, steam locomotive, engine of a train, railway engine, toy train",
        (2.5, 9.8, 4.1), "A steam engine.", "#2f4a38", "fabric_red"),
    _craft("battle_tank", "army tank, panzer, military tank, armoured tank", (3.2, 7.7, 2.3), "A tank.", "#5a5f3e"),
    entry("vehicle", "airliner", "airplane, plane, aeroplane, aircraft, passenger plane, old airliner",
        (29.0, 19.6, 5.2),
        {"body": "sheet_metal", "dark": "iron", "glass": "glass_dark", "chrome": "chrome", "tyre": "rubber"},
        "A twin-engine airliner of the 1940s."),
    entry("vehicle", "bicycle", "bike, push bike, tricycle, tandem", (0.6, 1.75, 1.05),
        {"frame": "paint", "tyre": "rubber", "metal": "chrome", "saddle": "leather"}, "A bicycle."),
    entry("vehicle", "motorcycle", "motorbike, scooter, moped", (0.75, 2.1, 1.1),
        {"body": "paint", "tyre": "rubber", "metal": "chrome", "saddle": "leather_black", "lamp": "lamp_warm"},
        "A motorcycle.", seats=1),
    entry("vehicle", "cart", "wagon, handcart, carriage, horse cart, stagecoach, pushcart, rickshaw", (1.5, 3.0, 1.45),
        {"body": "wood", "wheel": "wood_dark", "iron": "iron"}, "A two-wheeled cart with shafts."),
    entry("vehicle", "rowing_boat", "rowboat, boat, dinghy, canoe, lifeboat, gondola, kayak, raft", (1.45, 4.0, 0.75),
        {"hull": "wood", "inside": "wood_light", "oar": "wood"}, "A rowing boat with oars.", seats=2),
    entry("vehicle", "pram", "baby carriage, stroller, pushchair", (0.6, 1.0, 1.05),
        {"body": "fabric_blue", "metal": "chrome", "tyre": "rubber"}, "A baby carriage."),
    entry("fitting", "steering_wheel", "car wheel rim, steering column", (0.37, 0.28, 0.34), _PART,
        "The steering wheel of a car.", placement="surface"),
    entry("fitting", "rear_view_mirror", "rearview mirror, rear-view mirror, driving mirror, car mirror",
        (0.24, 0.06, 0.16), _PART, "The mirror over a car's windscreen.", placement="surface"),
    entry("fitting", "seat_lever", "seat adjuster, seat release", (0.34, 0.08, 0.03), _PART,
        "The bar by which a car's seat slides.", placement="surface"),
    entry("fitting", "car_pedals", "pedals, brake pedal, gas pedal, clutch pedal, accelerator pedal",
        (0.36, 0.1, 0.2), _PART, "The pedals of a car."),
    entry("fitting", "car_mat", "floor mat, car floor mat, rubber mat", (0.5, 0.5, 0.012), {"cover": "rubber"},
        "A rubber mat."),
)  # fmt: skip
