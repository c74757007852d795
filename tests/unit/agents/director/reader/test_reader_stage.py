"""Who is there, who has left, and who is only in a picture."""

from collections.abc import Callable

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

Read = Callable[[str], Reading]
PEOPLE = "JOE (40, a man) sits. KATE (35, a woman) stands.\n\n"


def told(reading: Reading) -> list[tuple[str, str]]:
    return [(deed.actor, deed.motion) for deed in reading.units[-1].deeds]


def test_what_is_done_before_the_name_is_done_by_whom_it_names(read_scene: Read) -> None:
    reading = read_scene(PEOPLE + "Kate waits.\n\nRushing around the room, Joe grabs a coat.")
    assert told(reading) == [("joe", "run"), ("joe", "take")]


def test_what_somebody_has_done_shows_still(read_scene: Read) -> None:
    assert told(read_scene(PEOPLE + "Joe has fallen asleep on his stool.")) == [("joe", "sleep")]


def test_who_goes_into_a_room_of_his_own_is_gone(read_scene: Read) -> None:
    for exit in ("Joe runs for his room.", "Joe walks into Kate's bedroom.", "Joe rushes into another room."):
        assert read_scene(PEOPLE + exit + "\n\nKate sighs.").units[-1].on_stage == ["kate"]
    assert read_scene(PEOPLE + "Joe heads for the door.\n\nKate sighs.").units[-1].on_stage == ["joe", "kate"]


def test_prose_changes_scene_with_the_hour_and_knows_numbered_rooms() -> None:
    reading = read_script(
        read(
            "On Sunday Dora walked into the day room with a bag. Mr. Bhatt was asleep in the armchair.\n\n"
            "Dora sat down beside him. A nurse called Ada came in and shook her head. Dora smiled.\n\n"
            "That night she tapped at the door of Room Nine in her dressing gown. Mr. Bhatt let her in.\n\n"
            "They sat on the bed and watched.\n\nIn the morning there was an egg. Mr. Bhatt picked it up.\n"
        )
    )
    assert [(scene.place, scene.time) for scene in reading.scenes] == [
        ("day room", "day"),
        ("room nine", "night"),
        ("room nine", "morning"),
    ]
    night = [unit for unit in reading.units if unit.scene == 1]
    assert night[0].on_stage == ["dora"], "the one the story has told most of"
    assert {deed.actor for deed in night[-1].deeds} == {"dora", "mr_bhatt"}
