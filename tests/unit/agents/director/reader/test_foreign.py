"""Pages in German, Spanish and French are read by tables: who does what to what, where."""

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

GERMAN = """INT. STUBE - TAG

ANTON (50) sitzt am Tisch und liest die Zeitung. Die Tür fliegt auf. BERTA (40) kommt herein, sie ist nass und müde.

BERTA
Guten Tag.

Anton steht auf. Er gibt Berta einen Brief. Ein HUND schläft unter dem Bett. Berta öffnet die Schuppentür und lacht.
"""
SPANISH = """INT. COCINA - NOCHE

LUCIA (30) está en la cocina con una botella en la mano. El tubo titila. Mira la puerta.

LUCIA
Hola.

Un CAMARERO entra con el vino y deja la botella sobre la mesa. Lucia se sienta en la silla y bebe. El camarero sale.
"""


def told(text: str) -> Reading:
    return read_script(read(text, "fountain"))


def deeds(reading: Reading) -> list[tuple[str, str, str | None]]:
    return [(d.actor, d.motion, d.target) for unit in reading.units for d in unit.deeds if d.motion != "talk"]


def test_german_is_read_by_its_verbs() -> None:
    reading = told(GERMAN)
    assert deeds(reading) == [
        ("anton", "sit", "table"), ("anton", "read", "newspaper"), ("berta", "walk", None),
        ("anton", "stand_up", None), ("anton", "give", "berta"), ("hund", "sleep", "bed"),
        ("berta", "open", "door"), ("berta", "laugh", None),
    ]  # fmt: skip
    assert {p.id: (p.kind, p.gender) for p in reading.people} == {
        "anton": ("human", "male"),
        "berta": ("human", "female"),
        "hund": ("animal", "unknown"),
    }
    assert reading.units[-1].held == {"berta": ["letter"]}
    assert next((r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations) == ("anton", "at", "table")


def test_spanish_leaves_its_subjects_out() -> None:
    reading = told(SPANISH)
    assert deeds(reading) == [
        ("lucia", "look", "door"), ("camarero", "walk", None), ("camarero", "put_down", "bottle"),
        ("lucia", "sit", "chair"), ("lucia", "drink", None), ("camarero", "walk", None),
    ]  # fmt: skip
    assert reading.units[-1].leaving == ["camarero"]


@pytest.mark.parametrize("text", [GERMAN, SPANISH])
def test_the_language_is_said(text: str) -> None:
    assert [flag.topic for flag in told(text).flags].count("language") == 1


def test_english_is_no_other_language() -> None:
    text = "INT. ROOM - DAY\n\nANTON (50) sits at the table and reads. The door flies open. He gives her a letter. " * 3
    assert not [flag for flag in told(text).flags if flag.topic == "language"]
