"""A story in prose comes to its places in many ways, and most sentences that name a place do not leave for it."""

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.screenplay.source import read

START = "Anna sat in the parlour by the fire. Ben poured the tea."


def places(*paragraphs: str) -> list[str]:
    return [scene.place for scene in read_script(read("\n\n".join(paragraphs))).scenes]


@pytest.mark.parametrize(
    ("paragraph", "place"),
    [
        ("Anna goes through to the kitchen, where the blind is down. She hauls it up.", "kitchen"),
        ("The kitchen of the inn smelled of fish. Mary sat on the settle.", "kitchen"),
        ("Room nine smelled of chlorine. Anna dropped her bag on the bed.", "room nine"),
        ("Upstairs in the study, Ben is on his knees beside the desk.", "study"),
        ("Mrs. Lunt is still in the kitchen, rinsing a saucer, when they come.", "kitchen"),
        ("At a quarter to twelve Mr. Grey is standing in the hallway. Anna looks at him.", "hallway"),
        ("Twenty minutes later Ben was crawling through the tunnel with a candle.", "tunnel"),
        ("Nobody had ever found the tunnel. Half an hour later Ben was crawling through it.", "tunnel"),
        ("The path brought them out on a ledge high above the cave. Ben looked down.", "cave"),
        ("At sunrise Ben was waiting in Gannet Cove.", "gannet cove"),
        ("Out in the drive the cart stands empty. Ben looks at it.", "drive"),
        ("The ferry, a flat thing of planks, lay against the jetty. Ben stepped aboard.", "jetty"),
        ("That evening Ben sat close to the stove in the miller's hut. Anna slept.", "miller's hut"),
        ("They drove for an hour. In the office a fan was turning. Ben hit the bell.", "office"),
    ],
)
def test_a_story_comes_to_a_place(paragraph: str, place: str) -> None:
    assert places(START, paragraph) == ["parlour", place]


@pytest.mark.parametrize(
    "paragraph",
    [
        "They pulled a stranger into the parlour. He fell.",
        "Ben bent over the map. On the far side of the river somebody had begun to ring.",
        "Ben went into the kitchen and came back with a tray. Anna took it.",
        "Ben went out to the yard.",
        "The house was silent. Anna put down her cup.",
        "Anna walked over to the window. She opened it.",
        "The street was empty. Anna drew the curtain.",
        "Ben was standing by the door. He listened.",
        "At ten paces Ben stopped. Anna smiled.",
    ],
)
def test_a_story_stays_where_it_is(paragraph: str) -> None:
    assert places(START, paragraph) == ["parlour"]


def test_a_first_paragraph_that_comes_into_a_room_plays_there() -> None:
    opening = "Anna puts her shoulder to the door of her uncle's house. It gives, and she stumbles into the hallway."
    assert places(opening) == ["hallway"]


def test_the_place_somebody_owns_comes_before_the_river_beyond() -> None:
    opening = "It was hardly morning in the ferryman's hut when somebody rang on the far side of the river. Ben got up."
    assert places(opening) == ["ferryman's hut"]


@pytest.mark.parametrize(
    ("told", "time"),
    [
        ("It was long past dark when Henrik pushed open the door of the inn.", "night"),
        ("It was past nine when a girl came up the lane.", "night"),
        ("Long before dawn the only light in the street came from the bakery.", "dawn"),
        ("An hour before midnight Hester led the mule down to the cove.", "night"),
        ("Since noon it had rained. Hester sat in the kitchen.", "day"),
        ("Last night the wind had risen. Hester sat in the kitchen.", "day"),
        ("The kitchen was full of candlelight. Hester sat by the stove.", "night"),
        ("At ten in the morning Hester went down to the kitchen.", "morning"),
    ],
)
def test_a_story_tells_its_time_in_other_words(told: str, time: str) -> None:
    assert read_script(read(told, "prose")).scenes[0].time == time


@pytest.mark.parametrize(
    ("told", "rooms"),
    [
        (("Henrik pushed open the door of the inn.", "The taproom was low and brown. He sat down."), ["inn"]),
        (("Lund climbed to the corridor.", "He unlocked the door. The room was dark."), ["corridor", "room"]),
        (("Lund sat in the room.", "By the time he got down to the lobby, Anna was there."), ["room", "lobby"]),
        (("Bess sat in the kitchen.", "They walked through the field. At the mill the wheel stood still."),
         ["kitchen", "mill"]),
    ],
)  # fmt: skip
def test_a_room_is_told_of_or_come_to(told: tuple[str, ...], rooms: list[str]) -> None:
    assert places(*told) == rooms


@pytest.mark.parametrize(
    ("opening", "place"),
    [
        ("The bakery opened at four. Anna lit the oven, and on the wall hung a man in a space suit.", "bakery"),
        ("Mrs. Crabbe's parlour was too small for seven. Rain ran down the window.", "parlour"),
    ],
)
def test_a_story_begins_in_the_place_it_begins_with(opening: str, place: str) -> None:
    assert places(opening) == [place]


def test_a_throne_is_no_place() -> None:
    assert places(START, "Anna walked up to the throne, gathered her skirts and sat down. Ben hid.") == ["parlour"]
