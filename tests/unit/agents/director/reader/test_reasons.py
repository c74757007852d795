"""Each fact of a reading has the rule that decided it, and words of the script."""

from pathlib import Path

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reader.reasons import Reason, reasons_of
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.rules import RULES, Ledger, using_ledger
from storyblender.screenplay.source import load, read

EXAMPLES = sorted((Path(__file__).parents[5] / "examples").glob("*.*t*"))
PAGE = "INT. KITCHEN - NIGHT\n\nADA (30) sits on a chair and opens a letter.\n\nADA\nNo.\n"


def told(text_or_path: str | Path) -> tuple[Reading, list[Reason]]:
    screenplay = load(text_or_path) if isinstance(text_or_path, Path) else read(text_or_path)
    with using_ledger(Ledger()) as ledger:
        reading = read_script(screenplay)
    return reading, reasons_of(reading, ledger)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_person_thing_and_deed_has_a_rule_and_words(path: Path) -> None:
    reading, reasons = told(path)
    length = len(reading.screenplay.text)
    assert all(0 <= each.start < each.end <= length and each.words for each in reasons)
    assert {each.rule for each in reasons} <= RULES
    known = {(each.kind, each.what.split()[0]) for each in reasons}
    assert {("person", person.id) for person in reading.people} <= known
    assert {("thing", thing.id) for thing in reading.things} <= known
    for number, unit in enumerate(reading.units, start=1):
        done = {tuple(each.what.split()[:2]) for each in reasons if (each.unit, each.kind) == (number, "deed")}
        assert {(deed.actor, deed.motion) for deed in unit.deeds} <= done


def test_the_words_are_those_the_fact_stands_on() -> None:
    _, reasons = told(PAGE)
    by = {(each.kind, each.what): each for each in reasons}
    assert by["person", "ada"].rule == "people.cue"
    assert by["person", "ada"].words == "ADA"
    assert by["look", "ada: 30"].words == "30"
    assert by["thing", "letter"].words.endswith("opens a letter")
    assert by["place", "1: kitchen, kitchen, indoor, night"].rule == "place.heading"
    assert by["speaker", "ada"].words == "No."


def test_an_age_in_brackets_makes_a_person_of_a_name_without_a_line() -> None:
    _, reasons = told("INT. ROOM - DAY\n\nQUORL (35) sits.\n")
    assert [each.rule for each in reasons if each.kind == "person"] == ["people.age_in_brackets"]


def test_without_a_rule_nothing_is_decided_by_it() -> None:
    with using_ledger(Ledger(off=frozenset({"people.age_in_brackets", "deeds.verb"}))):
        reading = read_script(read("INT. ROOM - DAY\n\nADA (30) sits.\n\nADA\nNo.\n"))
    assert [deed.motion for unit in reading.units for deed in unit.deeds] == ["talk"]


def test_a_ledger_changes_nothing_and_is_gone_afterwards() -> None:
    with using_ledger(Ledger()) as ledger:
        watched = read_script(read(PAGE))
    count = len(ledger.decisions)
    assert read_script(read(PAGE)) == watched
    assert len(ledger.decisions) == count > 0
