"""Where people and things end up."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reading import Reading

Read = Callable[[str], Reading]
PEOPLE = "JOE (40, a man) sits. KATE (35, a woman) stands.\n\n"


@pytest.mark.parametrize(
    ("action", "relation"),
    [
        ("Joe backs against the wall.", ("joe", "against", "wall")),
        ("Joe drops onto Kate's stool.", ("joe", "on", "stool")),
        ("Joe turns at the door.", ("joe", "at", "door")),
        ("A newspaper slides to the floor.", ("newspaper", "on", "floor")),
        ("Joe carries a chair in and sets it down next to Kate.", ("chair", "next_to", "kate")),
        ("Joe stacks records in a crate.", ("record", "in", "crate")),
        ("Joe sits on the hood of a car.", ("joe", "on", "car")),
        ("Joe motions Kate behind the curtain.", ("kate", "behind", "curtain")),
        ("Joe grabs the gun lying on the table.", ("gun", "on", "table")),
        ("Propped against the fridge is a broom.", ("broom", "against", "fridge")),
        ("On the desk sit a typewriter and a telephone.", ("telephone", "on", "desk")),
        ("Joe puts a cup, a spoon and a plate on the table.", ("plate", "on", "table")),
    ],
)
def test_where_they_are_after_it(read_scene: Read, action: str, relation: tuple[str, str, str]) -> None:
    told = [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in read_scene(PEOPLE + action).relations]
    assert relation in told


def test_what_somebody_has_with_them_has_a_place_of_its_own(read_scene: Read) -> None:
    told = [(r.asset_id, r.kind) for _, r in read_scene(PEOPLE + "Kate sits with her feet on the desk.").relations]
    assert ("kate", "on") not in told
