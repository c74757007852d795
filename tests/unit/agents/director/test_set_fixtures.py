"""What belongs to the set is no prop, whatever the reading calls it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.fixtures import head_of, is_fixture, is_piece, is_scenery
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Thing
from storyblender.agents.director.reading_file import read_reading, write_reading
from storyblender.catalog.fixtures import fixtures_called, named_pieces
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.scene_context import Environment
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
        ("bulletproof service window", False),
        ("tea hatch", False),
        ("hatch", True),
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


@pytest.mark.parametrize(
    ("thing", "built_in"),
    [
        (Thing("great_lens", "great lens", kind="set_piece"), True),
        (Thing("lamp", "lit great lens", kind="set_piece"), True),
        (Thing("lens", "lens", kind="prop"), False),
        (Thing("lantern", "lantern", kind="set_piece"), False),
    ],
)
def test_a_set_piece_under_the_name_of_a_piece_of_its_set_is_that_piece(thing: Thing, built_in: bool) -> None:
    near, far = named_pieces(plan_of(Environment(kit="lighthouse")))
    assert is_piece(thing, (*near, *far)) == built_in


def test_the_pieces_of_a_set_are_told_apart_by_reach() -> None:
    near, far = named_pieces(plan_of(Environment(kit="airfield")))
    assert "air stairs" in far and "air stairs" not in near


def test_a_piece_of_the_set_is_scenery_and_is_found_under_its_id(tmp_path: Path) -> None:
    script = read("INT. LAMP ROOM - NIGHT\n\nAda (40) looks at the lamp.\n", "fountain")
    plain = json.loads(write_reading(read_script(script)))
    plain["scenes"][0]["scene"]["kit"] = "lighthouse"
    plain["things"] = [{"id": "lamp", "name": "great lens", "kind": "set_piece"}]
    plain["units"][0]["unit"] |= {"things": ["lamp"], "gaze": {"ada": "lamp"}}
    file = tmp_path / "ada.json"
    file.write_text(json.dumps(plain))
    (scene,) = storyboard(read_reading(file, script)).scene_details
    assert scene.setup.scenery == ("lamp_lens",)
    plan = plan_of(Environment(kit="lighthouse"))
    assert fixtures_called(plan, "lamp_lens")[0].name.startswith("great_lens")


@pytest.mark.parametrize(("kit", "own"), [("barn", True), ("bridge", False)])
def test_a_rail_that_the_set_has_not_is_a_thing_of_its_own(kit: str, own: bool, tmp_path: Path) -> None:
    script = read("INT. HALL - NIGHT\n\nAda (40) leans on the rail.\n", "fountain")
    plain = json.loads(write_reading(read_script(script)))
    plain["scenes"][0]["scene"]["kit"] = kit
    plain["things"] = [{"id": "ring_rail", "name": "steel ring rail", "kind": "set_piece"}]
    plain["units"][0]["unit"] |= {"things": ["ring_rail"], "gaze": {"ada": "ring_rail"}}
    file = tmp_path / "ada.json"
    file.write_text(json.dumps(plain))
    board = storyboard(read_reading(file, script))
    assert ("ring_rail" in {asset.asset_id for asset in board.asset_sheet}) == own
