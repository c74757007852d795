"""A camera's subject is found by its id or whole name first, and a part of a thing is shown by the thing."""

from __future__ import annotations

from handmade import Script

from storyblender.agents.director.directions import NameFinder
from storyblender.agents.director.reading import Thing
from storyblender.agents.director.story_assets import StoryAssets


def test_an_id_or_a_whole_name_wins_over_a_last_word() -> None:
    reading = Script("Otis").action("Otis waits.").read()
    reading.things = [Thing("snow_moose", "snow moose"), Thing("moose", "moose"), Thing("lid", "red lid")]
    names = NameFinder(reading)
    assert names.find("moose, Otis") == ["moose", "otis"]
    assert names.find("snow moose") == ["snow_moose"]
    assert names.find("lid") == names.find("red lid") == ["lid"]
    assert names.find("the moose by the river") == ["moose"]


def test_a_part_that_stays_on_is_shown_by_its_whole() -> None:
    script = Script("Ann").action("Ann reads.", held={"ann": ["lid"]})
    script.reading.things = [
        Thing("laptop", "laptop"),
        Thing("screen", "screen", part_of="laptop"),
        Thing("message", "message", part_of="screen"),
        Thing("kettle", "kettle"),
        Thing("lid", "lid", part_of="kettle"),
    ]
    company = StoryAssets(script.read())
    assert company.visible_id("message") == "laptop" and "message" not in company.assets
    assert company.visible_id("lid") == "lid" and "lid" in company.assets, "somebody holds it: it comes off"
