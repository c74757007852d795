"""What a person wears, to the last colour, and what it comes to when something is put on or taken off."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence

import numpy as np

from storyblender.catalog.bodies import resolved_gender
from storyblender.catalog.color_words import COLOR_WORDS, color_word
from storyblender.catalog.garments import GARMENTS, OUTER_LAYER, dressed
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.catalog.materials import hex_color
from storyblender.catalog.props.variants import COLORS
from storyblender.memory.asset_sheet import Asset, CharacterLook, Garment, LookDecision
from storyblender.memory.base import Color, seed_of

_JACKETS, _COATS = 56, 80
"""Layers from which on garments are worn over waistcoats, and over jackets."""
_ONE_OF = frozenset(("feet", "head"))
"""Areas on which one garment is worn at a time."""


def person_seed(asset: Asset) -> int:
    """Return what varies a person among all with the same words; the same person at another age has it too."""
    return seed_of(asset.reference_character or asset.asset_id)


def worn_by(asset: Asset) -> tuple[Garment, ...]:
    """Return all that a person wears, from the inside out, each piece with its colour."""
    look, seed = asset.decided_look or CharacterLook(), person_seed(asset)
    if look.species:
        return in_colors(clothes_of_animal(look), seed)
    return in_colors(dressed(look, resolved_gender(look, seed), seed), seed)


def clothes_of_animal(look: CharacterLook) -> tuple[Garment, ...]:
    """Return the garments of an animal, innermost first: only those that it is said to wear, because it has a coat."""
    chosen = [garment for garment in look.garments if garment.key in GARMENTS]
    return tuple(sorted(chosen, key=lambda garment: GARMENTS[garment.key].layer))


def in_colors(outfit: Sequence[Garment], seed: int) -> tuple[Garment, ...]:
    """Return an outfit with a colour for each piece.

    Args:
        outfit: Innermost first.
        seed: Picks the colours that it leaves open.
    """
    rng = np.random.default_rng(seed + 3)
    usual = [GARMENTS[each.key].colors for each in outfit]
    picked = [hex_color(colors[int(rng.integers(len(colors)))]) for colors in usual]
    return tuple(
        each.model_copy(update={"color": each.color or color}) for each, color in zip(outfit, picked, strict=True)
    )


def put_on(outfit: Iterable[Garment], garment: Garment) -> tuple[Garment, ...]:
    """Return an outfit with one more garment, in place of what cannot be worn with it: a dress for a skirt and a shirt.

    Args:
        outfit: What is worn.
        garment: Of the catalogue.
    """
    kept = [each for each in outfit if not _in_the_way(each.key, garment.key)]
    return tuple(sorted((*kept, garment), key=lambda each: GARMENTS[each.key].layer))


def take_off(outfit: Iterable[Garment], keys: Collection[str]) -> tuple[Garment, ...]:
    """Return an outfit without some of its garments."""
    return tuple(each for each in outfit if each.key not in keys)


def _in_the_way(worn: str, new: str) -> bool:
    """Return whether a garment has to come off for another."""
    first, second = GARMENTS[worn], GARMENTS[new]
    shared = {*first.covers} & {*second.covers}
    return worn == new or bool(shared & _ONE_OF) or (bool(shared) and _level(first.layer) == _level(second.layer))


def _level(layer: int) -> int:
    """Return how far outside a garment is worn: shirts, waistcoats, jackets, coats."""
    return sum(layer >= each for each in (OUTER_LAYER, _JACKETS, _COATS))


def color_named(words: str) -> Color | None:
    """Return the scene-linear colour that a word or a hex code names; None if it names none."""
    if re.fullmatch(r"#[0-9a-fA-F]{6}", words):
        return hex_color(words)
    code = COLOR_WORDS.get(words.lower()) or COLORS.get(words.lower())
    return hex_color(code) if code is not None else None


def garment_named(words: str) -> Garment | None:
    """Return the garment that words name, with the colour before it: ``red coat``; None if they name none."""
    said = " ".join(words.lower().replace("_", " ").split())
    said = said.removeprefix("a ").removeprefix("an ").removeprefix("the ")
    for spec in GARMENTS.values():
        for term in (spec.name.lower(), spec.key.replace("_", " "), *spec.tags):
            if said == term:
                return Garment(key=spec.key)
            if said.endswith(f" {term}") and (color := color_named(said.removesuffix(term).strip())) is not None:
                return Garment(key=spec.key, color=color)
    return None


def look_words(decision: LookDecision) -> str:
    """Return a decision about a look as a person reads it, e.g. ``hair bob, black; in a red coat and shoes``."""
    said = {name: value for name, value in decision.told.items() if name not in ("hair_color", "garments", "hair")}
    words = [_said(name, value) for name, value in said.items()]
    hair = [HAIRSTYLES[decision.hair].name.lower()] if decision.hair and decision.hair in HAIRSTYLES else []
    hair += [color_word(decision.hair_color)] if decision.hair_color is not None else []
    words += [f"hair {', '.join(hair)}"] if hair else []
    if decision.garments is not None:
        worn = [garment_words(each) for each in decision.garments]
        words.append(f"wears {', '.join(worn) or 'what is usual'}")
    return "; ".join(words)


def garment_words(garment: Garment) -> str:
    """Return a garment as people call it: ``red coat``."""
    color = f"{color_word(garment.color)} " if garment.color is not None else ""
    return color + (GARMENTS[garment.key].name if garment.key in GARMENTS else garment.key)


def _said(name: str, value: object) -> str:
    match name:
        case "age":
            return f"{value:g} years old"
        case "stature":
            return f"{value:g} m tall"
        case "glasses":
            return "wears glasses" if value else "without glasses"
        case "facial_hair":
            return "shaven" if value == "none" else str(value)
        case "face":
            return f"face {value}"
        case "skin":
            return f"{value} skin"
    return str(value)
