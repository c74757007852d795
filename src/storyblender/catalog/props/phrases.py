"""Finds the words of a script's phrase that name a thing: ``small brass key`` is a key, ``pile of money`` is money."""

from __future__ import annotations

from storyblender.catalog.props.variants import COLORS, MATERIALS, PLAIN, words_of

HEAPS: frozenset[str] = frozenset(
    ("pile", "heap", "stack", "bunch", "pair", "piece", "set", "row", "bundle", "roll", "handful", "wad", "sheaf",
     "belt", "field", "ring", "shower", "swarm", "wall", "hail", "cloud")
)  # fmt: skip
"""Words whose ``of`` names the thing: a pile of money, but a bottle of milk."""
MODIFIERS: frozenset[str] = PLAIN | COLORS.keys() | MATERIALS.keys()
"""Words before a noun that do not make another thing of it."""


def noun_words(phrase: str) -> list[str]:
    """Return the words of a phrase that name the thing, its head last, without colours, sizes and materials."""
    return thing_words(kept_words(words_of(phrase)))


def kept_words(words: list[str]) -> list[str]:
    """Return the words without modifiers, cut before ``with``, ``on``, ``in`` ... phrases; the last word always stays.

    Args:
        words: Lower-case, in order, at least one.
    """
    words = before_details(words)
    return [word for word in words[:-1] if word not in MODIFIERS] + words[-1:]


def before_details(words: list[str]) -> list[str]:
    """Return the words of a phrase before ``with``, ``on``, ``in`` ...: ``dog with a collar`` is a dog."""
    for stop in ("with", "on", "in", "from", "for", "at", "by"):
        if stop in words[1:]:
            words = words[: words.index(stop, 1)]
    return words


def thing_words(words: list[str]) -> list[str]:
    """Return the words before ``of``, or after it where the word before only counts: a pile of money, a set of keys."""
    if "of" not in words[1:-1]:
        return words
    at = words.index("of", 1)
    return words[at + 1 :] if words[at - 1] in HEAPS else words[:at]
