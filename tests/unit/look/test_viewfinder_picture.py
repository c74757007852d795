"""What an operator is shown: outlines in red, the frame, a dimmed surround, numbers on a sheet."""

from __future__ import annotations

from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from storyblender.look.viewfinder_picture import MARGIN, annotated, as_png, frame_in, numbered_sheet

RED = (255, 20, 20)


def grey(width: int = 250, height: int = 150) -> np.ndarray:
    return np.full((height, width, 3), 160, np.uint8)


def is_red(picture: np.ndarray) -> np.ndarray:
    return (picture == RED).all(-1)


def test_the_frame_is_as_it_was_and_its_surround_is_darker() -> None:
    seen = annotated(grey(), [])
    left, top, right, bottom = frame_in(250, 150)
    assert (seen[top:bottom, left:right] == 160).all()
    outside = np.ones(seen.shape[:2], bool)
    outside[top - 3 : bottom + 3, left - 3 : right + 3] = False
    assert (seen[outside] < 100).all()
    assert (right - left) * MARGIN == pytest.approx(250, abs=2)


def test_every_subject_is_outlined_and_none_is_covered() -> None:
    masks = [np.zeros((150, 250), bool) for _ in range(3)]
    masks[0][60:80, 60:80] = True
    masks[1][40:100, 150:170] = True
    seen = annotated(grey(), masks)
    for mask in masks[:2]:
        assert not is_red(seen)[mask].any()
        assert (is_red(seen) & np.roll(mask, 1, 0) & ~mask).any(), "the outline touches it"
    assert (is_red(annotated(grey(), masks[2:])) == 0).all(), "what is not seen is not outlined"


@pytest.mark.parametrize("count", [1, 2, 5])
def test_a_sheet_holds_every_picture_at_its_size(count: int) -> None:
    colors = [(40 * number, 200 - 30 * number, 90) for number in range(count)]
    pictures = [as_png(np.full((90, 160, 3), color, np.uint8)) for color in colors]
    sheet = np.asarray(Image.open(BytesIO(numbered_sheet(pictures))).convert("RGB")).reshape(-1, 3).astype(int)
    for color in colors:
        assert (abs(sheet - color).max(1) < 8).sum() > 0.9 * 90 * 160
