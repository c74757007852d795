"""Action in capitals: nobody is named by them, and what is told is told as on any page."""

from __future__ import annotations

import re

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reader.capitals import in_sentence_case
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

SITCOM = """INT. LIVING ROOM - DAY
(Vernon, Lottie)

_VERNON_, SIXTIES, SITS ON THE SOFA READING A NEWSPAPER. _LOTTIE_, HIS WIFE, STANDS AT THE SIDEBOARD.

LOTTIE
(CHEERFUL) Your brother called.

LOTTIE CROSSES TO THE SOFA AND HANDS HIM A CUP. HE DOES NOT LOOK UP. _BOYD_ ENTERS WITH A BIRDCAGE.

VERNON
(RE: BIRDCAGE) No.

MRS. PLUM, 70, OPENS THE DOOR. A NUN IN DARK GLASSES ENTERS. "FRAGILE" IS WRITTEN ON HIS BOX.
"""
ORDINARY = """INT. GARAGE - NIGHT

Nadia lifts the hood of the van. RUFUS (40) holds the lamp.

THE ENGINE ROARS AND THE VAN LEAPS FORWARD. NADIA DIVES BEHIND THE WORKBENCH AND RUFUS DROPS THE LAMP.

CLOSE ON THE LAMP.

KA-CHUNK. KA-CHUNK.

RUFUS
Was that the red one?
"""


def deeds(reading: Reading) -> set[tuple[str, str, str | None]]:
    """Return who does what to whom on a page."""
    return {(deed.actor, deed.motion, deed.target) for unit in reading.units for deed in unit.deeds}


def test_only_people_are_cast_from_a_page_in_capitals() -> None:
    people = {person.id: person for person in read_script(read(SITCOM)).people}
    assert set(people) == {"vernon", "lottie", "boyd", "mrs_plum", "nun"}
    assert (people["mrs_plum"].age, people["vernon"].age) == ("70", "60s")


def test_a_page_in_capitals_tells_what_it_would_in_small_letters() -> None:
    found = deeds(read_script(read(SITCOM)))
    assert {("vernon", "sit", "sofa"), ("lottie", "walk", "sofa"), ("lottie", "give", "vernon")} <= found
    assert ("boyd", "walk", None) in found


@pytest.mark.parametrize("page", [SITCOM, ORDINARY])
def test_units_quote_the_page_as_it_is_written(page: str) -> None:
    script = read(page)
    told = in_sentence_case(script)
    assert len(told) == len(script.text) and told.lower() == script.text.lower() and told != script.text
    for unit in read_script(script).units:
        assert unit.text.split() == script.text[unit.start : unit.end].split()


def test_the_list_of_a_scenes_people_brings_nobody_in() -> None:
    first = read_script(read(SITCOM)).units[0]
    assert first.text.startswith("_VERNON_") and first.on_stage == ["vernon"]


def test_a_paragraph_in_capitals_on_an_ordinary_page_is_read_like_others() -> None:
    reading = read_script(read(ORDINARY))
    assert {person.id for person in reading.people} == {"nadia", "rufus"}
    assert {("nadia", "jump", "workbench"), ("rufus", "drop", "lamp")} <= deeds(reading)
    assert any(unit.camera and unit.camera.size for unit in reading.units)


def test_written_words_and_short_noises_keep_their_capitals() -> None:
    assert '"FRAGILE"' in in_sentence_case(read(SITCOM))
    assert "KA-CHUNK. KA-CHUNK." in in_sentence_case(read(ORDINARY))
    assert "CLOSE ON THE LAMP." in in_sentence_case(read(ORDINARY))


def test_sentences_begin_with_a_capital() -> None:
    told = in_sentence_case(read(SITCOM))
    assert re.search(r"He does not look up\. _BOYD_ enters with a birdcage\.", told)
