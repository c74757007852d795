"""Ways through a set: short, clear, round, and none where there is none."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from storyblender.geometry.paths import (
    Footprint,
    clearance,
    find_path,
    find_seat_access,
    find_waiting_time,
    path_length,
    round_corners,
)

ROOM = (-4.0, -4.0, 4.0, 4.0)
TABLE = Footprint((0.0, 0.0), (1.6, 0.8), name="table")


def _dense(way: list[tuple[float, float]]) -> np.ndarray:
    return np.concatenate([np.linspace(a, b, max(2, int(math.dist(a, b) / 0.02))) for a, b in itertools.pairwise(way)])


def test_clearance_of_a_turned_box_and_a_disc() -> None:
    box = Footprint((1.0, 0.0), (2.0, 1.0), math.pi / 2)
    disc = Footprint((0.0, 5.0), (0.0, 0.0), round=0.5)
    found = clearance(np.array([[1.0, 1.5], [1.0, 0.0], [2.0, 0.0], [0.0, 4.0]]), [box, disc])
    assert found == pytest.approx([0.5, -0.5, 0.5, 0.5])


def test_a_free_way_is_straight() -> None:
    assert find_path((-3, -3), (3, -3), [TABLE], ROOM, 0.3) == [(-3, -3), (3, -3)]


def test_a_way_goes_round_the_table_and_keeps_its_distance() -> None:
    way = find_path((0, -2), (0, 2), [TABLE], ROOM, 0.3)
    assert way is not None
    assert (way[0], way[-1]) == ((0, -2), (0, 2))
    assert clearance(_dense(way), [TABLE]).min() > 0.22  # corners may cut in a little
    assert path_length(way) < 5.2


def test_a_gap_too_narrow_is_no_way() -> None:
    walls = [Footprint((-2.3, 0), (4.0, 0.1)), Footprint((2.3, 0), (4.0, 0.1))]
    assert find_path((0, -2), (0, 2), walls, (-4, -2.5, 4, 2.5), 0.25) is not None
    assert find_path((0, -2), (0, 2), walls, (-4, -2.5, 4, 2.5), 0.35) is None


def test_the_tight_spot_before_a_chair_can_be_reached() -> None:
    chair = Footprint((0, 0.25), (0.5, 0.5), name="chair")
    way = find_path((-2, -2), (0, -0.18), [chair], ROOM, 0.32)
    assert way is not None
    assert clearance(_dense(way), [chair]).min() > 0.12


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(0.3, 1.2), st.floats(0, 3)), max_size=6),
)
def test_no_way_ever_enters_an_obstacle(boxes: list[tuple[float, float, float, float]]) -> None:
    obstacles = [Footprint((x, y), (size, 0.6 * size), yaw) for x, y, size, yaw in boxes]
    way = find_path((-3.8, -3.8), (3.8, 3.8), obstacles, ROOM, 0.25)
    if way is not None and min(clearance(np.array([way[0], way[-1]]), obstacles), default=1) > 0.25:
        assert clearance(_dense(way), obstacles).min() > 0.1


def test_corners_are_rounded_within_reach() -> None:
    way = round_corners([(0, 0), (1, 0), (1, 1)], 0.2)
    assert max(math.dist(p, (1, 0)) for p in way[1:-1]) <= 0.2 + 1e-9
    assert (1, 0) not in way


def test_who_crosses_waits() -> None:
    def walk(t: float) -> tuple[float, float]:
        return -2 + t, 0.0

    def crossing(t: float) -> tuple[float, float]:
        return 0.0, -2 + t

    wait, gap = find_waiting_time(walk, 4.0, 0.0, [(crossing, 0.6)])
    assert wait > 0
    assert gap >= 0
    assert find_waiting_time(walk, 4.0, 0.0, [])[0] == 0


def test_seats_at_a_table_are_entered_from_the_side() -> None:
    chair = Footprint((0, 0.25), (0.5, 0.5), name="chair")
    near = Footprint((0, -0.55), (1.6, 0.8), name="table")
    assert find_seat_access((0, 0), 0.0, 0.5, 1.0, [chair], "chair") == pytest.approx((0, -0.18))
    x, y = find_seat_access((0, 0), 0.0, 0.5, 1.0, [chair, near], "chair")
    assert abs(x) > 0.4
    assert clearance(np.array([[x, y]]), [chair, near])[0] > 0.15
