"""Nearest props: which catalog prop looks most like an object that the catalog lacks, by its noun alone."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.resources import files

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props.variants import words_of


def near_kind(words: Sequence[str]) -> tuple[str, str] | None:
    """Return the key of the prop that substitutes for an object and the noun that matched; None without a match.

    Args:
        words: Words of a noun phrase in lower case, head noun last; the longest listed suffix decides.
    """
    phrase = tuple(noun_key(word) for word in words)
    for start in range(len(phrase)):
        if (key := kinds().get(phrase[start:])) is not None:
            return key, " ".join(words[start:])
    return None


@cache
def kinds() -> dict[tuple[str, ...], str]:
    """Return every listed noun (its words in the singular) with its prop; the first line with a noun wins."""
    kinds: dict[tuple[str, ...], str] = {}
    for line in files("storyblender.catalog").joinpath("kinds.tsv").read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            continue
        key, nouns = line.split("\t")
        for noun in nouns.split():
            kinds.setdefault(tuple(noun_key(word) for word in words_of(noun)), key)
    return kinds
