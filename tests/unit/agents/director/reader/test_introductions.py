"""How a screenplay brings somebody in: age in brackets, then the looks between commas; two names over a slash."""

from __future__ import annotations

import pytest

from storyblender.agents.director.reader.reader import read_script
from storyblender.screenplay.source import read


@pytest.mark.parametrize(
    ("intro", "outfit"),
    [
        ("ANNA (25), in a red coat, sits.", "red coat"),
        ("ANNA (25), a girl in a green dress, waters a rose.", "green dress"),
        ("ANNA (25), in jeans and boots, walks in.", "jeans boots"),
    ],
)
def test_looks_follow_the_age(intro: str, outfit: str) -> None:
    anna = read_script(read(f"INT. ROOM - DAY\n\n{intro}\n", "fountain")).people[0]
    assert anna.age == "25" and set(outfit.split()) <= set(" ".join(anna.outfit).split())


def test_an_intercut_names_two_people() -> None:
    script = "INT. BAR - DAY\n\nDAVE sits.\n\nINT. BED - DAY\n\nSUSAN sits.\n\nINTERCUT DAVE / SUSAN\n\nDAVE\nHello?\n"
    assert [person.name for person in read_script(read(script, "fountain")).people] == ["DAVE", "SUSAN"]


def test_a_flashback_is_a_scene_in_its_own_place_and_a_montage_is_nobody() -> None:
    script = """INT. GYM - DAY

MONTAGE - ROCCO TRAINS

-- Rocco (28) runs.

FLASHBACK - INT. LIVING ROOM - NIGHT (TEN YEARS EARLIER)

ROCCO sits.
"""
    reading = read_script(read(script, "fountain"))
    assert [(scene.place, scene.time) for scene in reading.scenes] == [("gym", "day"), ("living room", "night")]
    assert [person.name for person in reading.people] == ["ROCCO"]


@pytest.mark.parametrize("intro", ["STONE, a big man, carries a ladder.", "STONE (45) carries a ladder."])
def test_a_name_may_mean_a_thing(intro: str) -> None:
    reading = read_script(read(f"INT. ROOM - DAY\n\n{intro}\n\nThe LAMP, a gift of her father, falls.\n", "fountain"))
    assert "STONE" in [person.name for person in reading.people]
    assert "LAMP" not in [person.name for person in reading.people]


def test_a_script_without_capitals_has_its_people() -> None:
    script = "int. kitchen - day\n\nSAM\nHungry?\n\next. garden - later\n\nwind. sam brings two bowls.\n"
    reading = read_script(read(script, "fountain"))
    sam = reading.people[0]
    assert sam.name == "SAM" and reading.units[-1].on_stage == [sam.id]


@pytest.mark.parametrize(
    ("heading", "side"),
    [
        ("INT./EXT. FARMHOUSE PORCH - DAY", "outdoor"),
        ("INT/EXT. CAR - DAY", "indoor"),
        ("EXT./INT. KITCHEN - DAY", "outdoor"),
        ("INT. PORCH - DAY", "indoor"),
    ],
)
def test_a_place_on_both_sides_of_a_wall_is_where_its_name_is(heading: str, side: str) -> None:
    assert read_script(read(f"{heading}\n\nANNA waits.\n", "fountain")).scenes[0].scene_type == side


@pytest.mark.parametrize(
    ("action", "cast"),
    [
        ("A lame dog limps out of the arcade and lies down.", ["JOE", "dog"]),
        ("Somewhere a dog barks.", ["JOE"]),
        ("BERNARD, a goose of uncertain temper, dozes. Joe strokes the goose.", ["JOE", "BERNARD"]),
    ],
)
def test_an_animal_that_moves_about_is_there(action: str, cast: list[str]) -> None:
    reading = read_script(read(f"INT. ROOM - DAY\n\nJOE (40) sits. {action}\n", "fountain"))
    assert [person.name for person in reading.people] == cast


def _deeds(action: str, before: str = "") -> list[tuple[str, str]]:
    reading = read_script(read(f"INT. ROOM - DAY\n\nDOUGLAS (50) and PEEL (60) sit.\n\n{before}{action}\n", "fountain"))
    return [(deed.actor, deed.motion) for deed in reading.units[-1].deeds]


def test_a_group_has_as_many_as_are_counted_in_small_letters() -> None:
    reading = read_script(read("INT. ROOM - DAY\n\nTwo elderly WIDOWS wave. Some SAILORS sing.\n", "fountain"))
    assert [(person.name, person.count) for person in reading.people] == [("WIDOW", 2), ("SAILOR", 3)]


@pytest.mark.parametrize("worn", ["", " in a coat", " in cycling shorts", " with a cane"])
def test_somebody_told_of_and_then_named_between_commas_is_one(worn: str) -> None:
    """``An old man, GRAHAM (75), waves``: not the old man who is there already."""
    assert _deeds(f"An old man{worn}, GRAHAM (75), waves.") == [("graham", "wave")]


@pytest.mark.parametrize(
    ("action", "deed"),
    [
        ("In one of the chairs Peel sits shivering.", ("peel", "sit")),
        ("Peel drops onto his stomach.", ("peel", "lie_down")),
        ("Douglas throws up one hand.", ("douglas", "wave")),
        ("Douglas gets Peel by the collar.", ("douglas", "hold")),
    ],
)
def test_who_does_it(action: str, deed: tuple[str, str]) -> None:
    assert _deeds(action) == [deed]


def test_a_surname_without_a_title_is_whoever_has_none() -> None:
    before = "MRS. REYES (60) sits. DANIEL REYES (30) stands.\n\n"
    assert _deeds("Reyes waves.", before) == [("daniel_reyes", "wave")]
