"""Pages of a sitcom: underlined headings with the list of people below, action in capitals, double-spaced speeches."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from storyblender.screenplay.model import Element
from storyblender.screenplay.source import read

NETWORK = """_INT. VERNON'S LIVING ROOM - MORNING (DAY 1)_
(Vernon, Lottie)

_VERNON_, SIXTIES, SITS ON THE SOFA.

_SOUND: DOORBELL_

LOTTIE
(CHEERFUL) Your brother called
from the airport. (RE: DOOR) He's early.

VERNON HIDES BEHIND HIS NEWSPAPER WHILE LOTTIE CROSSES
AND OPENS THE DOOR.

VERNON
We could be dead.
"""
INDENTED = """                              ACT ONE

                              SCENE 1

INT. BOX OFFICE -- NIGHT
(GWEN, HECTOR, BOY)


(GWEN SITS BEHIND THE COUNTER.  HECTOR, 60,

THE WATCHMAN, SWEEPS.)

                              GWEN

                    It's your turn, and you know

                    (POINTING) it is.

(HECTOR SHAKES HIS HEAD.)

                              BOY

                    One for the lion, please.

                              HECTOR

                    What lion?

SFX:  A ROAR, OFF
"""
FLUSH_LEFT = """INT. LAUNDROMAT - NIGHT

MRS. PLUM, 70, SITS ON A BENCH, KNITTING A SCARF THAT REACHES THE FLOOR AND

GOES ON UNDER THE MACHINES.

OTIS

How long is that thing?

MRS. PLUM

Ask me again in the spring. It has a way

to go, young man.

(OTIS OPENS THE DRYER AND TAKES OUT A TINY RED COAT.)

OTIS

Somebody shrank.
"""


def told(elements: Sequence[Element], kind: str) -> list[str]:
    """Return the words of all elements of a kind, on one line each."""
    return [" ".join(element.text.split()) for element in elements if element.kind == kind]


def test_an_underlined_heading_opens_a_scene_and_names_who_is_in_it() -> None:
    elements = read(NETWORK).elements
    assert told(elements, "heading") == ["INT. VERNON'S LIVING ROOM - MORNING (DAY 1)"]
    assert told(elements, "cast") == ["Vernon", "Lottie"]
    assert told(elements, "sound") == ["SOUND: DOORBELL"]


def test_action_in_capitals_over_two_lines_is_no_cue() -> None:
    elements = read(NETWORK).elements
    assert told(elements, "cue") == ["LOTTIE", "VERNON"]
    assert any(words.endswith("AND OPENS THE DOOR.") for words in told(elements, "action"))


def test_a_bracket_in_capitals_inside_a_speech_is_not_spoken() -> None:
    elements = read(NETWORK).elements
    assert told(elements, "parenthetical") == ["CHEERFUL", "RE: DOOR"]
    assert told(elements, "dialogue")[:2] == ["Your brother called from the airport.", "He's early."]


def test_speeches_with_empty_lines_in_them_stay_whole_where_they_are_indented() -> None:
    elements = read(INDENTED).elements
    assert told(elements, "cue") == ["GWEN", "BOY", "HECTOR"]
    assert told(elements, "dialogue") == [
        "It's your turn, and you know", "it is.", "One for the lion, please.", "What lion?",
    ]  # fmt: skip
    assert told(elements, "action") == [
        "GWEN SITS BEHIND THE COUNTER. HECTOR, 60, THE WATCHMAN, SWEEPS.", "HECTOR SHAKES HIS HEAD.",
    ]  # fmt: skip
    assert told(elements, "section")[-1] == "SCENE 1"


def test_speeches_with_empty_lines_in_them_stay_whole_where_action_is_in_capitals() -> None:
    elements = read(FLUSH_LEFT).elements
    assert told(elements, "dialogue") == [
        "How long is that thing?", "Ask me again in the spring. It has a way to go, young man.", "Somebody shrank.",
    ]  # fmt: skip
    assert told(elements, "action")[0].endswith("THE FLOOR AND GOES ON UNDER THE MACHINES.")


@pytest.mark.parametrize("page", [NETWORK, INDENTED, FLUSH_LEFT])
def test_every_element_is_found_where_it_stands(page: str) -> None:
    script = read(page)
    for element in script.elements:
        written = " ".join(script.text[element.start : element.end].replace("_", "").split())
        assert all(word in written for word in element.text.split())


def test_ordinary_paragraphs_below_a_speech_stay_action() -> None:
    page = "INT. ROOM - DAY\n\nTOM\n\nHello.\n\nHe sits down.\n\nANN\n\nNo.\n\nShe leaves.\n"
    assert "He sits down." in told(read(page).elements, "action")


def test_brackets_that_name_nobody_who_speaks_are_action() -> None:
    page = "INT. ROOM - DAY\n(A clock, a bed, a chair)\n\nTOM\nHello.\n"
    assert told(read(page).elements, "cast") == []
