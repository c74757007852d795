"""A model keeps the size and pose that its file gives it, unless they cannot be meant."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from storyblender.geometry import solids
from storyblender.geometry.canonical import find_scale, find_upright_rotation, rotation_of
from storyblender.memory.asset_sheet import AssetDimension, ModelPose, ModelSide


def box(size: tuple[float, float, float]) -> tuple[np.ndarray, np.ndarray]:
    points, faces = solids.box(size)
    return points, np.array([(face[0], face[i], face[i + 1]) for face in faces for i in (1, 2)])


def test_a_plausible_size_is_kept_and_nothing_is_said() -> None:
    desk = np.array([1.40, 0.65, 0.75])
    assert find_scale(desk, AssetDimension(width=1.6), told=False) == (1.0, "")
    assert find_scale(desk[[1, 0, 2]], AssetDimension(width=1.6), told=False) == (1.0, ""), "whichever way it lies"


@pytest.mark.parametrize(("unit", "name"), [(100.0, "centimetres"), (1000.0, "millimetres"), (39.37, "inches")])
def test_another_unit_is_told_by_what_the_thing_is(unit: float, name: str) -> None:
    scale, reason = find_scale(np.array([1.4, 0.65, 0.75]) * unit, AssetDimension(width=1.6), told=False)
    assert scale * unit == pytest.approx(1.0, rel=0.01) and name in reason


def test_without_a_name_only_what_cannot_be_metres_is_scaled() -> None:
    assert find_scale(np.array([3.0, 3.0, 3.0]), None, told=False) == (1.0, "")
    scale, reason = find_scale(np.array([40.0, 40.0, 90.0]), None, told=False)
    assert scale == 0.01 and "centimetres" in reason


def test_what_the_script_tells_counts() -> None:
    scale, reason = find_scale(np.array([0.2, 0.2, 0.5]), AssetDimension(height=1.0), told=True)
    assert scale == pytest.approx(2.0) and "script" in reason


def test_what_is_absurd_in_every_unit_gets_the_usual_size() -> None:
    scale, reason = find_scale(np.array([5e5, 5e5, 5e5]), AssetDimension(height=0.5), told=False)
    assert scale * 5e5 == pytest.approx(0.5) and "usual" in reason


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
