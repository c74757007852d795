"""Short stories in the manner of a hundred years ago: who the visitor is, whose son, when the next morning is."""

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read


def story(*paragraphs: str) -> Reading:
    return read_script(read("\n\n".join(paragraphs)))


def test_the_next_morning_is_a_scene_of_its_own_in_the_same_place() -> None:
    reading = story(
        "Anna sat in the drawing-room at night and read a letter by the lamp.",
        "In the pale sun next morning the letter lay on the floor of the room.",
        "Anna stood up. They would meet the next day.",
    )
    assert [(s.place, s.scene_type, s.time) for s in reading.scenes] == [
        ("drawing-room", "indoor", "night"),
        ("drawing-room", "indoor", "morning"),
    ]
