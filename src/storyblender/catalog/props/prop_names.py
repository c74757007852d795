"""Which prop of the catalog a name means, and which one an object of the story is."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.props.phrases import before_details, thing_words
from storyblender.catalog.props.variants import words_of
from storyblender.memory.asset_sheet import Asset


def prop_of(asset: Asset) -> str:
    """Return the catalog key of the prop that an object was built from, else of the one it is; empty if none is known.

    A project older than schema 6 does not have the Director's decision: there the name is looked up.
    """
    if asset.asset_type != "object":
        return ""
    if asset.canonical is not None and asset.canonical.source == "catalog":
        return asset.canonical.key
    return kind_named(asset.name or asset.asset_id) if asset.kind is None else asset.kind


def props_of(assets: Iterable[Asset]) -> dict[str, str]:
    """Return the catalog key of each object's prop, by asset id, without objects that are none of the catalog."""
    return {asset.asset_id: prop for asset in assets if (prop := prop_of(asset)) in PROPS}


def kind_named(name: str) -> str:
    """Return the catalog key of the prop that a name means, as in ``prop_named``; empty if it means none."""
    entry = prop_named(name)
    return "" if entry is None else entry.key


def prop_named(name: str) -> PropEntry | None:
    """Return the prop that a name means: its own name, else the longest name of a prop that its noun phrase ends with.

    ``old park benches`` is a park bench, ``photo of a car`` a photo and no car; None if the catalog has no such prop.
    """
    words = _words(name)
    noun = thing_words(before_details(words))
    phrases = (words, *(noun[start:] for start in range(len(noun))))
    forms = (form for phrase in phrases for form in (tuple(phrase), _singular(phrase)))
    return next((_names()[form] for form in forms if form in _names()), None)


def prop_called(words: Iterable[str]) -> PropEntry | None:
    """Return the prop that has exactly these lower-case words for a name."""
    return _names().get(tuple(words))


@cache
def _names() -> dict[tuple[str, ...], PropEntry]:
    """Return every prop by its names, also in the singular; names go before other names, and both before singulars."""
    terms = [(_words(entry.name), entry) for entry in PROPS.values()]
    terms += [(_words(term), entry) for entry in PROPS.values() for term in entry.tags]
    names: dict[tuple[str, ...], PropEntry] = {}
    for words, entry in terms:
        names.setdefault(tuple(words), entry)
    for words, entry in terms:
        names.setdefault(_singular(words), entry)
    return names


def _words(name: str) -> list[str]:
    """Return the words of a name; an owner stays, since a doll's house is no house."""
    return words_of(name.replace("'", "").replace("’", ""))


def _singular(words: list[str]) -> tuple[str, ...]:
    return tuple(noun_key(word) for word in words)
