"""What pronouns tell about somebody's gender."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]


@pytest.mark.parametrize(
    ("action", "gender"),
    [
        ("XQ (30) watches her in the mirror.", "unknown"),
        ("XQ (30) holds a phone to her ear.", "female"),
        ("XQ (30) shuts the door behind her.", "female"),
    ],
)
def test_whom_somebody_watches_is_somebody_else(read_scene: Read, action: str, gender: str) -> None:
    assert read_scene("KATE (35, a woman) sits.\n\n" + action).people[1].gender == gender
