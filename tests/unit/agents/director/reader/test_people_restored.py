"""People left at a place are still there when the story returns to it."""

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

CELLAR = "INT. CELLAR - NIGHT\n\nNORA sits on a crate. TIBOR stands at the door.\n\n"
STREET = "EXT. STREET - NIGHT\n\nA dog barks.\n\n"


def last(text: str) -> tuple[Reading, set[str]]:
    reading = read_script(read(text))
    return reading, {*reading.units[-1].on_stage}


def test_they_are_there_before_anybody_names_them() -> None:
    reading, there = last(CELLAR + STREET + "INT. CELLAR - NIGHT\n\nThe lamp flickers.\n")
    assert there == {"nora", "tibor"}
    assert reading.units[-1].posture["nora"][0] == "sit"


def test_who_left_is_not() -> None:
    _, there = last(CELLAR + "Tibor leaves.\n\n" + STREET + "INT. CELLAR - NIGHT\n\nThe lamp flickers.\n")
    assert there == {"nora"}


def test_who_was_seen_elsewhere_is_not() -> None:
    _, there = last(CELLAR + STREET + "Tibor runs past.\n\nINT. CELLAR - NIGHT\n\nThe lamp flickers.\n")
    assert there == {"nora"}


@pytest.mark.parametrize("heading", ["INT. CELLAR - DAY", "INT. CELLAR - LATER", "INT. ATTIC - NIGHT"])
def test_at_another_hour_or_place_nobody_waits(heading: str) -> None:
    _, there = last(f"{CELLAR}{STREET}{heading}\n\nThe lamp flickers.\n")
    assert there == set()
