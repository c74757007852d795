"""Which nouns are things of the story, and of what kind."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]


@pytest.mark.parametrize(
    ("action", "name", "kind"),
    [
        ("JOE (40, a man) climbs the fire escape.", "fire escape", "set_piece"),
        ("JOE (40, a man) waters the window box.", "window box", "set_piece"),
        ("JOE (40, a man) puts an egg cup on the table.", "egg cup", "prop"),
        ("JOE (40, a man) ties his bow tie.", "bow tie", "prop"),
    ],
)
def test_two_words_may_name_one_kind_of_thing(read_scene: Read, action: str, name: str, kind: str) -> None:
    assert (name, kind) in [(thing.name, thing.kind) for thing in read_scene(action).things]


@pytest.mark.parametrize(
    ("action", "name"),
    [
        ("JOE (40, a man) sits by the door, both hands around a tin mug.", "tin mug"),
        ("JOE (40, a man) reaches for the poker.", "poker"),
        ("JOE (40, a man) studies the empty needles.", "needle"),
        ("JOE (40, a man) sips coffee from a paper cup.", "paper cup"),
        ("JOE (40, a man) straddles a crate.", "crate"),
        ("JOE (40, a man) puts a thermos on the table.", "thermos"),
        ("JOE (40, a man) slides a shovel under the loaves and draws them out.", "loaf"),
        ("JOE (40, a man) straightens his hat and drops it.", "hat"),
        ("JOE (40, a man) drags a wooden chest across the sand.", "wooden chest"),
        ("JOE (40, a man) pulls a memory stick out of its side.", "memory stick"),
    ],
)
def test_what_somebody_has_to_do_with_is_a_prop(read_scene: Read, action: str, name: str) -> None:
    assert (name, "prop") in [(thing.name, thing.kind) for thing in read_scene(action).things]


@pytest.mark.parametrize(
    "action",
    [
        "JOE (40, a man) straightens his tie.",
        "JOE (40, a man) roars like a lion with a megaphone. Headlights sweep the wall.",
        "JOE (40, a man) slides into the black water.",
        "JOE (40, a man) sits down on the last rung.",
        "JOE (40, a man) had no wool.",
    ],
)
def test_parts_liquids_and_clothes_only_worn_are_no_props(read_scene: Read, action: str) -> None:
    assert not {"tie", "headlight", "water", "rung", "wool"} & {thing.name for thing in read_scene(action).things}


@pytest.mark.parametrize(
    ("action", "kind"),
    [
        ("JOE (40, a man) sits on a stool.", "set_piece"),
        ("JOE (40, a man) pushes a stool towards her.", "prop"),
        ("JOE (40, a man) puts down the stool.", "prop"),
        ("On the sledge, a stool. JOE (40, a man) sits on the floor. A stool stands on the table.", "prop"),
    ],
)
def test_furniture_that_is_handled_or_borne_is_a_prop(read_scene: Read, action: str, kind: str) -> None:
    assert ("stool", kind) in [(thing.name, thing.kind) for thing in read_scene(action).things]


def test_a_part_is_no_prop_but_what_it_is_done_to(read_scene: Read) -> None:
    reading = read_scene("JOE (40, a man) lifts the lid, takes hold of the rope and lets go of it.")
    assert [thing.name for thing in reading.things] == ["rope"]
    assert reading.units[0].deeds[0].target == "lid"


@pytest.mark.parametrize(
    ("action", "name"),
    [("A bell hangs over the door.", "bell"), ("The telephone on the wall rings.", "telephone")],
)
def test_what_is_fixed_to_a_wall_belongs_to_the_set(read_scene: Read, action: str, name: str) -> None:
    assert (name, "set_piece") in [(thing.name, thing.kind) for thing in read_scene(action).things]


def test_a_direction_shows_the_thing_that_does_something(read_scene: Read) -> None:
    reading = read_scene("JOE (40, a man) sits. CRANE UP as the van drives away.")
    assert [thing.name for thing in reading.things] == ["van"]


@pytest.mark.parametrize(
    ("action", "names"),
    [
        ("A barn owl sleeps on the table.", {"table"}),
        ("A red combine harvester stands beside the well.", {"combine harvester", "well"}),
    ],
)
def test_a_word_before_a_noun_is_no_thing_of_its_own(read_scene: Read, action: str, names: set[str]) -> None:
    assert {thing.name for thing in read_scene(f"JOE (40, a man) sits. {action}").things} == names


@pytest.mark.parametrize(
    ("action", "building", "there"),
    [
        ("In the kitchen of the lighthouse, JOE (40, a man) reads a letter.", "lighthouse", False),
        ("JOE (40, a man) crosses the hall of the castle.", "castle", False),
        ("JOE (40, a man) points at the lamp of the lighthouse.", "lighthouse", True),
    ],
)
def test_the_building_around_a_room_is_no_thing_in_it(
    read_scene: Read, action: str, building: str, there: bool
) -> None:
    assert (building in [thing.name for thing in read_scene(action).things]) is there
