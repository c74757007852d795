"""What a picture, a screen or a comparison shows is neither cast nor built."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]


def staged(reading: Reading) -> set[str]:
    return {person for unit in reading.units for person in unit.on_stage}


@pytest.mark.parametrize(
    ("action", "absent"),
    [
        ("Above the door hangs a portrait of SIR AMBROSE, with a lion at his feet.", {"sir_ambrose", "lion"}),
        ("On the big screen a helicopter circles; a dog runs over a bridge.", {"dog", "helicopter", "bridge"}),
        ("Four monitors hang on the wall. On the left one a fox runs past a statue.", {"fox", "statue"}),
        ("On monitor three a bucket falls off the table.", {"bucket"}),
        ("The wall shows the river: cars, a piano, a cow on a door. The cow turns its head.", {"cow", "piano", "car"}),
        ("He takes a photograph and puts it down. It shows a girl on a pony, holding a trumpet.", {"pony", "trumpet"}),
        ("An old television flickers: a rocket stands on a lawn and a horse waits.", {"rocket", "horse", "lawn"}),
        ("Below the skeleton of a whale stands a bench.", {"whale"}),
        ("He stares at the monitor. The picture flickers.", {"picture"}),
    ],
)  # fmt: skip
def test_what_is_only_shown_is_not_there(read_scene: Read, action: str, absent: set[str]) -> None:
    reading = read_scene(f"JOE (40, a man) sits.\n\n{action}")
    assert "joe" in staged(reading)
    assert not absent & (staged(reading) | {thing.name for thing in reading.things})


@pytest.mark.parametrize(
    ("action", "name"),
    [
        ("He puts the photograph of his wife on the desk.", "desk"),
        ("On the television stands a vase and a trumpet. He takes the trumpet.", "trumpet"),
        ("On the desk stand a portrait of the king and a clock. He takes the clock.", "clock"),
        ("He paints the door.", "door"),
        ("On the dresser stands a wedding photograph: a young man, a cow.", "wedding photograph"),
    ],
)
def test_where_a_picture_is_and_what_is_beside_it_is_there(read_scene: Read, action: str, name: str) -> None:
    assert name in {thing.name for thing in read_scene(f"JOE (40, a man) sits.\n\n{action}").things}


def test_who_was_on_a_screen_may_come_in(read_scene: Read) -> None:
    action = "On the monitor, Mia runs down a corridor. {}"
    intro = "JOE (40, a man) sits. MIA (30, a woman) stands up and leaves.\n\nINT. OTHER ROOM - DAY\n\nJoe sits. "
    assert "mia" not in read_scene(intro + action.format("Mia waves.")).units[-1].on_stage
    assert "mia" in read_scene(intro + action.format("Mia comes in.")).units[-1].on_stage


@pytest.mark.parametrize(
    ("action", "name"),
    [
        ("His leg goes down like a tree.", "tree"),
        ("He stands there, straight as a post.", "post"),
        ("He bites his nails.", "nail"),
        ("He glares through the bars.", "bar"),
        ("His leg is in plaster.", "plaster"),
        ("A white van stands beside a fence, its engine running.", "engine"),
        ("He grips the tree. He pulls its trunk to the door.", "trunk"),
        ("He tosses his partner the keys.", "partner"),
        ("He presses a button on the armrest.", "armrest"),
        ("He draws a tree on the whiteboard.", "tree"),
    ],
)
def test_comparisons_parts_and_people_are_no_things(read_scene: Read, action: str, name: str) -> None:
    assert name not in {thing.name for thing in read_scene(f"JOE (40, a man) sits.\n\n{action}").things}


@pytest.mark.parametrize("name", ["ticket desk", "corner booth", "water tower"])
def test_the_desk_is_the_ticket_desk_of_its_scene(read_scene: Read, name: str) -> None:
    head = name.split()[1]
    script = f"JOE (40, a man) sits at a {name}. He looks at the {head}."
    assert [thing.name for thing in read_scene(script).things] == [name]
    later = f"{script}\n\nINT. KITCHEN - DAY\n\nJoe sits at the {head}."
    assert [thing.name for thing in read_scene(later).things] == [name, head]
