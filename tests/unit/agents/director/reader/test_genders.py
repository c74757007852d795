"""What pronouns tell about somebody's gender."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]


@pytest.mark.parametrize(
    ("action", "gender"),
    [
        ("XQ (30) watches her in the mirror.", "unknown"),
        ("XQ (30) hands the bag to her.", "unknown"),
        ("XQ (30) holds a phone to her ear.", "female"),
        ("XQ (30) shuts the door behind her.", "female"),
    ],
)
def test_whom_somebody_watches_is_somebody_else(read_scene: Read, action: str, gender: str) -> None:
    assert read_scene("KATE (35, a woman) sits.\n\n" + action).people[1].gender == gender


@pytest.mark.parametrize(
    ("action", "gender"),
    [
        ("REGGIE (30) sits.", "male"),
        ("REGGIE, young and very pretty, sits.", "female"),
        ("REGGIE (30) shuts the door. She locks it.\n\nReggie sits. She opens her bag.", "female"),
        ("BRUNO (30) sits. She laughs.", "male"),
        ("BRUNO (30) sits. She laughs.\n\nBruno opens her bag. She shuts it.\n\nBruno sits. She yawns.", "female"),
        ("DOCTOR BRUNO, a pretty man, sits.", "male"),
    ],
)
def test_pronouns_and_looks_know_better_than_a_first_name(read_scene: Read, action: str, gender: str) -> None:
    assert read_scene(action).people[0].gender == gender
