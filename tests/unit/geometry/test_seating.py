"""What is no seat is sat on where the script says so, and only then."""

from __future__ import annotations

import pytest

from storyblender.geometry.seating import list_seats
from storyblender.memory.asset_sheet import Anchor

SEAT = Anchor(kind="seat", location=(0, -0.2, 0.45), size=(0.45, 0.4))


def test_a_parcel_is_a_seat_only_for_who_is_said_to_sit_on_it() -> None:
    assert list_seats((), (0.45, 0.35, 0.32)) == []
    (edge,) = list_seats((), (0.45, 0.35, 0.32), asked=True)
    assert edge.location == (0.0, -0.175, 0.32)


def test_a_chair_has_its_own_seat_alone() -> None:
    assert list_seats((SEAT,), (0.5, 0.5, 0.9), asked=True) == [SEAT]


@pytest.mark.parametrize("size", [(0.5, 0.5, 2.1), (0.5, 0.5, 0.05), (0.1, 0.5, 0.4)])
def test_nobody_sits_on_a_wardrobe_a_rug_or_a_rail(size: tuple[float, float, float]) -> None:
    assert list_seats((), size, asked=True) == []
