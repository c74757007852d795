"""What a scene says of how full its place is."""

from __future__ import annotations

import pytest

from storyblender.agents.director.crowds import crowd_in


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ("CAFE", "Smoke hangs over the crowded café."),
        ("PACKED BAR", "Ada sits alone."),
        ("LOUNGE", "Rammed. Phones charging on every surface."),
        ("SQUARE", "A busy little market in the morning."),
        ("THEATRE", "The audience rises."),
        ("STATION", "It is full of commuters."),
        ("STREET", "Shoppers throng the pavement."),
        ("CLUB", "The club is absolutely heaving."),
    ],
)
def test_a_full_place_is_told(place: str, words: str) -> None:
    assert crowd_in(place, words) == ("busy" if "busy" in words else "full")


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ("KITCHEN", "Ada packed the boxes. The shelves are full of jars."),
        ("OFFICE", "Tom is busy with the printer."),
        ("STREET", "An empty street. A dog crosses."),
        ("BEDROOM", "She has packed her suitcase."),
        ("HALL", "A guest comes in."),
    ],
)
def test_what_is_packed_or_busy_otherwise_is_no_crowd(place: str, words: str) -> None:
    assert crowd_in(place, words) is None


def test_a_place_is_emptied() -> None:
    assert crowd_in("BAR", "The bar is closed. Chairs on tables.", "full") is None
    assert crowd_in("BAR", "She empties a glass.", "full") == "full"
