"""The middle of a picture is empty where its people are many heads apart."""

from __future__ import annotations

import pytest

from storyblender.geometry.gaps import MAX_FACE_GAP, widest_face_gap


def test_a_gap_is_told_in_heads_of_the_nearest() -> None:
    assert widest_face_gap([(0.1, 0.1), (0.9, 0.1)], 2.0) == pytest.approx(16.0)
    assert widest_face_gap([(0.1, 0.1), (0.9, 0.4)], 2.0) == pytest.approx(4.0), "a deep picture is not empty"


def test_who_stands_between_fills_the_middle() -> None:
    apart = widest_face_gap([(0.1, 0.1), (0.9, 0.1)], 1.8)
    assert apart > MAX_FACE_GAP > widest_face_gap([(0.1, 0.1), (0.5, 0.1), (0.9, 0.1)], 1.8)


@pytest.mark.parametrize("faces", [[], [(0.5, 0.2)], [(0.1, 0.0), (0.9, 0.0)]])
def test_nobody_is_apart_from_themselves(faces: list[tuple[float, float]]) -> None:
    assert widest_face_gap(faces, 1.8) == 0.0
