"""From casting words to a body: statures, macro morphs, face details, colours. Pure data and arithmetic."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from storyblender.catalog.materials import hex_color
from storyblender.memory.asset_sheet import CharacterLook
from storyblender.memory.base import Color

BODY_PACK_VERSION = 1

Targets = dict[str, float]
"""Weights of morph targets by name."""

STATURES: dict[str, tuple[tuple[float, ...], tuple[float, ...]]] = {
    "male": (
        (1, 2, 4, 6, 8, 10, 12, 14, 16, 18, 25, 60, 80, 95),
        (0.76, 0.87, 1.03, 1.16, 1.28, 1.39, 1.50, 1.64, 1.73, 1.77, 1.79, 1.76, 1.71, 1.67),
    ),
    "female": (
        (1, 2, 4, 6, 8, 10, 12, 14, 16, 18, 25, 60, 80, 95),
        (0.74, 0.86, 1.02, 1.15, 1.28, 1.38, 1.51, 1.60, 1.63, 1.65, 1.66, 1.63, 1.57, 1.53),
    ),
}
"""Typical stature in metres over age in years."""

BUILDS: dict[str, tuple[float, float, Targets]] = {
    "slim": (0.42, 0.34, {"torso/measure-waist-circ-decr": 0.15}),
    "average": (0.55, 0.55, {}),
    "athletic": (0.78, 0.50, {"torso/torso-vshape-incr": 0.30}),
    "stocky": (0.66, 0.82, {"torso/torso-scale-horiz-incr": 0.25, "stomach/stomach-pregnant-incr": 0.20,
                            "neck/neck-scale-horiz-incr": 0.2, "head/head-fat-incr": 0.25}),
    "heavy": (0.60, 1.0, {"stomach/stomach-pregnant-incr": 0.55, "torso/measure-waist-circ-incr": 0.5,
                          "torso/measure-hips-circ-incr": 0.3, "head/head-fat-incr": 0.5,
                          "torso/torso-scale-depth-incr": 0.4, "torso/torso-scale-horiz-incr": 0.3,
                          "neck/neck-double-incr": 0.4}),
}  # fmt: skip
"""Muscle, weight and extra targets of each build (weight alone tops out: notes on humans, section 2)."""

SKIN_TONES: dict[str, Color] = {
    "pale": hex_color("#efc6ad"), "light": hex_color("#e3b295"), "tan": hex_color("#c68d68"),
    "brown": hex_color("#8a5636"), "dark": hex_color("#583421"),
}  # fmt: skip

ANCESTRY: dict[str, tuple[tuple[float, float, float], ...]] = {
    "pale": ((0.0, 0.0, 1.0), (0.0, 0.3, 0.7)),
    "light": ((0.0, 0.0, 1.0), (0.0, 0.1, 0.9), (0.0, 0.25, 0.75), (0.05, 0.0, 0.95)),
    "tan": ((0.15, 0.15, 0.7), (0.05, 0.4, 0.55), (0.3, 0.1, 0.6)),
    "brown": ((0.6, 0.05, 0.35), (0.35, 0.3, 0.35), (0.7, 0.1, 0.2)),
    "dark": ((0.9, 0.0, 0.1), (0.8, 0.1, 0.1), (1.0, 0.0, 0.0)),
}
"""Plausible mixes of the morphs african, asian, caucasian for each skin tone; the seed picks one."""

HAIR_TONES: dict[str, tuple[Color, ...]] = {
    "pale": (hex_color("#8a4a22"), hex_color("#a98a5e"), hex_color("#4a2a17"), hex_color("#2b1a10")),
    "light": (hex_color("#3a2214"), hex_color("#5c3a20"), hex_color("#94774f"), hex_color("#24160d")),
    "tan": (hex_color("#1c120c"), hex_color("#2b1a10"), hex_color("#120d0b")),
    "brown": (hex_color("#120d0b"), hex_color("#1c120c")),
    "dark": (hex_color("#0d0a09"), hex_color("#120d0b")),
}
IRIS_TONES: dict[str, tuple[Color, ...]] = {
    "pale": (hex_color("#5b86a3"), hex_color("#6d8a5e"), hex_color("#5b3d22")),
    "light": (hex_color("#5f8299"), hex_color("#6b7a4c"), hex_color("#5b3d22"), hex_color("#43301f")),
    "tan": (hex_color("#43301f"), hex_color("#54381e")),
    "brown": (hex_color("#33200f"), hex_color("#43301f")),
    "dark": (hex_color("#2a1a0e"),),
}
GREY_HAIR = hex_color("#b9b8b6")
WHITE_HAIR = hex_color("#dddcd8")

HEAD_SHAPES = ("oval", "round", "rectangular", "square", "triangular", "invertedtriangular", "diamond")

FACE_AXES: tuple[tuple[str, str, float], ...] = (
    ("nose/nose-scale-horiz-decr", "nose/nose-scale-horiz-incr", 0.30),
    ("nose/nose-scale-vert-decr", "nose/nose-scale-vert-incr", 0.30),
    ("nose/nose-scale-depth-decr", "nose/nose-scale-depth-incr", 0.30),
    ("nose/nose-hump-decr", "nose/nose-hump-incr", 0.40),
    ("nose/nose-point-down", "nose/nose-point-up", 0.35),
    ("nose/nose-volume-decr", "nose/nose-volume-incr", 0.30),
    ("nose/nose-width1-decr", "nose/nose-width1-incr", 0.25),
    ("chin/chin-width-decr", "chin/chin-width-incr", 0.40),
    ("chin/chin-height-decr", "chin/chin-height-incr", 0.30),
    ("chin/chin-prominent-decr", "chin/chin-prominent-incr", 0.30),
    ("chin/chin-bones-decr", "chin/chin-bones-incr", 0.35),
    ("cheek/?-cheek-bones-decr", "cheek/?-cheek-bones-incr", 0.40),
    ("cheek/?-cheek-volume-decr", "cheek/?-cheek-volume-incr", 0.35),
    ("cheek/?-cheek-inner-decr", "cheek/?-cheek-inner-incr", 0.25),
    ("eyes/?-eye-scale-decr", "eyes/?-eye-scale-incr", 0.25),
    ("eyes/?-eye-height2-decr", "eyes/?-eye-height2-incr", 0.30),
    ("eyes/?-eye-corner2-down", "eyes/?-eye-corner2-up", 0.30),
    ("eyes/?-eye-trans-in", "eyes/?-eye-trans-out", 0.25),
    ("eyebrows/eyebrows-trans-down", "eyebrows/eyebrows-trans-up", 0.30),
    ("eyebrows/eyebrows-angle-down", "eyebrows/eyebrows-angle-up", 0.30),
    ("mouth/mouth-scale-horiz-decr", "mouth/mouth-scale-horiz-incr", 0.30),
    ("mouth/mouth-lowerlip-volume-decr", "mouth/mouth-lowerlip-volume-incr", 0.30),
    ("mouth/mouth-upperlip-volume-decr", "mouth/mouth-upperlip-volume-incr", 0.30),
    ("mouth/mouth-trans-down", "mouth/mouth-trans-up", 0.25),
    ("forehead/forehead-scale-vert-decr", "forehead/forehead-scale-vert-incr", 0.30),
    ("forehead/forehead-temple-decr", "forehead/forehead-temple-incr", 0.30),
    ("head/head-scale-horiz-decr", "head/head-scale-horiz-incr", 0.20),
    ("ears/?-ear-wing-decr", "ears/?-ear-wing-incr", 0.25),
)
"""Pairs of opposite targets and their spread; ``?`` stands for both sides. One seeded draw each makes a face."""


def mix(first: Color, second: Color, share: float) -> Color:
    """Return a mixture of two scene-linear colours.

    Args:
        first: Colour at share 0.
        second: Colour at share 1.
        share: Part of the second colour, 0 to 1.
    """
    red, green, blue = (a + (b - a) * share for a, b in zip(first, second, strict=True))
    return red, green, blue


@dataclass(frozen=True)
class BodyRecipe:
    """All that the morphs need to make one body.

    Attributes:
        maturity: MakeHuman age, 0 = 1 year, .1875 = 10, .5 = 25, 1 = 90.
        masculinity: 0 female, 1 male.
        muscle: 0 to 1.
        weight: 0 to 1.
        proportions: 0.5 average, 1 ideal.
        ancestry: Shares of african, asian, caucasian.
        details: Weights of detail targets.
        stature: Wanted height in metres.
    """

    maturity: float
    masculinity: float
    muscle: float
    weight: float
    proportions: float
    ancestry: tuple[float, float, float]
    details: Targets
    stature: float


@dataclass(frozen=True)
class Complexion:
    """The colours of a person, scene-linear."""

    skin: Color
    lips: Color
    iris: Color
    hair: Color
    brow: Color


def body_pack_path(environment: Mapping[str, str], home: Path) -> Path:
    """Return where the body pack is, or will be, for a user.

    Args:
        environment: ``os.environ``; STORYBLENDER_BODY_DATA may name a pack, XDG_CACHE_HOME the cache.
        home: The user's home folder.
    """
    override = environment.get("STORYBLENDER_BODY_DATA", "")
    if override and not override.endswith(".whl"):
        return Path(override)
    cache = Path(environment.get("XDG_CACHE_HOME") or home / ".cache")
    return cache / "storyblender" / f"bodies-{BODY_PACK_VERSION}.npz.xz"


def resolved_gender(look: CharacterLook, seed: int) -> str:
    """Return ``female`` or ``male`` for a person.

    Args:
        look: Of the person.
        seed: Decides where the look leaves the gender unknown.
    """
    return look.gender if look.gender != "unknown" else ("female", "male")[seed % 2]


def typical_stature(gender: str, age: float) -> float:
    """Return a typical body height in metres.

    Args:
        gender: ``female`` or ``male``.
        age: Years.
    """
    years, heights = STATURES[gender]
    return float(np.interp(age, years, heights))


def maturity(age: float) -> float:
    """Return the MakeHuman age value of ``age`` years."""
    return float(np.interp(age, (1, 10, 25, 90), (0, 0.1875, 0.5, 1)))


def recipe(look: CharacterLook, seed: int) -> BodyRecipe:
    """Return the body that fits a look; equal arguments give equal bodies, other seeds other people.

    Args:
        look: Gender, age, build and skin.
        seed: Source of variation.
    """
    rng = np.random.default_rng([seed, look.face] if look.face else seed)
    gender = resolved_gender(look, seed)
    muscle, weight, extras = BUILDS[look.build]
    details = dict(extras)
    mixes = ANCESTRY[look.skin]
    ancestry = mixes[int(rng.integers(len(mixes)))]
    stature = typical_stature(gender, look.age) * (1 + 0.03 * float(np.clip(rng.standard_normal(), -1.8, 1.8)))
    for target, amount in (*_face(rng, gender, look.age).items(), *_ageing(look.age).items()):
        details[target] = details.get(target, 0.0) + amount
    return BodyRecipe(
        maturity=maturity(look.age),
        masculinity=float(gender == "male"),
        muscle=muscle - (0.1 if gender == "female" else 0.0) - 0.15 * float(np.interp(look.age, (55, 85), (0, 1))),
        weight=weight,
        proportions=0.75 if look.build in ("slim", "athletic") else 0.6,
        ancestry=ancestry,
        details=details,
        stature=look.stature or stature,
    )


def _face(rng: np.random.Generator, gender: str, age: float) -> Targets:
    """Draw a face: one value on each axis and a share of one head shape, gentler on children."""
    strength = float(np.interp(age, (3, 16), (0.45, 1.0))) * (0.85 if gender == "female" else 1.0)
    face: Targets = {f"head/head-{HEAD_SHAPES[int(rng.integers(len(HEAD_SHAPES)))]}": strength * rng.uniform(0.1, 0.5)}
    for low, high, spread in FACE_AXES:
        amount = strength * spread * float(np.clip(rng.standard_normal(), -2, 2))
        target = high if amount > 0 else low
        for name in (target.replace("?", "l"), target.replace("?", "r")) if "?" in target else (target,):
            face[name] = abs(amount)
    return face


def _ageing(age: float) -> Targets:
    """Return what the macro morphs leave out of an old face."""
    old = float(np.interp(age, (40, 80), (0, 1)))
    if not old:
        return {}
    return {
        "head/head-age-incr": 0.8 * old,
        "mouth/mouth-laugh-lines-in": 0.5 * old,
        "eyes/l-eye-bag-incr": 0.5 * old,
        "eyes/r-eye-bag-incr": 0.5 * old,
        "neck/neck-double-incr": 0.25 * old,
    }


def macro_targets(body: BodyRecipe, height: float) -> Targets:
    """Return the macro targets of ``body``: the weight of a file is the product of the words in its name.

    Args:
        body: Who.
        height: MakeHuman height, 0 to 1 (0.5 = typical); the stature is piecewise linear in it.
    """
    ages = _ages(body.maturity)
    genders = {"female": 1 - body.masculinity, "male": body.masculinity}
    ancestry = dict(zip(("african", "asian", "caucasian"), body.ancestry, strict=True))
    shape = {
        f"{muscle}muscle-{weight}weight": share * other
        for muscle, share in _thirds(body.muscle).items()
        for weight, other in _thirds(body.weight).items()
    }
    statures = {"minheight": max(0.0, 1 - 2 * height), "maxheight": max(0.0, 2 * height - 1)}
    ideal = max(0.0, 2 * body.proportions - 1)
    targets: Targets = {}
    for gender, of_gender in genders.items():
        for age, of_age in ages.items():
            share = of_gender * of_age
            targets |= {f"macrodetails/{race}-{gender}-{age}": share * part for race, part in ancestry.items()}
            for kind, part in shape.items():
                stem, amount = f"{gender}-{age}-{kind}", share * part
                targets[f"macrodetails/universal-{stem}"] = amount
                targets |= {f"macrodetails/height/{stem}-{word}": amount * at for word, at in statures.items()}
                if age != "baby":
                    targets[f"macrodetails/proportions/{stem}-idealproportions"] = amount * ideal
    return {name: amount for name, amount in targets.items() if amount > 1e-4}


def _ages(value: float) -> Targets:
    """Return the weights of the age words (baby, child, young, old) for a MakeHuman age of 0 to 1."""
    if value < 0.1875:
        return {"baby": 1 - value / 0.1875, "child": value / 0.1875}
    if value < 0.5:
        return {"child": 1 - (value - 0.1875) / 0.3125, "young": (value - 0.1875) / 0.3125}
    return {"young": 1 - (value - 0.5) / 0.5, "old": (value - 0.5) / 0.5}


def _thirds(value: float) -> Targets:
    """Return the weights of min, average and max for a MakeHuman value of 0 to 1."""
    low, high = max(0.0, 1 - 2 * value), max(0.0, 2 * value - 1)
    return {"min": low, "average": 1 - low - high, "max": high}


def _brightness(color: Color) -> float:
    """Return the luminance of a scene-linear colour (Rec. 709)."""
    red, green, blue = color
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def complexion(look: CharacterLook, seed: int) -> Complexion:
    """Return the colours of a person's skin, hair and eyes; hair greys with age unless its colour is given.

    Args:
        look: Of the person.
        seed: Source of variation.
    """
    rng = np.random.default_rng(seed + 1)
    skin = mix(SKIN_TONES[look.skin], (0.0, 0.0, 0.0), float(rng.uniform(0, 0.12)))
    natural = HAIR_TONES[look.skin][int(rng.integers(len(HAIR_TONES[look.skin])))]
    iris = IRIS_TONES[look.skin][int(rng.integers(len(IRIS_TONES[look.skin])))]
    grey = float(np.interp(look.age + rng.uniform(-6, 6), (45, 70), (0, 1)))
    silver = mix(GREY_HAIR, WHITE_HAIR, float(np.interp(look.age, (65, 90), (0, 1))))
    hair = look.hair_color or mix(natural, silver, grey)
    rosy = (
        hex_color("#b3404a")
        if resolved_gender(look, seed) == "female" and 16 <= look.age < 65
        else hex_color("#b0655c")
    )
    depth = min(1.0, _brightness(skin) / _brightness(SKIN_TONES["light"])) ** 0.4  # the same red shines on dark skin
    lips = mix(mix(skin, mix((0.0, 0.0, 0.0), rosy, depth), 0.55), (0.0, 0.0, 0.0), 0.12)
    return Complexion(skin=skin, lips=lips, iris=iris, hair=hair, brow=mix(mix(hair, natural, 0.35), (0, 0, 0), 0.35))
