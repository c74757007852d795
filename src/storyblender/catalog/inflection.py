"""Singulars of English nouns: one set of rules for the reader, the catalog and the crew."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from typing import Final


def _words(kind: str) -> Iterator[str]:
    for line in files("storyblender.catalog").joinpath("plurals.tsv").read_text(encoding="utf-8").splitlines():
        if line.startswith(f"{kind}\t"):
            yield from line.split()[1:]


PLURAL_ONLY: Final = frozenset(_words("only"))
"""Nouns that name one thing, or one mass of things, in the plural."""
_IRREGULAR: Final = dict(pair.split("=") for pair in _words("irregular"))


def singular(word: str) -> str:
    """Return the singular of a noun, lower case: ``knives`` -> ``knife``; ``PLURAL_ONLY`` nouns stay as they are."""
    word = word.lower()
    return word if word in PLURAL_ONLY else noun_key(word)


@cache
def noun_key(word: str) -> str:
    """Return the form in which nouns are compared: the singular, even of ``PLURAL_ONLY``: ``stairs`` -> ``stair``."""
    word = word.lower()
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if word.endswith("men") and len(word) > 5:
        return word[:-2] + "an"
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if re.search(r"(ch|sh|x|ss)es$", word) or re.search(r"(at|et|er|ch|ng|ed|rg|it)oes$", word):
        return word[:-2]
    return word[:-1] if word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3 else word
