"""People of the background: who they are, by variant and age of the story."""

from __future__ import annotations

from typing import Final, cast

from storyblender.catalog.costumes import costume
from storyblender.memory.asset_sheet import CharacterLook
from storyblender.memory.vocabulary import Age, Gender

BYSTANDER: Final = "set_bystander"
"""How the node_id of a figure begins."""
VARIANTS: Final = 6
"""How many different figures a crowd is made of in each posture."""
SEAT_HEIGHT: Final = 0.46
"""Metres from the floor to the seat of a sitting figure."""
_YEARS: Final = (34, 45, 27, 62, 52, 24, 68, 38)
_SKIN: Final = ("light", "tan", "light", "pale", "brown", "light", "light", "tan")
_HAIR: Final = (("short", "wavy"), ("receding", "bun"), ("slick", "bob"), ("crop", "long"))
_GREY: Final = (0.25, 0.24, 0.23)


def look_of(variant: int, age: str) -> CharacterLook:
    """Return the look of a background figure: women and men in turn, of several ages.

    Args:
        variant: Number of the figure, from 0; figures repeat after ``VARIANTS``.
        age: Age of the story, a ``vocabulary.Age``; it decides the clothes.
    """
    gender: Gender = ("female", "male")[variant % 2]
    years = _YEARS[variant % len(_YEARS)]
    men, women = _HAIR[(variant // 2) % len(_HAIR)]
    return CharacterLook(
        gender=gender,
        age=years,
        skin=_SKIN[variant % len(_SKIN)],  # pyright: ignore[reportArgumentType]
        hair=women if gender == "female" else men,
        hair_color=_GREY if years > 60 else None,
        build=("average", "stocky", "slim", "average")[variant % 4],
        garments=costume("", "", cast(Age, age), gender, years, 5 + variant // 2),
    )
