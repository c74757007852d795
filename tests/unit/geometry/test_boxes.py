import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from storyblender.geometry.boxes import Box, corners, distance_to_point, footprint_gap, penetration, yaw_along

place = st.floats(-3, 3)
extent = st.floats(0.1, 2)
angle = st.floats(-math.pi, math.pi)
boxes = st.builds(Box, place, place, st.just(0.0), extent, extent, extent, angle)


@settings(max_examples=200, deadline=None)
@given(boxes, boxes)
def test_moving_by_the_penetration_just_parts_the_boxes(a: Box, b: Box) -> None:
    depth, axis = penetration(a, b)
    if depth > 0:
        a.x += axis[0] * (depth + 1e-6)
        a.y += axis[1] * (depth + 1e-6)
        assert penetration(a, b)[0] == 0


@settings(max_examples=200, deadline=None)
@given(boxes, boxes)
def test_separation_agrees_with_sampled_points(a: Box, b: Box) -> None:
    grid = np.linspace(-0.5, 0.5, 9)
    inside = [a.to_world(u * a.width, v * a.depth) for u in grid for v in grid]
    if min(distance_to_point(b, *point) for point in inside) < -1e-6:
        assert footprint_gap(a, b)[0] < 0


def test_forward_and_facing_follow_the_convention() -> None:
    assert Box(0, 0, 0, 1, 1, 1).forward == pytest.approx((0, -1))
    assert Box(0, 0, 0, 1, 1, 1, math.pi / 2).forward == pytest.approx((1, 0))
    assert yaw_along(1, 0) == pytest.approx(math.pi / 2)
    assert yaw_along(0, -1) == pytest.approx(0)


def test_stacked_boxes_do_not_penetrate() -> None:
    assert penetration(Box(0, 0, 0.75, 0.2, 0.2, 0.2), Box(0, 0, 0, 1, 1, 0.75))[0] == 0


def test_corners_turn_with_the_box() -> None:
    box = Box(1, 2, 0, 2, 1, 3, math.pi / 2)
    assert corners(box).min(0) == pytest.approx([0.5, 1, 0])
    assert corners(box).max(0) == pytest.approx([1.5, 3, 3])
