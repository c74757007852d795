"""Words of a POV's note name what it looks through."""

from __future__ import annotations

from typing import get_args

import pytest

from storyblender.agents.director.apertures import aperture_of
from storyblender.memory.vocabulary import Aperture


@pytest.mark.parametrize("aperture", [each for each in get_args(Aperture) if each != "tube"])
def test_every_aperture_has_its_name(aperture: Aperture) -> None:
    assert aperture_of(f"the {aperture}") == aperture


@pytest.mark.parametrize(
    ("words", "aperture"),
    [
        ("a rifle scope", "scope"),
        ("Telescope", "tube"),
        ("the crack of the door", "gap"),
        ("the fog", None),
        ("", None),
    ],
)
def test_other_words_name_one_too(words: str, aperture: Aperture | None) -> None:
    assert aperture_of(words) == aperture
