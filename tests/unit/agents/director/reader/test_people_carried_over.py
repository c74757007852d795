"""People of the scene before come along into a scene that names nobody."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]
PEOPLE = "JOE (40, a man) sits. KATE (35, a woman) stands. ANN (30, a woman) waves.\n\nEXT. PORCH - DAWN\n\n"


@pytest.mark.parametrize(
    ("opening", "there"),
    [
        ("They wait.", ["joe", "kate", "ann"]),
        ("Rain. He waits.", ["joe"]),
        ("The two women walk away.", ["kate", "ann"]),
        ("Joe watches the two women walk away.", ["joe", "kate", "ann"]),
        ("The three women walk away.", []),
        ("Joe waits. They say nothing.", ["joe"]),
        ("Dust. A chair.", []),
    ],
)
def test_a_scene_that_names_nobody_takes_people_of_the_scene_before(
    read_scene: Read, opening: str, there: list[str]
) -> None:
    reading = read_scene(PEOPLE + opening)
    assert sorted(reading.units[-1].on_stage) == sorted(there)


def test_who_lies_on_the_floor_or_has_left_does_not_come_along(read_scene: Read) -> None:
    down = PEOPLE.replace("Ann", "ANN").replace(" waves.", " waves. Joe falls down.")
    assert read_scene(down + "They run.").units[-1].on_stage == ["kate", "ann"]
    left = PEOPLE.replace(" waves.", " waves. Joe leaves.")
    assert read_scene(left + "They run.").units[-1].on_stage == ["kate", "ann"]
