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
    "Bob is gone.",
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
