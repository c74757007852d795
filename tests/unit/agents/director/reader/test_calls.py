"""Telephone calls: a phone at the ear from picking it up until hanging up, at both ends of an intercut."""

from __future__ import annotations

import pytest

from conftest import Read
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

INTERCUT = """INT. KITCHEN - NIGHT

The phone rings. JO (30) answers it.

JO
Hello?

SAM (V.O.)
It's me.

JO
Where are you?

INTERCUT - KITCHEN / OFFICE

SAM (40) sits at a desk. A GUARD stands at the door.

SAM
At work.

Jo walks to the window.

SAM
(to the guard)
Two minutes.

Sam hangs up.

GUARD
Time.

INT. KITCHEN - NIGHT

Jo smiles.
"""


def in_call(reading: Reading, number: int) -> set[str]:
    """Return who has a phone at the ear after a unit, counted from the end if negative."""
    going: dict[tuple[int, str], str] = {}
    last = reading.units.index(reading.units[number])
    for unit in reading.units[: last + 1]:
        going |= {(unit.scene, person): motion for person, motion in unit.activities.items()}
    scene = reading.units[last].scene
    return {person for (where, person), motion in going.items() if where == scene and motion == "phone"}


def test_both_ends_of_an_intercut_hold_a_phone_until_they_hang_up() -> None:
    reading = read_script(read(INTERCUT))
    for unit in reading.units:
        number = reading.units.index(unit)
        told = " ".join(unit.text.split())
        if told in ("Where are you?", "Jo walks to the window.", "Jo smiles."):
            assert in_call(reading, number) == {"jo"} and unit.held["jo"]
        if told in ("At work.", "Two minutes."):
            assert in_call(reading, number) == {"sam"} and unit.held["sam"]
        if told in ("Sam hangs up.", "Time."):
            assert "sam" not in in_call(reading, number)


def test_the_far_end_is_heard_and_not_there() -> None:
    unit = next(unit for unit in read_script(read(INTERCUT)).units if unit.text == "It's me.")
    assert unit.off_screen and unit.on_stage == ["jo"]


def test_words_into_a_phone_are_for_nobody_in_the_room_unless_told() -> None:
    units = {unit.text: unit for unit in read_script(read(INTERCUT)).units}
    assert units["At work."].to is None
    assert units["Two minutes."].to == "guard"
    assert units["Time."].to == "sam"


@pytest.mark.parametrize(
    "does",
    [
        "is on the phone", "picks up the receiver", "dials a number", "takes the call", "talks into the phone",
        "sits, a phone pressed to her ear", "makes a call", "cradles the phone between ear and shoulder",
    ],
)  # fmt: skip
def test_a_call_begins(read_scene: Read, does: str) -> None:
    reading = read_scene(f"JO {does}. She paces. She sits down at the table.")
    assert in_call(reading, -1) == {"jo"} and reading.units[-1].held["jo"]


@pytest.mark.parametrize("does", ["picks it up", "picks up", "answers", "answers it and nods"])
def test_a_ringing_phone_is_answered_with_few_words(read_scene: Read, does: str) -> None:
    assert in_call(read_scene(f"The phone rings. JO {does}."), -1) == {"jo"}
    assert not in_call(read_scene(f"A dog barks. JO {does}."), -1)


@pytest.mark.parametrize("does", ["picks up a cup", "answers the door", "looks at her phone", "hangs up her coat"])
def test_other_deeds_are_no_call(read_scene: Read, does: str) -> None:
    assert not in_call(read_scene(f"The phone rings. JO {does}."), -1)


@pytest.mark.parametrize(
    "does", ["hangs up", "puts the phone down", "slams down the receiver", "ends the call", "pockets her phone"]
)
def test_a_call_ends(read_scene: Read, does: str) -> None:
    assert not in_call(read_scene(f"JO is on the phone. She {does}. She smiles."), -1)


def test_a_phone_is_what_the_age_of_the_story_has(read_scene: Read) -> None:
    page = "INT. HOTEL ROOM - NIGHT\n\n{}JO answers the phone.\n"
    old = read_script(read(page.format('SUPER: "BERLIN, 1938"\n\n'))).units[-1]
    new = read_script(read(page.format(""))).units[-1]
    assert (old.held["jo"], new.held["jo"]) == (["receiver"], ["phone"])


def test_who_is_seen_at_another_place_has_hung_up() -> None:
    page = "INT. HALL - DAY\n\nJO is on the phone.\n\nEXT. BEACH - LATER\n\nJo swims.\n"
    assert not in_call(read_script(read(page)), -1)


def test_what_is_said_in_a_call_is_talk_with_the_phone_at_the_ear() -> None:
    unit = next(unit for unit in read_script(read(INTERCUT)).units if unit.text == "At work.")
    assert [(deed.actor, deed.motion) for deed in unit.deeds] == [("sam", "talk")]


@pytest.mark.parametrize(
    ("told", "answered"),
    [
        ("The phone on the wall rings. Jo crosses to the wall and answers it.", ("phone", "phone")),
        ("The phone rings. Jo crosses the room and answers.", ("phone", "phone")),
        ("Somebody knocks at the door. Jo answers it.", ("open", "door")),
        ("Jo sighs. She answers.", ("talk", None)),
    ],
)
def test_what_is_answered_is_picked_up_opened_or_spoken_to(
    told: str, answered: tuple[str, str | None], read_scene: Read
) -> None:
    reading = read_scene(f"JO (30) sits in a chair.\n\n{told}\n")
    deeds = [deed for unit in reading.units for deed in unit.deeds if deed.verb == "answer"]
    assert [(deed.motion, deed.target) for deed in deeds] == [answered]
