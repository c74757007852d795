"""Years are told from other numbers by the words around them."""

from __future__ import annotations

import pytest

from storyblender.catalog.years import years_in, years_said


@pytest.mark.parametrize(
    ("words", "years"),
    [
        ('SUPER: "PARIS, 1789"', [1789]),
        ("INT. ORPHEUM THEATRE - NIGHT (1931)", [1931]),
        ("INT. ASHDOWN PARK, BALLROOM. NIGHT. 1811.", [1811]),
        ("EXT. BATTLEFIELD - 1415", [1415]),
        ("November, 1926. A butler comes in.", [1926]),
        ("14 July 1789. A crowd.", [1789]),
        ("In 1942 the city sleeps.", [1942]),
        ("It is the summer of 1888, and raining.", [1888]),
        ("A dance hall of the 1940s.", [1940]),
        ("1917", [1917]),
    ],
)
def test_a_year_is_told(words: str, years: list[int]) -> None:
    assert years_in(words) == years


@pytest.mark.parametrize(
    "words",
    [
        "INT. HOTEL - ROOM 1408 - NIGHT",
        "1500 soldiers march by.",
        "They climb in 1200 feet of water.",
        "He lives at 1408 Main Street, Springfield.",
        "1234 Castle Road, Apartment 5",
        "The bill says $1300.",
        "A poster for a 1294 roadshow hangs there.",
        "Call 555-1492.",
        "A photo behind the glass. The harvest fair, 1969.",
        "The plaque says it was founded in 1881.",
    ],
)
def test_another_number_is_no_year(words: str) -> None:
    assert years_in(words) == []


def test_people_speak_of_other_years_than_theirs() -> None:
    assert years_said("Nobody has seen one since 1492. I was born in 1066!") == []
    assert years_said("Wake up, it's 1942!") == [1942]
