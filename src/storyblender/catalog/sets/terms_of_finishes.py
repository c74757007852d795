"""Finishes by name: ``brick`` walls, a ``wooden`` floor, ``green`` walls in the material that they have."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props.variants import COLORS, PLAIN, words_of
from storyblender.catalog.props.variants import MATERIALS as MATERIAL_WORDS
from storyblender.catalog.sets.finishes import FINISHES, finish_of

_BARE = frozenset({"bare", "painted", "colored", "coloured"})


def finish_named(words: str, present: str = "") -> str:
    """Return the finish or the material that words name; empty if there is none.

    Args:
        words: ``red brick``, ``parquet``, ``green``.
        present: What the surface is made of now: a colour alone means that material in this colour, if there is one.
    """
    said = {word for word in words_of(words) if word not in PLAIN - COLORS.keys() or _known(word)} - _BARE
    key = "_".join(words_of(words))
    if key in FINISHES or key in MATERIALS:
        return key
    if not said:
        return ""
    meant = [{word, MATERIAL_WORDS.get(word, word)} for word in said]
    fits = [name for name in (*MATERIALS, *FINISHES) if all(_terms(name) & each for each in meant)]
    material = finish_of(present).material if present else ""
    only_color = said <= COLORS.keys()
    if only_color:
        fits = [name for name in fits if name in FINISHES]
    return min(
        fits, key=lambda name: (finish_of(name).material != material and only_color, len(_own(name))), default=""
    )


def _known(word: str) -> bool:
    return any(word in _terms(name) for name in FINISHES)


@cache
def _terms(name: str) -> frozenset[str]:
    """Return all words of a finish: of its key, its material's key, and the material's own words."""
    entry = MATERIALS.get(finish_of(name).material)
    told: Iterable[str] = (*entry.tags, *entry.name.split()) if entry is not None else ()
    spelled = {"gray" if word == "grey" else "grey" if word == "gray" else word for word in _own(name)}
    return frozenset((*_own(name), *spelled, *finish_of(name).material.split("_"), *told))


def _own(name: str) -> tuple[str, ...]:
    return tuple(name.split("_"))
