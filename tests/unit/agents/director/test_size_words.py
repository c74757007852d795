"""Sizes in the words of a script become values."""

from __future__ import annotations

import pytest

from storyblender.agents.director.size_words import stated_size
from storyblender.memory.asset_sheet import PLAUSIBLE, AssetDimension, StatedSize


@pytest.mark.parametrize(
    ("words", "measure"),
    [
        ("a bronze statue, 3.5 m tall", AssetDimension(height=3.5)),
        ("a 30 cm long knife", AssetDimension(depth=0.3)),
        ("8 feet wide", AssetDimension(width=2.438)),
        ("two metres high", None),
        (f"{PLAUSIBLE[1] + 1} m long", None),
    ],
)
def test_a_measure_is_read_in_metres(words: str, measure: AssetDimension | None) -> None:
    assert stated_size("it", words, person=False).measure == measure


def test_a_bare_measure_is_no_stature() -> None:
    assert stated_size("Ann", "stands 2 m away", person=True) == StatedSize()


def test_words_of_size_count_in_the_name_and_the_description() -> None:
    assert stated_size("tiny ring", "", person=False).word == "tiny"
    assert stated_size("ring", "a huge ring", person=False).word == "huge"
    assert stated_size("Ann", "a wide grin, petite", person=True).word == "petite"


@pytest.mark.parametrize(
    ("name", "description", "word"),
    [
        ("door", "a door, a little windblown", None),
        ("box", "a little box", "little"),
        ("lamp", "a low hanging lamp", None),
        ("lamp", "a brass lamp with a tall glass", None),
        ("front with a big window", "the wall of a small office", None),
        ("gate", "a wide gate on the road", "wide"),
    ],
)
def test_words_of_something_else_are_no_size(name: str, description: str, word: str | None) -> None:
    assert stated_size(name, description, person=False).word == word


def test_a_likeness_is_a_toy() -> None:
    assert stated_size("bear", "a plush bear", person=False).toy
    assert not stated_size("bear", "a bear", person=False).toy


@pytest.mark.parametrize(("kind", "side"), [("ladder", "height"), ("sofa", "width"), ("car", "depth"), (None, "depth")])
def test_how_long_a_thing_is_means_its_longest_side(kind: str | None, side: str) -> None:
    assert stated_size("it", "3 m long", person=False, kind=kind).measure == AssetDimension(**{side: 3.0})
