"""How large things usually are that have a name but no entry among the props, for models from outside."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.resources import files

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props.phrases import before_details
from storyblender.catalog.props.prop_names import prop_called
from storyblender.memory.base import Vec3


@cache
def _sizes() -> dict[tuple[str, ...], tuple[Vec3, float]]:
    """Return the table; its last column, where there is one, is the span of such things."""
    found: dict[tuple[str, ...], tuple[Vec3, float]] = {}
    table = files("storyblender.catalog").joinpath("usual_sizes.tsv").read_text(encoding="utf-8")
    for name, *numbers in (line.split("\t") for line in table.splitlines()):
        width, depth, height, span = *map(float, numbers), *[1.0][len(numbers) - 3 :]
        found[tuple(noun_key(word) for word in name.split())] = ((width, depth, height), span)
    return found


def usual_size(words: Sequence[str]) -> tuple[Vec3, float] | None:
    """Return width, depth and height in metres of what the last words of a name mean, and its span; None if unknown.

    The span is how many times larger or smaller such a thing may be as well. A prop of that very name counts before a
    shorter name here: a coffee table is no table.

    Args:
        words: Lower-case words of a name, the thing last, or before ``with``, ``of``, ``and``.
    """
    told = [noun_key(word) for word in before_details(list(words))]
    for start in range(len(told)):
        phrase = tuple(told[start:])
        if phrase in _sizes():
            return _sizes()[phrase]
        entry = prop_called(phrase)
        if entry is not None:
            return entry.size, 1.0
    return None
