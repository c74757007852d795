"""Things of a script that the set shows: doors and windows, hills, streams, the sky, the place itself."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from functools import cache
from typing import Final

from storyblender.agents.director import lexicon
from storyblender.agents.director.reading import Thing
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import kind_named
from storyblender.catalog.sets.kit import SetKit

FIXTURES = lexicon.words("fixtures")
"""Head nouns of what the set kit builds, or what belongs to another thing."""
_AFTER_HEAD: Final = re.compile(r"\b(?:of|with|in|on|from|for|at)\b")
"""Words that end the part of a name in which the noun is."""


def head_of(name: str) -> str:
    """Return the noun of a thing's name: ``door`` of ``front door of the inn``."""
    words = _AFTER_HEAD.split(name.lower())[0].split()
    return words[-1] if words else ""


def is_fixture(thing: Thing) -> bool:
    """Whether the set shows a thing: its parts, and land, sky and weather that the catalog does not build.

    A window or hatch that the catalog has under a name of its own, such as a service window, is a thing.
    """
    if kind_named(thing.name) not in _kinds_of_fixtures():
        return False
    heads = {thing.id.rsplit("_", 1)[-1], head_of(thing.name)}
    if heads & FIXTURES:
        return True
    head = head_of(thing.name)
    return lexicon.noun_class(head) == "scenery" and head not in _catalog_nouns()


def fixture_ids(things: Iterable[tuple[str, str]], pieces: Collection[str] = ()) -> dict[str, str]:
    """Return new ids for parts of the set whose ids do not end with their noun, by which the set is searched.

    Args:
        things: Ids and names: ``fdoor``, ``front door`` becomes ``fdoor_door``.
        pieces: Names of the pieces of the story's sets, in words: with ``great lens``, ``lamp`` becomes ``lamp_lens``.
    """
    named = [(id_, name.lower(), head_of(name)) for id_, name in things]
    return {
        id_: f"{id_[:50]}_{head}"
        for id_, name, head in named
        if (head in FIXTURES and id_.rsplit("_", 1)[-1] not in FIXTURES)
        or (_is_called(name, pieces) and id_.rsplit("_", 1)[-1] != head)
        if head.isidentifier()
    }


def is_piece(thing: Thing, pieces: Collection[str]) -> bool:
    """Whether a set piece of the story is one that the set has under that name: the great lens of a lighthouse.

    Args:
        thing: Of the reading.
        pieces: Names of the pieces of the set, in words.
    """
    names = (thing.name.lower(), thing.id.replace("_", " "))
    return thing.kind == "set_piece" and any(_is_called(name, pieces) for name in names)


def _is_called(name: str, pieces: Collection[str]) -> bool:
    """Whether a name in small letters is, or ends with, the name of a piece."""
    return any(name == piece or name.endswith(f" {piece}") for piece in pieces)


def is_scenery(name: str, place: str, kit: SetKit) -> bool:
    """Whether an object is the place itself or a part of its set: the house in a house, the mirror of a car.

    Args:
        name: Of the object, as in the script.
        place: Of the scene, as in its heading.
        kit: Of the scene.
    """
    name, place = name.lower(), place.lower()
    part = any(name == word or name.endswith(f" {word}") for word in kit.has)
    return part or (kit.indoor and bool(place) and name.split()[-1:] == place.split()[-1:])


@cache
def _kinds_of_fixtures() -> frozenset[str]:
    """Return the props that are meant by nouns of parts of the set, and none."""
    return frozenset({"", *map(kind_named, FIXTURES)})


@cache
def _catalog_nouns() -> frozenset[str]:
    """Return the nouns of all things that the catalog builds."""
    return frozenset(head_of(word) for entry in PROPS.values() for word in (entry.name, *entry.tags))
