"""Acts without a motion keep their words and are flagged; a motion is taken only with what it needs."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]


def motions(reading: Reading) -> list[str]:
    return [deed.motion for unit in reading.units for deed in unit.deeds]


def test_an_act_without_a_motion_is_flagged_with_its_words(read_scene: Read) -> None:
    reading = read_scene("NORA (30) yodels. NORA embalms the parrot, smiling.")
    (flag,) = [flag for flag in reading.flags if flag.topic == "act"]
    assert flag.choice == "none"
    assert "“embalms the parrot”" in flag.reason
    assert reading.screenplay.text[flag.start : flag.end] == "embalms the parrot"


def test_the_nearest_motion_stands_for_an_act_and_is_flagged(read_scene: Read) -> None:
    reading = read_scene("NORA (30) vacuums the rug.")
    assert motions(reading) == ["clean"]
    assert [flag.choice for flag in reading.flags if flag.topic == "act"] == ["clean"]


@pytest.mark.parametrize("inward", ["NORA (30) knows the way.", "NORA (30) is tired.", "NORA (30) owns a boat."])
def test_what_nobody_sees_is_no_act(read_scene: Read, inward: str) -> None:
    assert not [flag for flag in read_scene(inward).flags if flag.topic == "act"]


@pytest.mark.parametrize(
    "line",
    [
        "NORA (30) takes the question seriously.",
        "NORA (30) shifts in her seat.",
        "NORA (30). Fingers through the wire.",
        "NORA (30). Knees everywhere. Elbows, too.",
        "NORA (30), built like a barn, a bit of a mystery.",
        "NORA (30). Steel-capped boots arrive.",
    ],
)
def test_a_motion_is_taken_only_with_what_it_needs(read_scene: Read, line: str) -> None:
    assert motions(read_scene(line)) == []


def test_a_thing_that_moves_goes_on_moving(read_scene: Read) -> None:
    reading = read_scene("NORA (30) sits. A coin drops. Rolls. Stops against the wall.")
    assert motions(reading) == ["sit"]


def test_brackets_tell_acts_in_any_form_of_the_verb(read_scene: Read) -> None:
    reading = read_scene("NORA (30) waits.\n\nNORA\n(folds the letter and stands)\nNo.\n\nNORA\n(beat)\nYes.")
    assert motions(reading) == ["stand", "fold", "stand", "talk", "talk"]
