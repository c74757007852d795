"""Things are in the hand that the script names."""

from __future__ import annotations

import pytest

from storyblender.agents.visual_effects_artist.person import Person
from storyblender.memory.vocabulary import Grip, Hand


@pytest.mark.parametrize(
    ("grip", "held"),
    [("left", {"L": "cup"}), ("both", {"L": "cup", "R": "cup"}), ("worn", {}), (None, {"R": "cup"})],
)
def test_a_thing_is_held_as_the_script_says(grip: Grip | None, held: dict[Hand, str]) -> None:
    person = Person("ann", 1.0, held={"R": "cup"})
    person.hold_as("cup", grip)
    assert person.held == held


def test_a_hand_that_holds_something_else_keeps_it() -> None:
    person = Person("ann", 1.0, held={"R": "cup", "L": "lamp"})
    person.hold_as("cup", "left")
    assert person.held == {"R": "cup", "L": "lamp"}
