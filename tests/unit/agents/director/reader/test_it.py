"""Which thing ``it`` and ``its`` mean, and the pronouns of an introduction."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]
PEOPLE = "JOE (40, a man) sits. KATE (35, a woman) stands.\n\n"


def meant(reading: Reading, word: str) -> list[tuple[str, ...]]:
    return [who for _, said, who in reading.pronouns if said.lower() == word]


@pytest.mark.parametrize(
    ("action", "things"),
    [
        ("Joe takes a tin from the crate and opens it.", ["tin"]),
        ("Kate crosses to the desk, drops an envelope on it and sits. Joe slits it open.", ["desk", "envelope"]),
        ("Kate lifts the letter off the table. She opens the stove and throws it in.", ["letter"]),
        ("Joe hauls the boat up the beach until it rests against a boulder.", ["boat"]),
        ("Joe fills a bowl with soup. He gives it to Kate. She lifts it.", ["bowl", "bowl"]),
        ("A radio on his knees, Joe waits. Kate stares at it.", ["radio"]),
        ("Joe reads a letter. He walks to the door and opens it.", ["door"]),
    ],
)
def test_it_is_what_was_handled_and_not_where_it_was(action: str, things: list[str], read_scene: Read) -> None:
    assert meant(read_scene(PEOPLE + action), "it") == [(thing,) for thing in things]


def test_its_part_belongs_to_what_does_something(read_scene: Read) -> None:
    assert meant(read_scene(PEOPLE + "The ladder leans on the wall, a bag on its lowest rung."), "its") == [("ladder",)]
    dog = read_scene(PEOPLE + "A DOG trots in and sniffs the crate. Joe kneels and takes its paw.")
    assert meant(dog, "its") == [("dog",)]


def test_the_pronouns_of_an_introduction_are_whoever_is_introduced(read_scene: Read) -> None:
    reading = read_scene("TEO (33, sunburned, a bag over his shoulder) meets KATE (35, a scarf round her neck).")
    assert meant(reading, "his") == [("teo",)]
    assert meant(reading, "her") == [("kate",)]
    assert next(person.gender for person in reading.people if person.id == "teo") == "male"


def test_kin_in_an_introduction_is_somebody_elses(read_scene: Read) -> None:
    reading = read_scene("KATE (35, a woman) waits. JOE (40, her brother) enters.")
    assert meant(reading, "her") == [("kate",)]
