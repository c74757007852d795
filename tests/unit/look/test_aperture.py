"""What a point of view looks through stands round the picture."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.look.aperture import look_through

WHITE = np.full((90, 160, 3), 255, np.uint8)


@pytest.mark.parametrize("words", ["binoculars", "a keyhole", "rifle scope", "telescope", "the crack of the door"])
def test_the_rim_is_dark_and_the_middle_open(words: str) -> None:
    seen = look_through(WHITE, words)
    assert seen[2, 2].max() < 30, "nothing is seen past the opening"
    assert seen[40, 76].min() > 240, "the middle stays as it is, beside the lines of a sight"


def test_a_camera_shows_all_of_the_picture_and_its_marks() -> None:
    seen = look_through(WHITE // 2, "the camera's viewfinder")
    assert (seen == 127).all(axis=2).mean() > 0.9
    assert (seen > 200).any()


def test_what_is_not_known_changes_nothing() -> None:
    for words in ("", "the fog"):
        assert look_through(WHITE, words) is WHITE
