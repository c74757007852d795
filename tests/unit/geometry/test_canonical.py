"""A model keeps the pose that its file gives it, unless it cannot be meant."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from storyblender.geometry import solids
from storyblender.geometry.canonical import find_likely_tip, find_upright_rotation, rotation_of
from storyblender.memory.asset_sheet import ModelPose, ModelSide


def box(size: tuple[float, float, float]) -> tuple[np.ndarray, np.ndarray]:
    points, faces = solids.box(size)
    return points, np.array([(face[0], face[i], face[i + 1]) for face in faces for i in (1, 2)])


def test_what_stands_on_two_wheels_is_left_standing() -> None:
    points, triangles = box((0.04, 1.7, 1.0))
    assert np.array_equal(find_upright_rotation(points, triangles), np.eye(3))


SIDES = get_args(ModelSide)
PAIRS = [(front, top) for top in SIDES for front in (None, *SIDES)]


@pytest.mark.parametrize(("front", "top"), PAIRS)
def test_the_sides_that_are_front_and_top_become_so(front: ModelSide | None, top: ModelSide) -> None:
    ways = {"front": (0, -1, 0), "back": (0, 1, 0), "left": (-1, 0, 0), "right": (1, 0, 0)}
    ways |= {"top": (0, 0, 1), "bottom": (0, 0, -1)}
    if front is not None and np.dot(ways[front], ways[top]):
        with pytest.raises(ValueError, match="cannot be"):
            rotation_of(ModelPose(front=front, top=top))
        return
    turn = rotation_of(ModelPose(front=front, top=top))
    assert np.linalg.det(turn) == pytest.approx(1)
    assert np.allclose(turn @ turn.T, np.eye(3))
    assert np.allclose(turn @ ways[top], ways["top"])
    if front is not None:
        assert np.allclose(turn @ ways[front], ways["front"])
    elif top == "top":
        assert np.allclose(turn, np.eye(3))


@pytest.mark.parametrize("size", [(1.2, 0.6, 2.0), (0.9, 0.1, 2.05), (0.5, 0.5, 1.6)])
def test_what_lies_on_its_back_stands_up_in_its_usual_proportions(size: tuple[float, float, float]) -> None:
    points, triangles = box(size)
    usual = (1.1 * size[0], 0.9 * size[1], size[2])
    assert find_likely_tip(points, triangles, usual) is None
    lying = points[:, [0, 2, 1]] * (1, -1, 1)
    turn = find_likely_tip(lying, triangles, usual)
    assert turn is not None and np.ptp(lying @ turn.T, axis=0) == pytest.approx(size)


def test_proportions_that_are_those_of_no_such_thing_say_nothing() -> None:
    points, triangles = box((3.0, 1.0, 0.2))
    assert find_likely_tip(points, triangles, (1.0, 1.0, 1.0)) is None
