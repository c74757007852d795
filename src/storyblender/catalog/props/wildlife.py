"""Catalog entries of props: birds, small animals and exotic animals."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry
from storyblender.look.surface import Surface
from storyblender.memory.base import Vec3


def _bird(key: str, words: str, size: Vec3, color: str, wing: str = "", beak: str = "brass") -> PropEntry:
    """Return a bird; ``flying`` spreads its wings."""
    materials = {"coat": "fabric", "wing": wing or "fabric", "beak": beak}
    params = {"color": color, "flying": False}
    small = size[2] < 0.45
    return entry(
        "animal",
        key,
        words,
        size,
        materials,
        f"A {key.replace('_', ' ')}.",
        params=params,
        surface=Surface.HAIR,
        placement="surface" if small else "floor",
        holdable=small,
    )


def _beast(key: str, words: str, size: Vec3, color: str, role: str = "coat", **materials: str) -> PropEntry:
    """Return a four-legged animal with one coat colour; further material roles are keyword arguments."""
    params = {"color": color, **({"asleep": False} if key in _SLEEPERS else {})}
    return entry(
        "animal",
        key,
        words,
        size,
        {role: "fabric", **materials},
        f"A {key.replace('_', ' ')}.",
        params=params,
        surface=Surface.HAIR,
    )


_SLEEPERS = frozenset({"badger", "donkey", "zebra", "camel", "lamb", "otter", "raccoon"})

WILDLIFE: tuple[PropEntry, ...] = (
    _bird("hen", "chicken, chick, broody hen, pullet, partridge, grouse, quail, pheasant", (0.22, 0.47, 0.44),
        "#a8683a"),
    _bird("rooster", "cock, cockerel, weathercock", (0.24, 0.72, 0.66), "#8a3a1f"),
    _bird("duck", "drake, duckling, mallard, ducks", (0.2, 0.5, 0.33), "#6f6a4a"),
    _bird("goose", "gander, gosling, geese, wild goose", (0.3, 0.84, 0.72), "#e4e2da", beak="leaves_autumn"),
    _bird("swan", "cygnet, black swan", (0.4, 1.16, 0.98), "#f0efe9", beak="leaves_autumn"),
    _bird("owl", "barn owl, owlet, tawny owl, snowy owl", (0.22, 0.35, 0.46), "#8a6a45", "leather"),
    _bird("crow", "raven, rook, jackdaw, magpie, blackbird", (0.14, 0.55, 0.27), "#17171b", "plastic_black", "iron"),
    _bird("pigeon", "dove, white dove, carrier pigeon, turtle dove", (0.13, 0.38, 0.25), "#8a929c", beak="clay"),
    _bird("songbird",
        "sparrow, robin, finch, canary, budgie, budgerigar, wren, swallow, bluebird, little bird, small bird, "
        "nightingale, lark, chick", (0.09, 0.2, 0.17), "#b07a3c"),
    _bird("parrot", "macaw, cockatoo, parakeet, toucan, cockatiel", (0.13, 0.3, 0.5), "#2f8a3c", "fabric_red", "iron"),
    _bird("eagle", "hawk, falcon, vulture, buzzard, kite bird, condor, bald eagle, bird of prey", (0.3, 0.86, 0.72),
        "#5a4028", "leather"),
    _bird("seagull", "gull, tern, albatross, puffin, seabird", (0.17, 0.56, 0.34), "#eceae4", "fabric"),
    _bird("penguin", "emperor penguin, penguins", (0.36, 0.42, 0.86), "#22262c", "plastic_black"),
    _bird("turkey", "thanksgiving turkey, turkey cock", (0.5, 0.9, 0.82), "#4a3426", "leather"),
    _bird("peacock", "peahen, peafowl", (1.55, 0.7, 1.25), "#2c5288", "leaves"),
    _bird("flamingo", "stork, heron, crane bird, ibis", (0.24, 0.6, 1.34), "#d98a96", beak="clay"),
    _bird("ostrich", "emu, rhea", (0.68, 1.5, 2.4), "#2c2826", beak="clay"),
    _beast("badger", "brock, honey badger, wolverine, skunk", (0.32, 0.95, 0.42), "#6d6c6a"),
    _beast("hedgehog", "porcupine, urchin, hedgehogs", (0.19, 0.3, 0.2), "#a5845c"),
    _beast("rat", "rats, sewer rat, black rat, ferret, stoat", (0.07, 0.5, 0.1), "#6a625a"),
    _beast("donkey", "mule, ass, burro, jackass", (0.46, 1.7, 1.65), "#7d7a74"),
    _beast("zebra", "zebras", (0.5, 1.95, 1.85), "#eceae4"),
    _beast("giraffe", "giraffes", (0.7, 2.4, 4.35), "#d8b070"),
    _beast("camel", "dromedary, llama, alpaca, camels", (0.66, 2.25, 2.2), "#b8925c"),
    _beast("hippo", "hippopotamus", (1.2, 3.4, 1.55), "#7a6a6e"),
    _beast("rhino", "rhinoceros, triceratops", (1.1, 3.5, 1.7), "#85827c"),
    _beast("otter", "beaver, weasel, mink, marten, meerkat, mongoose, platypus", (0.22, 1.2, 0.34), "#5a4330"),
    _beast("raccoon", "racoon, coati", (0.24, 0.95, 0.48), "#8a8781"),
    _beast("red_panda", "lesser panda", (0.18, 1.1, 0.5), "#a3502a"),
    _beast("moose", "elk, reindeer bull", (2.0, 2.5, 2.5), "#5c432e"),
    _beast("panda", "giant panda, panda bear", (0.8, 2.1, 1.4), "#eceae4"),
    _beast("mole", "shrew, vole", (0.09, 0.2, 0.08), "#3a3533"),
    _beast("lamb", "kid goat, little lamb, kid", (0.26, 0.85, 0.75), "#ece8dd"),
    _beast("squirrel", "chipmunk, red squirrel, grey squirrel", (0.13, 0.3, 0.33), "#a3582a"),
    _beast("frog", "tree frog, bullfrog, tadpole, frog prince", (0.22, 0.2, 0.12), "#5f8a3a", "skin"),
    _beast("toad", "natterjack, cane toad", (0.22, 0.2, 0.12), "#7d6a45", "skin"),
    _beast("tortoise", "turtle, terrapin, sea turtle", (0.24, 0.43, 0.16), "#6d5a30", "shell", skin="clay"),
    _beast("monkey", "chimp, chimpanzee, ape, baboon, lemur, orangutan, monkeys, marmoset, sloth, koala",
        (0.36, 0.55, 0.6), "#6b4a30", face="clay"),
    _beast("gorilla", "king kong, yeti, bigfoot, sasquatch, great ape, monster, troll, ogre", (1.2, 0.8, 1.4),
        "#2a2826", face="rock"),
    _beast("kangaroo", "wallaby, kangaroos", (0.5, 1.55, 1.63), "#a07850"),
    _beast("crocodile", "alligator, croc, caiman, gator", (0.6, 3.7, 0.62), "#5a6a3c", "skin"),
    _beast("lizard", "gecko, iguana, chameleon, salamander, newt, komodo dragon", (0.08, 0.42, 0.07), "#6f8a3c",
        "skin"),
    _beast("bat_animal", "bat, bat in flight, vampire bat, fruit bat, bats", (0.55, 0.14, 0.14), "#3a3230",
        wing="leather_black"),
    _beast("bee",
        "wasp, hornet, bumblebee, fly, housefly, honeybee, insect, beetle, ladybird, ladybug, ant, grasshopper, "
        "cockroach, mosquito, firefly, dragonfly", (0.1, 0.08, 0.045), "#d8a520"),
    _beast("butterfly", "moth, butterflies", (0.12, 0.1, 0.065), "#d0601c", "wing"),
    _beast("spider", "tarantula, black widow, scorpion", (0.12, 0.07, 0.05), "#2a2826", "skin"),
    _beast("snail", "slug, snails", (0.03, 0.12, 0.065), "#b09a70", "skin", shell="leather"),
    _beast("shark", "great white, hammerhead, sharks", (1.7, 3.0, 1.15), "#6f7a84", "skin"),
    _beast("whale", "orca, killer whale, blue whale, sperm whale", (5.0, 12.2, 3.2), "#4a5a68", "skin"),
    _beast("dolphin", "porpoise, seal, sea lion, walrus, narwhal, manatee", (0.85, 2.3, 0.85), "#7d8a94", "skin"),
    _beast("octopus", "squid, jellyfish, kraken, cuttlefish", (1.1, 1.1, 0.65), "#a3503c", "skin"),
    _beast("crab", "lobster, hermit crab, crayfish, prawn", (0.34, 0.27, 0.11), "#b0442a", "skin"),
    _beast("dinosaur", "tyrannosaurus, t-rex, t rex, raptor, tyrannosaur, dinosaurs", (1.4, 6.0, 3.75), "#5a6a3c",
        "skin"),
)  # fmt: skip
"""Roughly by habitat."""
