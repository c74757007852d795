"""Animals that act like people: the head, the coat and the height of each. Data only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Ear = Literal["none", "round", "point", "long", "flop", "side"]
Mouth = Literal["snout", "cone", "flat", "hook", "wide", "trunk"]


@dataclass(frozen=True, kw_only=True)
class Species:
    """How an animal looks that stands upright in clothes.

    Attributes:
        words: What the script may call it; the first is its name.
        coat: Colour of its fur or feathers, hex.
        height: Metres that a grown one stands.
        ear: Shape of its ears.
        ears: Size of an ear for the head.
        mouth: What its mouth is like.
        snout: Length and thickness of the mouth for the head.
        pale: Colour of its snout or beak.
        marks: What else it is known by.
    """

    words: tuple[str, ...]
    coat: str
    height: float
    ear: Ear = "round"
    ears: float = 1.0
    mouth: Mouth = "snout"
    snout: tuple[float, float] = (0.6, 0.42)
    pale: str = ""
    marks: tuple[str, ...] = ()


def _species(words: str, coat: str, height: float, **fields: object) -> Species:
    return Species(words=tuple(words.split(", ")), coat=coat, height=height, **fields)  # type: ignore[arg-type]


SPECIES: dict[str, Species] = {
    each.words[0]: each
    for each in (
        _species("badger", "#6d6c6a", 1.15, ears=0.7, snout=(0.8, 0.36), pale="#ece8dd", marks=("stripes",)),
        _species("hedgehog, porcupine", "#b8956a", 0.8, ears=0.6, snout=(0.75, 0.28), marks=("spines",)),
        _species("fox, vixen", "#b0602c", 1.2, ear="point", ears=1.2, snout=(0.85, 0.3), pale="#ece8dd",
            marks=("cheeks",)),
        _species("wolf, werewolf, coyote, jackal", "#77787a", 1.6, ear="point", snout=(0.95, 0.4), pale="#a9a7a2"),
        _species("dog, puppy, hound, terrier, spaniel, bulldog, poodle", "#8a5f3c", 1.2, ear="flop", snout=(0.65,
            0.46),
                 pale="#c9b08a"),
        _species("cat, kitten, tomcat, panther, lynx", "#8d8f92", 1.05, ear="point", snout=(0.22, 0.34),
            pale="#e4e0d6",
                 marks=("whiskers",)),
        _species("lion", "#c79a5a", 1.75, ears=0.9, snout=(0.5, 0.5), pale="#e2d0ac", marks=("mane",)),
        _species("tiger, leopard", "#c07a35", 1.7, ears=0.9, snout=(0.45, 0.5), pale="#ece4d4", marks=("bands",)),
        _species("bear, polar bear, grizzly", "#5c4028", 1.9, snout=(0.55, 0.44), pale="#9a7650"),
        _species("panda", "#eceae4", 1.6, snout=(0.4, 0.42), marks=("patches",)),
        _species("koala, sloth", "#8d8f92", 0.95, ears=1.5, snout=(0.3, 0.4)),
        _species("rabbit, bunny, hare", "#a89a88", 0.95, ear="long", snout=(0.3, 0.36), pale="#e4e0d6",
            marks=("whiskers",)),
        _species("mouse, dormouse, vole, shrew", "#8d867e", 0.7, ears=1.7, snout=(0.6, 0.26), marks=("whiskers",)),
        _species("rat", "#5f5a54", 0.85, ears=1.2, snout=(0.85, 0.28), marks=("whiskers",)),
        _species("squirrel, chipmunk", "#a3582a", 0.85, ear="point", ears=0.9, snout=(0.4, 0.32), pale="#e4d6c0"),
        _species("mole", "#3a3533", 0.85, ear="none", snout=(0.8, 0.24), pale="#c99a94"),
        _species("otter, beaver, weasel, stoat, ferret, meerkat", "#5a4330", 0.95, ears=0.6, snout=(0.4, 0.44),
            pale="#a5876a",
                 marks=("whiskers",)),
        _species("raccoon", "#8a8781", 0.95, ear="point", ears=0.8, snout=(0.6, 0.3), pale="#e4e0d6", marks=("mask",)),
        _species("pig, piglet, hog, boar, sow", "#d39c88", 1.3, ear="flop", ears=0.8, snout=(0.5, 0.42),
            marks=("disc",)),
        _species("cow, bull, ox, buffalo", "#6b4a30", 1.7, ear="side", snout=(0.7, 0.5), pale="#d8c4b0",
            marks=("horns",)),
        _species("horse, pony, unicorn, zebra", "#7a5236", 1.75, ear="point", ears=0.9, snout=(1.15, 0.46),
            marks=("crest",)),
        _species("donkey, mule", "#7d7a74", 1.5, ear="long", snout=(1.0, 0.46), pale="#ddd8cc"),
        _species("goat", "#d8d2c4", 1.3, ear="side", snout=(0.8, 0.36), marks=("horns", "beard")),
        _species("sheep, lamb, ram", "#ece8dd", 1.2, ear="side", snout=(0.7, 0.38), pale="#4a443e", marks=("wool",)),
        _species("deer, stag, doe, fawn", "#8a5f3c", 1.6, ear="side", snout=(0.85, 0.32), pale="#c9b08a",
            marks=("antlers",)),
        _species("moose, elk, reindeer", "#5c432e", 1.85, ear="side", snout=(1.1, 0.5), marks=("antlers",)),
        _species("elephant, mammoth", "#85888c", 1.9, ear="side", ears=2.4, mouth="trunk", snout=(1.0, 0.3)),
        _species("monkey, chimp, chimpanzee, ape, gorilla", "#5c4028", 1.3, ear="side", ears=0.8, snout=(0.3, 0.6),
            pale="#c79a74"),
        _species("kangaroo", "#a07850", 1.6, ear="long", ears=0.8, snout=(0.8, 0.34)),
        _species("frog, toad", "#5f8a3a", 0.8, ear="none", mouth="wide", snout=(0.3, 0.9), marks=("goggles",)),
        _species("tortoise, turtle", "#6f7d45", 0.9, ear="none", mouth="wide", snout=(0.35, 0.5)),
        _species("crocodile, alligator, dinosaur, dragon, lizard", "#5a6a3c", 1.7, ear="none", snout=(1.3, 0.46),
            marks=("goggles",)),
        _species("owl", "#8a6a45", 1.0, ear="point", ears=0.6, mouth="hook", snout=(0.3, 0.16), pale="#c9a344",
            marks=("discs",)),
        _species("crow, raven, magpie, rook, blackbird", "#1d1d22", 0.85, ear="none", mouth="cone", snout=(0.9, 0.26),
                 pale="#3a3c40"),
        _species("hen, chicken, rooster, cock, turkey", "#b07a45", 0.9, ear="none", mouth="cone", snout=(0.5, 0.24),
            pale="#d8a03a",
                 marks=("comb",)),
        _species("duck, duckling, goose, swan, pelican", "#e4e0cc", 0.9, ear="none", mouth="flat", snout=(0.75, 0.4),
            pale="#d8902a"),
        _species("penguin", "#22262c", 0.95, ear="none", mouth="cone", snout=(0.7, 0.2), pale="#d8902a"),
        _species("bird, robin, sparrow, pigeon, parrot, seagull, eagle", "#7f93a8", 0.75, ear="none", mouth="cone",
            snout=(0.5, 0.22),
                 pale="#d8a03a"),
    )
}  # fmt: skip
"""By name."""


def species_of(words: str) -> Species | None:
    """Return the species that a phrase names; its last known word decides."""
    known = {word: each for each in SPECIES.values() for word in each.words}
    found = [known[word] for word in words.lower().replace("-", " ").split() if word in known]
    return found[-1] if found else None
