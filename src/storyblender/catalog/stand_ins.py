"""Stand-ins: a plain shape by class and size for objects that no catalog prop resembles. Pure data.

A class is found by its word list (exact head nouns first), or by semantic similarity to those words.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.registry import Catalog
from storyblender.memory.base import Frozen, Identifier, Vec3

Shape = Literal["box", "drum", "ball", "slab", "rod", "cone"]


class StandIn(Frozen):
    """One class of unknown things."""

    key: Identifier
    name: str
    tags: tuple[str, ...]
    """Head nouns of things like it."""
    shape: Shape
    size: Vec3
    """Width, depth, height in metres of an average one."""
    material: Identifier
    holdable: bool = False
    prop: Identifier | None = None
    """Catalog prop to build for this class; None builds the plain shape."""


def _class(
    key: str, shape: Shape, size: Vec3, material: str, words: str, holdable: bool = False, prop: str | None = None
) -> StandIn:
    """Return a class of unknown things; ``words`` are its head nouns, separated by commas."""
    return StandIn(
        key=key,
        name=key.replace("_", " "),
        tags=tuple(word.strip() for word in words.split(",")),
        shape=shape,
        size=size,
        material=material,
        holdable=holdable,
        prop=prop,
    )


STAND_INS: Catalog[StandIn] = Catalog(
    "stand-in",
    (
        _class(
            "small_thing",
            "box",
            (0.12, 0.08, 0.08),
            "plastic",
            "thing, object, item, gadget, trinket, souvenir, token, artifact, relic, charm, gem, stone, chip, "
            "pill, tablet of medicine, button, badge, pin, whistle, coin purse, eraser, sponge, soap, chalk, "
            "stapler, tape, lipstick, compact, dice, die, domino, marble, seed, pebble, shell, nugget, fuse, "
            "plug, magnet, timer, calculator, blotter, harmonica, bandage, petal, confetti, spur, horseshoe, "
            "nail, screw, bulb, wig, bell pull, crumb, donut, doughnut, biscuit, cookie, candy, sweet, "
            "chocolate, nest, mouthguard",
            True,
        ),
        _class(
            "device",
            "box",
            (0.2, 0.14, 0.12),
            "steel",
            "device, machine part, instrument, apparatus, detector, recorder, transmitter, controller, drone, "
            "toy, projector, mixer, blender, toaster, coffee machine, router, keyboard, modem, centrifuge, "
            "hearing aid, headset, headphones, megaphone, periscope, compass, calculator, meter, gauge, "
            "hologram, tape recorder, accordion, typewriter ribbon, tape dispenser, shredder, battery, iron, "
            "drill",
            True,
        ),
        _class(
            "tool",
            "rod",
            (0.05, 0.05, 0.45),
            "iron",
            "tool, wrench, saw, drill, wand, rod, club, bat, racket, paddle, oar, ladle, brush, crowbar, whisk, "
            "cleaver, rolling pin, spatula, tongs, chisel, pliers, screwdriver, bayonet, sickle, scythe, poker, "
            "cue, golf club, hockey stick, fishing rod, pole, plank, branch, baton, arrow, crop, whip, "
            "toothbrush, paint brush, paintbrush, pointer, ruler, flute, recorder, clarinet, oboe, lever, "
            "boathook",
            True,
            prop="cane",
        ),
        _class(
            "vessel",
            "drum",
            (0.12, 0.12, 0.18),
            "porcelain",
            "vessel, jar, can, tin, container, urn, canister, thermos, flask, potion, pot, beaker, carafe, jug, "
            "pitcher, canteen, tankard, mixing bowl, salt shaker, pepper mill, inkwell, inkhorn, cauldron, "
            "stockpot, saucepan, colander, spittoon, crucible, test tube, petri dish, ice bucket, candle jar, "
            "tea caddy, shaker",
            True,
            prop="jug",
        ),
        _class(
            "sheet",
            "slab",
            (0.21, 0.3, 0.01),
            "paper",
            "sheet, certificate, poster, leaflet, blueprint, plan, chart, flag, banner, cloth, napkin, "
            "handkerchief, rag, tissue, menu, bill, check, receipt, x-ray, photostat, sticker, quilt, sail, "
            "canvas, palette, cutting board, tape, towel rail, placard, plank of wood, pillowcase, curtain",
            True,
            prop="letter",
        ),
        _class(
            "round_thing",
            "ball",
            (0.25, 0.25, 0.25),
            "leather",
            "sphere, orb, globe, egg, balloon, melon, pumpkin, snowball, planet, moon, bubble, nut, onion, "
            "potato, lemon, orange, tomato, cabbage, turnip, tangerine, coconut, watermelon, beach ball, drum, "
            "tambourine, gong, wheel, tyre, hoop, wreath, garland, cushion",
            True,
            prop="ball",
        ),
        _class(
            "food",
            "drum",
            (0.24, 0.24, 0.09),
            "cardboard",
            "food, pizza, sandwich, burger, cheese, ham, turkey, chicken, fish, salad, dessert, sushi, pudding, "
            "pasta, rice, sauce, meat, roast, steak, stew, porridge, toast, dough, bun, roll, broth, noodles, "
            "bacon, sausage, lobster, cabbage, lettuce, leek, candyfloss, ice cream, popcorn, crust",
            True,
            prop="plate",
        ),
        _class(
            "garment",
            "box",
            (0.4, 0.25, 0.12),
            "fabric",
            "garment, coat, jacket, dress, shirt, shoes, boots, gloves, scarf, uniform, cloak, costume, laundry, "
            "overcoat, raincoat, cardigan, robe, apron, cape, hood, sweater, vest, trousers, skirt, belt, tie, "
            "shawl, veil, hat box, saddle, saddlebag, holster, glove, boot, shoe, parka, parcel, bundle, "
            "bandage roll",
            True,
            prop="folded_clothes",
        ),
        _class(
            "furnishing",
            "box",
            (1.0, 0.55, 0.9),
            "wood",
            "furniture, unit, console, altar, pedestal, kiosk, cage, crib, hutch, manger, ottoman, futon, stand, "
            "rack, ironing board, treadmill, barbell, trough, water trough, trestle, podium, box, locker, "
            "playpen, platform bed, mattress, hammock, spinning wheel, loom, anvil, grindstone, bench press, "
            "hitching post, workstation, bathtub, barrel organ, pushcart, jury box, dollhouse",
            prop="cabinet",
        ),
        _class(
            "appliance",
            "box",
            (0.6, 0.6, 0.9),
            "enamel",
            "appliance, washing machine, dryer, dishwasher, heater, generator, printer, copier, robot, engine, "
            "water cooler, oven, freezer, jukebox, photocopier, vending machine, stove, mainframe, fish tank, "
            "aquarium, incubator, satellite dish, aerial, antenna",
            prop="fridge",
        ),
        _class(
            "machine",
            "box",
            (1.8, 1.2, 1.7),
            "paint",
            "machine, press, loom, lathe, turbine, reactor, forklift, printing press, time machine, portal",
            prop="reactor",
        ),
        _class(
            "pillar",
            "drum",
            (0.6, 0.6, 2.6),
            "concrete",
            "pillar, column, post, totem, obelisk, chimney, pipe, tank, silo, boiler, fountain, well, "
            "hitching post, flagpole, mast, pole, lamp post, streetlight, periscope mast",
            prop="standing_stone",
        ),
        _class(
            "monument",
            "cone",
            (1.2, 1.2, 2.6),
            "rock",
            "monument, dragon statue, tomb, gravestone, tombstone, shrine, idol, pyramid, tent, teepee, pile, heap",
            prop="statue",
        ),
        _class(
            "creature",
            "box",
            (0.7, 1.8, 1.2),
            "leather",
            "creature, beast, monster, dragon, lion, tiger, bear, cow, elephant, wolf, deer, camel, pig, goat, sheep",
            prop="dog",
        ),
        _class(
            "small_creature",
            "box",
            (0.18, 0.35, 0.2),
            "leather",
            "rat, mouse, rabbit, snake, frog, turtle, squirrel, spider, insect, monkey, hamster, lizard, chicken",
            prop="mouse",
        ),
        _class(
            "vehicle",
            "box",
            (1.9, 4.6, 1.7),
            "paint",
            "vehicle, tractor, tank, ambulance, limousine, jeep, carriage, wagon, sled, sleigh, chariot, buggy",
            prop="car",
        ),
        _class(
            "large_vehicle",
            "box",
            (2.6, 10.0, 3.2),
            "paint",
            "bus, train, tram, locomotive, lorry, coach, submarine, fire engine, carriage car, trailer, hovercraft",
            prop="bus",
        ),
        _class(
            "craft",
            "cone",
            (5.0, 8.0, 4.0),
            "steel",
            "spaceship, spacecraft, rocket, ufo, shuttle, helicopter, aircraft, airship, ship, yacht, satellite",
            prop="airliner",
        ),
        _class(
            "building",
            "box",
            (6.0, 5.0, 4.5),
            "plaster",
            "building, house, hut, cabin, shed, barn, church, tower, castle, lighthouse, windmill, temple, gate",
            prop="house",
        ),
        _class(
            "barrier",
            "slab",
            (2.4, 0.15, 1.1),
            "sheet_metal",
            "barrier, wall, fence, gate, railing, barricade, hedge, screen, net, goal, billboard",
            prop="fence_panel",
        ),
    ),
)
"""From small to large; the order decides between equals."""

DEFAULT = "small_thing"
"""The class of what nothing is known about."""


def head_words(name: str) -> tuple[str, ...]:
    """Return the words of a name from its head outwards: ``old time machine`` -> time machine, machine, time, old."""
    words = [word.strip(".,'\"").lower() for word in name.replace("_", " ").replace("-", " ").split()]
    words = words[: words.index("of")] if "of" in words[1:] else words
    pairs = [" ".join(words[-2:])] if len(words) > 1 else []
    return (*pairs, *reversed(words))


def guess_class(name: str, among: Iterable[StandIn] = ()) -> StandIn | None:
    """Return the class whose words name the head of ``name``, or None where no list knows it.

    Args:
        name: Of the thing.
        among: Only these classes; left out, all.
    """
    classes = tuple(among) or tuple(STAND_INS.values())
    for word in head_words(name):
        for form in (word, noun_key(word)):
            for entry in classes:
                if form in entry.tags:
                    return entry
    return None
