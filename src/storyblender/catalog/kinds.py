"""Kinds of things: which prop of the catalog looks most like a thing that the catalog lacks, by the noun alone."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.resources import files

from storyblender.catalog.props.variants import singular, words_of


def near_kind(words: Sequence[str]) -> tuple[str, str] | None:
    """Return the key of the prop that stands in for a thing, and the noun it was found by; None if none is known.

    Args:
        words: Of a noun phrase in lower case, its head last; the longest end of it that is listed decides.
    """
    phrase = tuple(singular(word) for word in words)
    for start in range(len(phrase)):
        if (key := kinds().get(phrase[start:])) is not None:
            return key, " ".join(words[start:])
    return None


@cache
def kinds() -> dict[tuple[str, ...], str]:
    """Return every listed noun, as words in the singular, with its prop; the first line that has a noun wins."""
    kinds: dict[tuple[str, ...], str] = {}
    for line in files("storyblender.catalog").joinpath("kinds.tsv").read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            continue
        key, nouns = line.split("\t")
        for noun in nouns.split():
            kinds.setdefault(tuple(singular(word) for word in words_of(noun)), key)
    return kinds
