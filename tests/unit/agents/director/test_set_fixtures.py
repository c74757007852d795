"""What belongs to the set is no prop, whatever the reading calls it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.fixtures import head_of, is_fixture, is_scenery
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Thing
from storyblender.agents.director.reading_file import read_reading, write_reading
from storyblender.catalog.sets import SETS
from storyblender.screenplay.source import read


@pytest.mark.parametrize(
    ("name", "fixture"),
    [
        ("front door of the inn", True),
        ("lounge window", True),
        ("steep hill", True),
        ("evening sky", True),
        ("town with many roofs", True),
        ("red kettle", False),
        ("house of cards", False),
        ("dining table", False),
        ("pair of boots", False),
        ("rowing boat", False),
    ],
)
def test_parts_of_the_set_land_and_weather_are_no_props(name: str, fixture: bool) -> None:
    assert is_fixture(Thing("it", name)) == fixture


@pytest.mark.parametrize(
    ("name", "place", "kit", "scenery"),
    [
        ("rearview mirror", "taxi", "car", True),
        ("gun", "taxi", "car", False),
        ("house", "old house", "room", True),
        ("doll house", "lounge", "room", False),
        ("house", "lindqvist house", "street", True),
        ("house", "lane", "country_road", False),
        ("judge's bench", "court", "courtroom", True),
        ("bench", "park", "park", False),
        ("suitcase", "", "street", False),
    ],
)
def test_the_place_itself_and_the_parts_of_its_set_are_scenery(name: str, place: str, kit: str, scenery: bool) -> None:
    assert is_scenery(name, place, SETS[kit]) == scenery


def test_the_noun_of_a_name_stands_before_what_it_is_of_or_with() -> None:
    assert [head_of(name) for name in ("Door of the Lamb", "old box with a lid", "")] == ["door", "box", ""]


def test_a_door_with_an_id_of_its_own_is_a_door_of_the_set(tmp_path: Path) -> None:
    script = read("INT. KITCHEN - DAY\n\nAda (40) opens the door.\n", "fountain")
    plain = json.loads(write_reading(read_script(script)))
    plain["things"] = [{"id": "kd", "name": "kitchen door", "kind": "set_piece"}]
    plain["units"][0]["unit"] |= {
        "things": ["kd"],
        "deeds": [{"actor": "ada", "motion": "open", "target": "kd"}],
        "spots": {"ada": {"relation": "at", "anchor_id": "kd"}},
    }
    file = tmp_path / "ada.json"
    file.write_text(json.dumps(plain))
    board = storyboard(read_reading(file, script))
    assert [asset.asset_id for asset in board.asset_sheet] == ["ada"]
    assert board.shot_details[0].character_actions[0].target_id == "kd_door"
