"""The part of a vocabulary that a request needs: the entries nearest in meaning to the scene at hand."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar

from storyblender.catalog.registry import Entry
from storyblender.ports import Embedder

E = TypeVar("E", bound=Entry)


def nearest_entries(entries: Iterable[E], texts: Sequence[str], embedder: Embedder, most: int) -> list[E]:
    """Return the entries nearest in meaning to any of some texts, in the order of the catalogue.

    Args:
        entries: Of a catalogue.
        texts: Sentences of the scene.
        embedder: Likeness of meaning.
        most: How many.
    """
    listed = list(entries)
    if len(listed) <= most or not texts:
        return listed[:most]
    named = embedder.embed([", ".join((each.name, *each.tags[:6])) for each in listed])
    likeness = (named @ embedder.embed(texts).T).max(axis=1)
    best = sorted(range(len(listed)), key=lambda index: (-round(float(likeness[index]), 4), index))[:most]
    return [listed[index] for index in sorted(best)]
