"""Which side of a thing is its front: where it is hollow, and as long as such things are wide."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.geometry import solids
from storyblender.geometry.facing import crosswise, drives_backwards, quarters_to_hollow_front


def boxes(*made: tuple[tuple[float, float, float], tuple[float, float, float]]) -> tuple[np.ndarray, np.ndarray]:
    """Return points and triangles of boxes, each a middle and a size."""
    points: list[np.ndarray] = []
    triangles: list[np.ndarray] = []
    for middle, size in made:
        corners, faces = solids.box(size)
        corners = np.array(corners) - (np.array(corners).min(axis=0) + np.array(corners).max(axis=0)) / 2 + middle
        split = [(face[0], face[i], face[i + 1]) for face in faces for i in (1, 2)]
        triangles.append(np.array(split) + sum(len(each) for each in points))
        points.append(corners)
    return np.concatenate(points), np.concatenate(triangles)


CABINET = boxes(
    ((0, 0, 0.5), (1.0, 0.4, 1.0)), ((-0.2, -0.22, 0.6), (0.05, 0.04, 0.2)), ((0.2, -0.22, 0.6), (0.05, 0.04, 0.2))
)
CAR = boxes(((0, 0, 0.5), (1.8, 4.5, 0.6)), ((0, 0.5, 1.1), (1.6, 2.0, 0.6)))


def turned(points: np.ndarray, quarters: int) -> np.ndarray:
    return points @ np.linalg.matrix_power(np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), quarters).T


@pytest.mark.parametrize("quarters", range(4))
def test_handles_are_on_the_front(quarters: int) -> None:
    points, triangles = CABINET
    assert quarters_to_hollow_front(turned(points, quarters), triangles, (0, 1, 2, 3)) == -quarters % 4


def test_what_is_the_same_from_all_sides_stays() -> None:
    points, triangles = boxes(((0, 0, 0.5), (1.0, 1.0, 1.0)))
    assert quarters_to_hollow_front(points, triangles, (0, 1, 2, 3)) == 0


def test_a_table_stands_with_its_long_side_before_it() -> None:
    assert crosswise(np.array([0.8, 1.7, 0.75]), (1.8, 0.9, 0.75)) and crosswise(
        np.array([4.5, 1.8, 1.5]), (1.8, 4.6, 1.5)
    )
    assert not crosswise(np.array([1.7, 0.8, 0.75]), (1.8, 0.9, 0.75))
    assert not crosswise(np.array([0.9, 1.0, 0.75]), (1.8, 0.9, 0.75)), "it is as good as square"


def test_the_roof_of_a_car_is_behind_its_middle() -> None:
    points, triangles = CAR
    assert not drives_backwards(points, triangles) and drives_backwards(turned(points, 2), triangles)
