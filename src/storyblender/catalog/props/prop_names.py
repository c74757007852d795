"""Finds the catalog prop that a name from the script ends with."""

from __future__ import annotations

from functools import cache

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.props.variants import words_of


def prop_named(name: str) -> PropEntry | None:
    """Return the prop whose name, or other name, ends a phrase; the longest that does. None if none does."""
    words = tuple(noun_key(word) for word in words_of(name))
    for start in range(len(words)):
        if (found := _names().get(words[start:])) is not None:
            return found
    return None


@cache
def _names() -> dict[tuple[str, ...], PropEntry]:
    """Return every prop by its names in the singular; a name goes before another's further name."""
    names: dict[tuple[str, ...], PropEntry] = {}
    for entry in PROPS.values():
        for term in entry.tags:
            names.setdefault(tuple(noun_key(word) for word in words_of(term)), entry)
    return names | {tuple(noun_key(word) for word in words_of(entry.name)): entry for entry in PROPS.values()}
