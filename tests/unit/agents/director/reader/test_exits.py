"""Who is still there after a sentence: exits by one's own feet, by others', and people found gone."""

import pytest

from conftest import Read

LEAVING = [
    "Bob slips out the back door.",
    "Bob hurries from the room.",
    "Anna watches Bob go.",
    "Anna pushes Bob out of the room.",
    "Anna throws Bob out.",
    "Anna sends Bob upstairs.",
    "Anna dismisses Bob with a wave.",
    "Bob steps out into the hall.",
    "Bob returns to the cellar.",
    "Bob climbs out of the window.",
    "Bob runs out of sight.",
    "Bob is dragged off.",
    "Anna shuts the door behind Bob.",
    "Anna is alone again.",
]
STAYING = [
    "Bob leaves the window.",
    "Bob leaves the keys on the table.",
    "Bob gets out of the chair.",
    "Bob walks to the door.",
    "Anna pushes Bob into the chair.",
    "Bob goes to the table.",
    "Anna is alone with Bob.",
    "Anna locks the door behind her.",
]


def present(read_scene: Read, action: str) -> set[str]:
    reading = read_scene(f"ANNA (30) and BOB (40) are here.\n\n{action}\n\nThe clock ticks.")
    return set(reading.units[-1].on_stage)


@pytest.mark.parametrize("action", LEAVING)
def test_who_goes_or_is_sent_away_is_gone(read_scene: Read, action: str) -> None:
    assert present(read_scene, action) == {"anna"}


@pytest.mark.parametrize("action", STAYING)
def test_who_only_moves_about_stays(read_scene: Read, action: str) -> None:
    assert present(read_scene, action) == {"anna", "bob"}


def test_who_follows_somebody_out_goes_too(read_scene: Read) -> None:
    assert present(read_scene, "Bob goes out. Anna follows.") == set()
    assert present(read_scene, "Bob drags Anna out of the room.") == set()


def test_a_door_that_closes_behind_who_came_in_sends_nobody_off(read_scene: Read) -> None:
    assert "carl" in present(read_scene, "CARL (50) enters. The door closes behind him.")


@pytest.mark.parametrize(
    "action",
    ["Anna thinks of CARL.", "No sign of CARL.", "Anna reads a letter from CARL.", "Anna looks around for CARL."],
)
def test_who_is_only_thought_of_is_not_there(read_scene: Read, action: str) -> None:
    reading = read_scene(f"CARL (50) waits.\n\nINT. HALL - DAY\n\nANNA (30) and BOB (40) are here.\n\n{action}")
    assert "carl" not in reading.units[-1].on_stage


def test_who_enters_may_be_told_as_on_the_stage(read_scene: Read) -> None:
    reading = read_scene("ANNA (30) sits. CARL (50) waits outside.\n\nEnter CARL.\n\nExit CARL.\n\nThe clock ticks.")
    assert [(deed.actor, deed.motion) for deed in reading.units[-2].deeds] == [("carl", "walk")]
    assert reading.units[-1].on_stage == ["anna"]


@pytest.mark.parametrize(
    "line", ["Otto backs away.", "Otto passes out.", "Otto goes on to explain it.", "Otto goes for the gun."]
)
def test_who_steps_back_or_goes_on_stays(read_scene: Read, line: str) -> None:
    reading = read_scene(f"OTTO (50) and NORA (40) wait. {line}\n\nNora sighs.")
    assert reading.units[-1].on_stage == ["otto", "nora"]
