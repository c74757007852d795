"""Anthropomorphic animals, robots and aliens: head, coat, tail and height of each species. Data only."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from storyblender.catalog.inflection import noun_key

Ear = Literal["none", "round", "point", "long", "flop", "side", "fan"]
Mouth = Literal["snout", "cone", "flat", "hook", "wide", "trunk"]
Tail = Literal["none", "stub", "thin", "even", "bushy", "plume", "rings", "tuft", "hair", "paddle", "fan", "thick"]
Build = Literal["slim", "average", "athletic", "stocky", "heavy"]


@dataclass(frozen=True, kw_only=True)
class Species:
    """Appearance of an animal that stands upright and acts like a person.

    Attributes:
        words: Names in scripts; the first is the key.
        coat: Colour of its fur or feathers, hex.
        height: Standing height of an adult, metres.
        head: Size factor of the head; small animals have large heads.
        ear: Shape of its ears.
        ears: Ear size relative to the head.
        mouth: Shape of the snout or beak.
        snout: Length and thickness of the mouth relative to the head.
        drop: Drop of the mouth's tip below its root, relative to the head.
        pale: Colour of its snout or beak, and of the inside of its ears.
        belly: Colour of its front; empty uses the snout colour on furred animals.
        limbs: Colour of its hands and feet.
        nose: Colour of its nose.
        iris: Colour of its eyes.
        tail: Shape of its tail.
        tip: Colour of the tip, rings or fan of its tail.
        build: Default build.
        marks: Keys of its coat markings and of growths such as horns or a mane.
        finish: What its surface looks like.
    """

    words: tuple[str, ...]
    coat: str
    height: float
    head: float = 1.0
    ear: Ear = "round"
    ears: float = 1.0
    mouth: Mouth = "snout"
    snout: tuple[float, float] = (0.6, 0.42)
    drop: float = 0.1
    pale: str = ""
    belly: str = ""
    limbs: str = ""
    nose: str = "#1c1716"
    iris: str = "#5c3a1a"
    tail: Tail = "stub"
    tip: str = ""
    build: Build = "average"
    marks: tuple[str, ...] = ()
    finish: Literal["hair", "metal", "rubber"] = "hair"


def _s(words: str, coat: str, height: float, **fields: object) -> Species:
    """Return a species; ``words`` are its names, separated by commas."""
    return Species(words=tuple(words.split(", ")), coat=coat, height=height, **fields)  # type: ignore[arg-type]


_CREAM, _BEAK, _SOOT = "#ece4d2", "#d98a1e", "#2a2625"

_CLAWED: tuple[Species, ...] = (
    _s("badger", "#6a6966", 1.05, ears=0.6, snout=(0.75, 0.36), pale="#efeae0", belly="#4c4a48", limbs=_SOOT,
       build="stocky", marks=("stripes",)),
    _s("skunk", "#232327", 0.8, head=1.1, ears=0.6, snout=(0.6, 0.3), pale="#232327", tail="plume", tip="#efeae0",
       marks=("blaze",)),
    _s("hedgehog, porcupine, echidna", "#c39a6c", 0.65, head=1.2, ears=0.7, snout=(0.75, 0.28), pale="#dcc09a",
       tail="none", build="heavy", marks=("spines",)),
    _s("fox, vixen, tod", "#c2611f", 1.1, ear="point", ears=1.15, snout=(0.85, 0.32), pale="#f1e8da", limbs=_SOOT,
       tail="bushy", tip="#f1e8da", iris="#a8741c", marks=("cheeks", "ruff")),
    _s("wolf, werewolf, coyote, jackal, hyena, dingo", "#74767a", 1.5, head=0.95, ear="point", snout=(0.95, 0.42),
       pale="#c9c6be", tail="bushy", iris="#b58a2a", build="athletic", marks=("cheeks", "ruff")),
    _s("dog, puppy, hound, terrier, spaniel, bulldog, poodle, collie, mutt, labrador, retriever, beagle, dachshund",
       "#9a6a3c", 1.15, ear="flop", snout=(0.65, 0.48), pale="#e0c69c", tail="even"),
    _s("cat, kitten, tomcat, lynx, bobcat", "#8f9195", 0.9, head=1.1, ear="point", snout=(0.24, 0.36), pale="#ece6da",
       tail="even", nose="#b5736c", iris="#8fa63a", marks=("bands", "whiskers")),
    _s("panther", "#26262a", 1.6, head=0.9, ears=0.8, snout=(0.42, 0.48), tail="even", iris="#b0a02c"),
    _s("lion, lioness", "#cf9c55", 1.7, head=0.95, ears=0.9, snout=(0.5, 0.5), pale="#ecdcb8", tail="tuft",
       tip="#6b3f1c", iris="#a8741c", build="athletic", marks=("mane", "whiskers")),
    _s("tiger, leopard, cheetah, jaguar", "#cf7a28", 1.7, head=0.95, ears=0.8, snout=(0.45, 0.52), pale="#f4ecdc",
       tail="rings", tip=_SOOT, iris="#a8a02c", build="athletic", marks=("bands", "cheeks", "whiskers")),
    _s("bear, grizzly, cub", "#63432a", 1.85, head=0.95, ears=0.9, snout=(0.55, 0.46), pale="#b38a5e", build="heavy"),
    _s("polar bear", "#ebe6d8", 1.85, head=0.95, ears=0.7, snout=(0.65, 0.46), pale="#f4f0e6", build="heavy"),
    _s("panda", "#efece4", 1.5, ears=1.0, snout=(0.4, 0.44), limbs="#1d1d20", build="heavy", marks=("patches",)),
    _s("koala", "#8f9296", 0.9, head=1.15, ears=1.7, snout=(0.28, 0.4), pale="#d9d6d0", tail="none", build="stocky",
       marks=("bignose",)),
    _s("sloth", "#8d7a5e", 0.9, head=1.1, ears=0.4, snout=(0.3, 0.4), pale="#d8c8a6", tail="none", marks=("mask",)),
    _s("rabbit, bunny, hare", "#a8937a", 0.85, head=1.15, ear="long", snout=(0.34, 0.38), pale="#ece2d2",
       nose="#b5736c", tip="#f4f0e8", marks=("whiskers", "teeth")),
    _s("mouse, dormouse, vole, shrew, gerbil, hamster, guinea pig", "#93897e", 0.55, head=1.3, ears=1.8,
       snout=(0.55, 0.28), pale="#d9b0a4", belly="#d8d0c4", tail="thin", tip="#c79a90", nose="#b5736c",
       marks=("whiskers",)),
    _s("rat", "#645d55", 0.75, head=1.15, ears=1.2, snout=(0.85, 0.3), pale="#c9a296", belly="#8d867c", tail="thin",
       tip="#c79a90", nose="#b5736c", marks=("whiskers", "teeth")),
    _s("squirrel, chipmunk", "#93562a", 0.6, head=1.25, ear="point", ears=0.5, snout=(0.3, 0.36), pale="#e6d2b0",
       tail="plume", marks=("whiskers", "teeth")),
    _s("mole", "#3b3634", 0.7, head=1.2, ear="none", snout=(0.8, 0.26), pale="#d8a098", belly="#4a4442",
       limbs="#d8a098", nose="#d8807c", tail="stub", build="stocky", marks=("tiny",)),
    _s("otter, weasel, stoat, ferret, meerkat, mink, marten, mongoose", "#6a4c32", 0.9, head=1.05, ears=0.5,
       snout=(0.36, 0.46), pale="#cbab84", tail="thick", build="slim", marks=("whiskers",)),
    _s("beaver, groundhog, woodchuck, marmot, capybara", "#6a4526", 0.9, head=1.1, ears=0.5, snout=(0.42, 0.48),
       pale="#9a7048", tail="paddle", tip="#3a332e", build="heavy", marks=("teeth",)),
    _s("raccoon, racoon", "#8d8a85", 0.9, head=1.1, ears=0.9, snout=(0.62, 0.3), pale="#efeae0", belly="#b0aca4",
       limbs=_SOOT, tail="rings", tip="#2c2a2a", marks=("mask", "ruff")),
    _s("monkey, chimp, chimpanzee, ape, gorilla, baboon, orangutan", "#5f432b", 1.2, ear="round", ears=1.1,
       snout=(0.32, 0.6), pale="#d3a67c", limbs="#c08f68", nose="#7a5238", tail="even", marks=("face", "lowears")),
    _s("armadillo, aardvark, anteater, pangolin, possum, opossum, tapir", "#8a7f74", 0.9, ear="long", ears=0.45,
       snout=(1.1, 0.28), pale="#c2b4a2", tail="thick"),
    _s("bat", "#3f3532", 0.6, head=1.2, ear="point", ears=1.6, snout=(0.3, 0.36), pale="#7a635a", tail="none",
       marks=("fangs",)),
    _s("kangaroo, wallaby", "#a87c50", 1.6, head=0.85, ear="long", ears=0.75, snout=(0.8, 0.36), pale="#dcc4a0",
       tail="thick"),
)  # fmt: skip
_HOOFED: tuple[Species, ...] = (
    _s("pig, piglet, hog, sow", "#dfa595", 1.2, ear="flop", ears=0.7, snout=(0.5, 0.44), pale="#e6b3a4", tail="thin",
       build="heavy", marks=("disc",)),
    _s("boar, warthog", "#57463a", 1.3, ears=0.8, snout=(0.8, 0.42), pale="#6b574a", tail="tuft", build="heavy",
       marks=("disc", "tusks")),
    _s("cow, calf", "#efeae0", 1.6, head=0.95, ear="side", snout=(0.7, 0.54), pale="#dba99a", limbs="#3a332e",
       tail="tuft", tip=_SOOT, build="stocky", marks=("blotches", "horns", "nostrils")),
    _s("bull, ox, buffalo, bison, yak", "#5a3a24", 1.75, ear="side", snout=(0.7, 0.54), pale="#8d6a50", limbs=_SOOT,
       tail="tuft", tip=_SOOT, build="heavy", marks=("horns", "nostrils")),
    _s("horse, pony, mare, stallion, foal", "#7d5230", 1.7, head=0.9, ear="point", ears=0.8, snout=(1.2, 0.46),
       drop=0.55, pale="#6a4428", limbs="#3a2a1e", tail="hair", tip="#241a14", marks=("blaze", "crest", "nostrils")),
    _s("unicorn", "#f2eef0", 1.7, head=0.9, ear="point", ears=0.8, snout=(1.15, 0.44), drop=0.5, pale="#e6d2d2",
       tail="hair", tip="#c79ab0", marks=("crest", "nostrils", "onehorn")),
    _s("zebra", "#f0ece4", 1.7, head=0.9, ears=0.9, snout=(1.15, 0.46), drop=0.5, pale="#3a3634", limbs=_SOOT,
       tail="tuft", tip=_SOOT, marks=("bands", "crest", "nostrils")),
    _s("donkey, mule, ass", "#84807a", 1.5, ear="long", ears=0.8, snout=(1.0, 0.46), drop=0.4, pale="#e9e2d4",
       tail="tuft", tip=_SOOT, marks=("crest", "nostrils")),
    _s("goat, billy goat, kid goat", "#d9d2c2", 1.2, ear="side", ears=0.9, snout=(0.85, 0.38), drop=0.3,
       limbs="#4a443c", tail="stub", marks=("horns", "beard")),
    _s("sheep, lamb, ewe", "#efeadf", 1.15, ear="side", ears=0.8, snout=(0.7, 0.4), drop=0.25, pale="#4a443e",
       limbs="#4a443e", build="stocky", marks=("face", "wool")),
    _s("ram", "#e4dccb", 1.25, ear="side", ears=0.8, snout=(0.7, 0.42), drop=0.25, pale="#4a443e", limbs="#4a443e",
       build="stocky", marks=("face", "wool", "curls")),
    _s("deer, doe, fawn, gazelle, antelope", "#9c6a3c", 1.5, head=0.9, ear="side", ears=1.15, snout=(0.85, 0.34),
       drop=0.25, pale="#ecd9b8", tail="stub", tip="#f4f0e8", build="slim"),
    _s("stag, buck, hart, roebuck", "#8a5a34", 1.6, head=0.9, ear="side", ears=1.0, snout=(0.9, 0.36), drop=0.25,
       pale="#d9c49c", tail="stub", marks=("antlers",)),
    _s("reindeer, caribou", "#7a6450", 1.6, head=0.9, ear="side", snout=(0.9, 0.44), drop=0.25, pale="#e4dccb",
       marks=("antlers", "beard")),
    _s("moose, elk", "#5f432c", 1.85, head=0.95, ear="side", snout=(1.15, 0.52), drop=0.35, pale="#7d5f44",
       limbs="#9a8a74", build="heavy", marks=("palms", "nostrils")),
    _s("elephant, mammoth", "#878a90", 2.0, ear="fan", ears=1.0, mouth="trunk", snout=(1.0, 0.3), tail="tuft",
       build="heavy", marks=("ivory",)),
    _s("rhino, rhinoceros", "#7d7d7a", 1.8, ears=0.6, snout=(1.0, 0.56), drop=0.25, tail="tuft", build="heavy",
       marks=("nosehorn",)),
    _s("hippo, hippopotamus", "#7d6f78", 1.7, ears=0.5, snout=(0.95, 0.72), drop=0.3, pale="#a88a90", build="heavy",
       marks=("nostrils", "goggles")),
    _s("giraffe", "#d8a850", 2.2, head=0.8, ear="side", ears=0.8, snout=(1.0, 0.4), drop=0.3, pale="#ecd9b0",
       tail="tuft", tip=_SOOT, build="slim", marks=("blotches", "knobs")),
    _s("camel, llama, alpaca", "#c39a62", 1.7, head=0.85, ears=0.7, snout=(0.9, 0.42), drop=0.25, pale="#d9bb8a",
       tail="tuft", marks=("nostrils",)),
)  # fmt: skip
_OTHERS: tuple[Species, ...] = (
    _s("frog, toad, bullfrog", "#5f9a38", 0.6, head=1.25, ear="none", mouth="wide", snout=(0.3, 0.9), pale="#c9d89a",
        tail="none", iris="#c9a22a", marks=("goggles",)),
    _s("tortoise, turtle, terrapin", "#75854a", 0.85, ear="none", mouth="wide", snout=(0.3, 0.75), pale="#a8ad70",
        belly="#c9b878", build="stocky"),
    _s("snake, lizard, gecko, chameleon, newt, iguana", "#6f9a3c", 0.8, ear="none", mouth="wide", snout=(0.5, 0.8),
        pale="#cfd89a", tail="thick", iris="#c9a22a", build="slim", marks=("goggles",)),
    _s("crocodile, alligator", "#5d7038", 1.6, head=0.9, ear="none", snout=(1.5, 0.46), drop=0.1, pale="#c2c48a",
        tail="thick", iris="#c9a22a", nose="#3f4c28", marks=("goggles", "fangs")),
    _s("dragon, dinosaur", "#4f8a5c", 1.9, ear="none", snout=(1.0, 0.5), drop=0.1, pale="#d8cf94", tail="thick",
        iris="#c98a2a", nose="#34583c", marks=("goggles", "horns", "fangs")),
    _s("fish, shark, whale, dolphin, seal, walrus, sea lion", "#64798c", 1.2, ear="none", snout=(0.35, 0.55),
        pale="#d8dcd8", tail="thick", build="heavy", marks=("whiskers",)),
    _s("owl", "#8d6c46", 0.75, head=1.25, ear="point", ears=0.55, mouth="hook", snout=(0.26, 0.17), pale="#c99a34",
        belly="#d8c29a", limbs="#c99a34", tail="fan", iris="#e0a018", build="heavy", marks=("discs",)),
    _s("crow, raven, rook, jackdaw, blackbird, starling", "#1f2026", 0.75, head=1.1, ear="none", mouth="cone",
        snout=(1.05, 0.32), pale="#4a4c52", belly="#26272d", limbs="#3a3c40", tail="fan"),
    _s("magpie", "#1f2026", 0.75, head=1.1, ear="none", mouth="cone", snout=(0.8, 0.25), pale="#2f3136",
        belly="#f0ece4", limbs="#3a3c40", tail="fan"),
    _s("hen, chicken, chick", "#b87a40", 0.7, head=1.05, ear="none", mouth="cone", snout=(0.5, 0.24), pale="#dda23a",
        belly="#dcb884", limbs="#dda23a", tail="fan", iris="#c9761c", build="heavy", marks=("comb",)),
    _s("rooster, cock, cockerel, turkey", "#9a4a1e", 0.85, ear="none", mouth="cone", snout=(0.5, 0.24), pale="#dda23a",
        belly="#3a2a24", limbs="#dda23a", tail="fan", tip="#1f3a34", iris="#c9761c", marks=("comb",)),
    _s("duck, duckling, mallard, pelican", "#e6dfc4", 0.7, head=1.1, ear="none", mouth="flat", snout=(0.8, 0.42),
        pale=_BEAK, belly="#f0ebd8", limbs=_BEAK, tail="stub", build="stocky"),
    _s("goose, gander, swan", "#f2efe6", 0.95, head=0.95, ear="none", mouth="flat", snout=(0.7, 0.36), pale=_BEAK,
        belly="#f7f5ee", limbs=_BEAK, tail="stub", build="stocky"),
    _s("heron, stork, crane, flamingo, ibis, ostrich, emu", "#9aa6b0", 1.5, head=0.75, ear="none", mouth="cone",
        snout=(1.6, 0.22), pale="#d0a040", belly="#dfe2e2", limbs="#b08a50", tail="fan", build="slim"),
    _s("penguin, puffin", "#24282f", 0.8, head=1.05, ear="none", mouth="cone", snout=(0.65, 0.22), pale=_BEAK,
        belly="#f4f2ec", limbs=_BEAK, tail="stub", build="heavy", marks=("face",)),
    _s("eagle, hawk, falcon, vulture, kite, buzzard", "#5f432a", 1.0, ear="none", mouth="hook", snout=(0.6, 0.28),
        pale="#dda82a", limbs="#dda82a", tail="fan", iris="#e0b028", build="athletic", marks=("hood",)),
    _s("parrot, macaw, cockatoo, parakeet, budgie, budgerigar", "#2f8a3c", 0.7, head=1.1, ear="none", mouth="hook",
        snout=(0.45, 0.32), pale="#3a3632", belly="#c9b02a", limbs="#6a6a6a", tail="fan", tip="#b02a2a"),
    _s("robin", "#7a6248", 0.55, head=1.25, ear="none", mouth="cone", snout=(0.42, 0.18), pale="#4a3f36",
        belly="#c2501e", limbs="#6a4a36", tail="fan", build="heavy"),
    _s("bird, sparrow, pigeon, dove, seagull, gull, wren, finch, thrush, swallow, lark, nightingale, cuckoo", "#8a98a8",
        0.65, head=1.15, ear="none", mouth="cone", snout=(0.5, 0.22), pale="#dda23a", belly="#dfe2e2", limbs="#c08a50",
        tail="fan"),
)  # fmt: skip

_BEINGS: tuple[Species, ...] = (
    _s("robot, droid, automaton", "#8f979e", 1.75, head=1.05, ear="none", mouth="wide",
       snout=(0.16, 0.6), pale="#6f777e", belly="#a7aeb4", limbs="#565d64", nose="#565d64", iris="#7fdcff", tail="none",
       build="stocky", marks=("antenna", "bolts"), finish="metal"),
    _s("alien, martian, extraterrestrial", "#86a878", 1.5, head=1.3, ear="none", mouth="wide", snout=(0.12, 0.4),
       pale="#9dbb8e", belly="#97b589", limbs="#6f9163", nose="#6f9163", iris="#15181a", tail="none", build="slim",
       finish="rubber"),
)  # fmt: skip
SPECIES: dict[str, Species] = {each.words[0]: each for each in (*_CLAWED, *_HOOFED, *_OTHERS, *_BEINGS)}
"""Species by name."""
_BY_WORD: dict[str, Species] = {word: each for each in SPECIES.values() for word in each.words}


def being_of(words: str) -> Species | None:
    """Return the robot or alien that a phrase names, or None."""
    said = {noun_key(word) for word in re.findall(r"[a-z]+", words.lower())}
    return next((each for each in _BEINGS if said & {*each.words}), None)


def species_of(words: str) -> Species | None:
    """Return the animal species that a phrase names, or None; its last known word, or pair of words, decides."""
    said = re.findall(r"[a-z]+", words.lower())
    for end in range(len(said), 0, -1):
        for known in (" ".join(said[max(0, end - 2) : end]), said[end - 1], noun_key(said[end - 1])):
            if known in _BY_WORD:
                return _BY_WORD[known]
    return None
