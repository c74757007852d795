"""A reading may go to and fro between two places of one scene."""

from __future__ import annotations

from dataclasses import replace

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.reading_passes import order_scenes_by_units
from storyblender.screenplay.source import read

SCRIPT = """INT. SHED - DAY

Ada (40) sits on a chair. In the kitchen Tom (30) cooks soup. Ada laughs. Tom tastes the soup.
"""


def split(places: list[int]) -> Reading:
    reading = read_script(read(SCRIPT, "fountain"))
    kitchen = replace(reading.scenes[0], id=2, place="kitchen", kit="kitchen", place_kind="kitchen")
    units = [replace(unit, scene=place) for unit, place in zip(reading.units, places, strict=True)]
    return replace(reading, scenes=[reading.scenes[0], kitchen], units=units)


def test_units_in_two_places_are_cut_in_the_order_of_the_script() -> None:
    reading = order_scenes_by_units(split([0, 1, 0, 1]))
    assert [scene.id for scene in reading.scenes] == [1, 2, 3, 4]
    assert [scene.kit for scene in reading.scenes] == ["", "kitchen", "", "kitchen"]
    assert [scene.reference for scene in reading.scenes] == [None, None, 1, 2]
    assert [unit.scene for unit in reading.units] == [0, 1, 2, 3]
    assert all(a.end == b.start for a, b in zip(reading.scenes, reading.scenes[1:], strict=False))
    assert [shot.scene_id for shot in storyboard(reading).shot_details] == [1, 2, 3, 4]


@pytest.mark.parametrize("places", [[0, 0, 0, 0], [0, 0, 1, 1]])
def test_a_reading_in_order_stays_as_it_is(places: list[int]) -> None:
    reading = split(places)
    assert order_scenes_by_units(reading) is reading
