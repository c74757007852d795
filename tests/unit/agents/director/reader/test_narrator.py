"""Stories told by one of their people, and people whose name is told late."""

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read


def story(*paragraphs: str) -> Reading:
    return read_script(read("\n\n".join(paragraphs)))


def deeds(reading: Reading) -> list[tuple[str, str, str | None]]:
    return [(deed.actor, deed.motion, deed.target) for unit in reading.units for deed in unit.deeds]


def test_who_says_i_is_on_stage_and_acts() -> None:
    reading = story(
        "I sat in the kitchen. Holmes gave me a letter.", '"Read it," he said.', "I shook my head. We stood up."
    )
    assert {person.id for person in reading.people} == {"narrator", "holmes"}
    found = deeds(reading)
    assert ("narrator", "sit", None) in found
    assert ("holmes", "give", "narrator") in found
    assert ("holmes", "talk", "narrator") in found
    assert ("narrator", "shake_head", None) in found
    assert {("narrator", "stand_up", None), ("holmes", "stand_up", None)} <= set(found)


def test_he_never_means_the_narrator() -> None:
    reading = story("Tom and I sat at the table in the kitchen. I poured the tea. He drank it and looked at my hands.")
    assert ("tom", "drink", "tea") in deeds(reading)
    assert ("narrator", "drink", "tea") not in deeds(reading)
    assert (("my", ("narrator",))) in [(word.lower(), who) for _, word, who in reading.pronouns]


def test_one_numeral_makes_no_narrator() -> None:
    assert "narrator" not in {person.id for person in story("Anna read Part I of the book in the kitchen.").people}


def test_the_narrator_has_the_name_a_friend_introduces_him_by() -> None:
    reading = story(
        "I stood by the fire with Holmes, and a lady entered the room.",
        '"This is my friend Dr. Watson," said Holmes. "Pray sit down, madam."',
        "I gave her a chair.",
    )
    narrator = next(person for person in reading.people if person.id == "narrator")
    assert "watson" in narrator.aliases
    assert ("narrator", "give", "lady") in deeds(reading)


def test_my_sister_is_who_is_named_right_after() -> None:
    reading = story("My sister drove the car and I slept. Colleen stopped at the motel. She yawned.")
    assert {person.id for person in reading.people} == {"narrator", "colleen"}


def test_a_man_is_who_soon_has_a_title() -> None:
    reading = story(
        "Anna stood in the office. After a while a man in an undershirt came in.", '"One night?" asked Mr. Patel.'
    )
    assert {person.id for person in reading.people} == {"anna", "mr_patel"}


def test_towns_motels_and_ships_are_nobody() -> None:
    reading = story("Nobody had spoken since Tulsa. Anna drove past the Starlite Motel and boarded the Albatross.")
    assert {person.id for person in reading.people} == {"anna"}


def test_a_boy_beside_somebody_is_somebody_else() -> None:
    reading = story("A deputy stood at the door, and next to him, wrapped in a blanket, a boy of ten. The boy nodded.")
    assert ("boy", "nod", None) in deeds(reading)


def test_who_raises_her_veil_after_a_line_has_said_it() -> None:
    reading = story(
        "Tom and a lady sat by the fire.",
        '"What is it?" asked Tom.',
        '"It is fear." She raised her veil as she spoke.',
        '"Of whom?"',
    )
    said = [unit.speaker for unit in reading.units if unit.kind == "dialogue"]
    assert said == ["tom", "lady", "tom"]


def test_something_in_the_hall_is_no_hall() -> None:
    assert deeds(story("Mira sat. In the hall something fell over.")) == [("mira", "sit", None)]


def test_after_where_he_told_her_it_is_still_she() -> None:
    found = deeds(story("Joel sat down. Mira found the tin where he told her to look, opened it and took a key."))
    assert {("mira", "open", "tin"), ("mira", "take", "key")} <= set(found)


def test_a_beam_of_light_hits_them_and_not_they() -> None:
    found = deeds(story("Tom and Anna opened the door, and a beam of light hit them in the eyes."))
    assert {motion for _, motion, _ in found} == {"open"}


def test_a_lady_dressed_in_black_rose() -> None:
    found = deeds(story("Tom sat. A lady dressed in black, who had been sitting by the window, rose as he spoke."))
    assert ("lady", "stand_up", None) in found
    assert not any(motion == "wear" for _, motion, _ in found)
