"""What a point of view looks through stands round the picture."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.look.aperture import look_through
from storyblender.memory.vocabulary import Aperture

WHITE = np.full((90, 160, 3), 255, np.uint8)


@pytest.mark.parametrize("through", ["binoculars", "keyhole", "scope", "tube", "gap"])
def test_the_rim_is_dark_and_the_middle_open(through: Aperture) -> None:
    seen = look_through(WHITE, through)
    assert seen[2, 2].max() < 30, "nothing is seen past the opening"
    assert seen[40, 76].min() > 240, "the middle stays as it is, beside the lines of a sight"


def test_a_camera_shows_all_of_the_picture_and_its_marks() -> None:
    seen = look_through(WHITE // 2, "viewfinder")
    assert (seen == 127).all(axis=2).mean() > 0.9
    assert (seen > 200).any()


def test_a_clear_view_changes_nothing() -> None:
    assert look_through(WHITE, None) is WHITE
