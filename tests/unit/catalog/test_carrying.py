"""What is carried with both hands."""

from __future__ import annotations

import math

from storyblender.catalog.carrying import hand_towards, two_handed
from storyblender.memory.asset_sheet import Anchor

GRIP = Anchor(kind="grip", name="grip_r", location=(0, 0, 0.3))


def test_wide_things_and_long_ones_without_a_grip_take_both_hands() -> None:
    assert two_handed((0.5, 0.4, 0.3), (GRIP,))
    assert two_handed((0.9, 0.1, 0.1), ())
    assert not two_handed((0.9, 0.1, 0.1), (GRIP,)), "a case"
    assert not two_handed((0.36, 0.3632, 0.12), (GRIP,)), "a coil of rope"


def test_the_left_hand_takes_what_is_offered_on_the_left() -> None:
    assert hand_towards((0, 0), 0.0, (0.6, -0.5)) == "L"
    assert hand_towards((0, 0), 0.0, (0.2, -0.9)) == "R"
    assert hand_towards((0, 0), math.pi, (0.6, 0.5)) == "R", "who faces the other way has it on the right"
