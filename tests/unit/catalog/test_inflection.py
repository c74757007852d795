"""Singulars: every regular ending, the irregular nouns, and nouns that are always plural."""

from __future__ import annotations

import pytest

from storyblender.catalog.inflection import PLURAL_ONLY, noun_key, singular
from storyblender.catalog.props import PROPS


@pytest.mark.parametrize(
    ("plural", "one"),
    [
        ("chairs", "chair"), ("Benches", "bench"), ("cherries", "cherry"), ("torpedoes", "torpedo"), ("boxes", "box"),
        ("knives", "knife"), ("firemen", "fireman"), ("glass", "glass"), ("bus", "bus"), ("iris", "iris"),
    ],
)  # fmt: skip
def test_a_noun_in_the_plural_has_its_singular(plural: str, one: str) -> None:
    assert singular(plural) == noun_key(plural) == one


def test_nouns_that_are_always_plural_stay_so_and_compare_like_others() -> None:
    assert all(singular(noun) == noun for noun in PLURAL_ONLY)
    assert noun_key("stairs") == "stair"


def test_the_key_of_a_noun_is_its_own_key() -> None:
    names = [word for entry in PROPS.values() for term in (entry.name, *entry.tags) for word in term.split()]
    keys = {noun_key(word) for word in names}
    assert {noun_key(key) for key in keys} == keys
