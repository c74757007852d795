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
        ("Joe pours tea into a cup and gives it to Kate.", ["cup"]),
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


def test_so_many_of_them_are_people_and_a_pronoun(read_scene: Read) -> None:
    reading = read_scene(PEOPLE + "Joe picks up two boots. Neither of them speaks. The two of them leave.")
    assert [{*who} for who in meant(reading, "them")] == [{"joe", "kate"}, {"joe", "kate"}]


def test_what_is_put_between_them_is_put_between_whoever_does_it_and_another(read_scene: Read) -> None:
    reading = read_scene(PEOPLE + "Joe hugs Kate. She sets two glasses between them.")
    assert [{*who} for who in meant(reading, "them")] == [{"joe", "kate"}]


def test_an_animal_just_picked_up_is_him(read_scene: Read) -> None:
    reading = read_scene(PEOPLE + "A CAT sits by the stove. Kate picks up the cat and drops him on the bed.")
    assert meant(reading, "him") == [("cat",)]
