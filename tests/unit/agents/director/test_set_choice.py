"""Kits, options, snow and crowds of scenes are decided by words or by a person; a place that comes again keeps them."""

from __future__ import annotations

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading, SceneReading
from storyblender.agents.director.set_choice import ChosenSet, SetChoice
from storyblender.catalog.sets import SETS
from storyblender.memory.vocabulary import Age, SceneType, Weather
from storyblender.screenplay.model import Screenplay
from storyblender.screenplay.source import read


def place(name: str, where: SceneType = "indoor", weather: Weather = "clear", heading: str = "") -> SceneReading:
    return SceneReading(id=1, heading=heading or name, place=name, scene_type=where, weather=weather)


def again(scene: SceneReading, number: int = 2, **fields: object) -> SceneReading:
    return SceneReading(**{**vars(scene), "id": number, "reference": 1, **fields})  # type: ignore[arg-type]


def chosen(
    *scenes: SceneReading, contents: str = "", summary: str = "", age: Age | None = None, action: tuple[str, ...] = ()
) -> list[ChosenSet]:
    sets = SetChoice(Reading(Screenplay(format="fountain", text=""), scenes=[*scenes], age=age), summary)
    words = [*action, *[""] * len(scenes)]
    return [sets.decide(scene, (), contents or scene.place, words[index]) for index, scene in enumerate(scenes)]


@pytest.mark.parametrize(
    ("scene", "contents", "option", "told"),
    [
        (place("beach", "outdoor"), "Beach with lighthouse.", "lighthouse", True),
        (place("beach", "outdoor"), "Beach.", "lighthouse", False),
        (place("beach", "outdoor"), "Tropical beach.", "palms", True),
        (place("forest", "outdoor", "snow"), "Forest.", "pines", True),
        (place("forest", "outdoor"), "Forest.", "pines", False),
        (place("spine corridor", heading="INT. SPINE CORRIDOR / INT. AIRLOCK"), "", "space", True),
        (place("hospital corridor", heading="INT. HOSPITAL CORRIDOR / INT. AIRLOCK"), "", "space", False),
        (place("corridor", heading="INT. CORRIDOR / INT. KITCHEN"), "", "space", False),
    ],
)
def test_options_are_chosen_by_the_words_of_the_place(
    scene: SceneReading, contents: str, option: str, told: bool
) -> None:
    (found,) = chosen(scene, contents=contents)
    assert option in SETS[found.kit].options and (option in found.set_options) is told


@pytest.mark.parametrize(("age", "frontier"), [("west", True), (None, False)])
def test_the_story_tells_the_street_of_a_frontier_town(age: Age | None, frontier: bool) -> None:
    story = "A dusty frontier street. The marshal faces the outlaw before the saloon."
    (street,) = chosen(place("main street", "outdoor"), summary=story, age=age)
    assert street.kit == "street" and ("frontier" in street.set_options) is frontier


def test_every_option_of_a_kit_has_its_words() -> None:
    for kit in SETS.values():
        for option in kit.options:
            (found,) = chosen(SceneReading(id=1, heading="", place="", kit=kit.key))
            assert found.kit == kit.key and option not in found.set_options


@pytest.mark.parametrize(
    ("scene", "snow"),
    [
        (place("yard", "outdoor", "snow"), True),
        (place("kitchen", weather="snow"), True),
        (place("snowy field", "outdoor"), True),
        (place("glacier", "outdoor"), True),
        (place("office"), False),
    ],
)
def test_snow_lies_where_it_falls_or_the_place_says_so(scene: SceneReading, snow: bool) -> None:
    assert chosen(scene)[0].snow is snow


def test_a_place_that_comes_again_keeps_its_set_and_its_crowd_but_not_its_snow() -> None:
    beach = place("beach", "outdoor", "snow")
    first, same, emptied, full = chosen(
        beach,
        again(beach, weather="clear", kit="forest", set_options=["pines"]),
        again(beach, 3),
        again(beach, 4, reference=3),
        contents="Beach with palms.",
        action=("Dozens of people watch.", "Ada waits.", "The beach is deserted.", "Ada waits."),
    )
    assert (first.kit, first.set_options, first.snow, first.crowd) == ("beach", ("palms",), True, "full")
    assert (same.kit, same.set_options, same.snow, same.crowd) == ("beach", ("palms",), False, "full")
    assert (emptied.crowd, full.crowd) == (None, None)


def test_what_a_person_names_counts_before_the_words() -> None:
    scene = place("snowy beach", "outdoor")
    scene.kit, scene.set_options, scene.snow, scene.crowd = "forest", ["palms", "cranes"], False, "none"
    (found,) = chosen(scene, action=("Dozens of people watch.",))
    assert found == ChosenSet("forest", ("palms",), False, None)


def test_every_scene_of_a_script_has_a_kit() -> None:
    reading = read_script(
        read("INT. ZORGBLAT - DAY\n\nAda waits.\n\nEXT. BLATZORG - NIGHT\n\nAda waits.\n", "fountain")
    )
    assert [found.kit for found in chosen(*reading.scenes)] == ["room", "open_ground"]
