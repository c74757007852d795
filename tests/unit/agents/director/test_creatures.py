"""Animals and robots are no people: they stand on the set as the catalog's, in the size the script gives them."""

from __future__ import annotations

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.creatures import compared_size
from storyblender.agents.director.reader import read_script
from storyblender.memory.asset_sheet import Asset
from storyblender.screenplay.source import read


def sheet_of(script: str, format: str = "fountain") -> dict[str, Asset]:
    assets = storyboard(read_script(read(script, format))).asset_sheet  # type: ignore[arg-type]
    return {asset.asset_id: asset for asset in assets}


def in_a_room(action: str) -> dict[str, Asset]:
    return sheet_of(f"INT. ROOM - DAY\n\nANN (30) sits.\n\n{action}\n")


@pytest.mark.parametrize(
    ("action", "id", "description", "kind"),
    [
        ("Behind her trots PIP, a dented robot the size of a goat.", "pip", "110 cm tall dented robot", "robot"),
        ("MULE, a squat robot, rolls in. Mule beeps.", "mule", "squat robot", "robot"),
        ("A white horse walks in. The horse neighs.", "horse", "white horse", "horse"),
        ("A parrot sits on the table.\n\nPARROT\nAhoy!\n\nThe parrot takes a nut.", "parrot", "parrot", "parrot"),
    ],
)
def test_animals_and_robots_are_the_catalogs(action: str, id: str, description: str, kind: str) -> None:
    asset = in_a_room(action)[id]
    assert (asset.asset_type, asset.tags[0], asset.description) == ("object", "animal", description)
    assert asset.kind == kind
    assert in_a_room(action)["ann"].kind is None


@pytest.mark.parametrize(
    ("action", "id"),
    [
        ("DESMOND FOX (61, silver hair) walks in.", "desmond_fox"),
        ("LOU (50s, hot dog, no expectations) walks in.", "lou"),
        ("RAT (40, a waistcoat) walks in. Rat bows.\n\nRAT\nHello.", "rat"),
        ("TOD, a fox in a green coat, walks in.\n\nTOD\nGood evening.", "tod"),
        ("A fox walks in.\n\nFOX\nTea?\n\nThe fox pours the tea.", "fox"),
        ("HEX, an android with a porcelain face, walks in. Hex bows.", "hex"),
    ],
)
def test_who_has_a_surname_or_clothes_or_uses_hands_is_cast(action: str, id: str) -> None:
    assert in_a_room(action)[id].asset_type == "character"


@pytest.mark.parametrize(
    ("action", "id", "species"),
    [
        ("BOLT, a dented robot, rolls in.\n\nBOLT\nGood morning.", "bolt", "robot"),
        ("ZUG, an alien in a red coat, walks in.", "zug", "alien"),
    ],
)
def test_a_robot_that_speaks_and_an_alien_are_cast_with_their_own_heads(action: str, id: str, species: str) -> None:
    look = in_a_room(action)[id].look
    assert look is not None and look.species == species


def test_an_animal_called_by_a_name_is_an_animal() -> None:
    sheet = sheet_of("Ann sat down. A black cat called Solomon lay on the table. Solomon yawned.\n", "prose")
    assert (sheet["solomon"].asset_type, sheet["solomon"].description) == ("object", "sleeping black cat")


@pytest.mark.parametrize(
    ("words", "size"),
    [
        ("a robot the size of a goat", "110 cm tall"),
        ("as big as a park bench", compared_size("the size of a park bench")),
        ("the size of a grudge", ""),
        ("a robot", ""),
    ],
)
def test_a_size_that_is_likened_to_something_known(words: str, size: str) -> None:
    assert compared_size(words) == size


def test_a_thing_has_the_size_it_is_likened_to() -> None:
    assert in_a_room("She picks up a diamond the size of a goat.")["diamond"].description == "110 cm tall diamond"


def test_a_thing_in_a_list_is_not_described_by_the_one_before() -> None:
    sheet = in_a_room("She looks at a lantern on a steel hook, stove, and a small, round table.")
    assert (sheet["stove"].description, sheet["table"].description) == ("stove", "small round table")
