"""Deeds have their target and prop: where a thing is put, taken from, or worked on."""

import pytest

from conftest import Read


@pytest.mark.parametrize(
    ("text", "motion", "target", "prop"),
    [
        ("NORA puts a cup on the table.", "put_down", "table", "cup"),
        ("NORA takes a rifle from the shelf.", "take", "shelf", "rifle"),
        ("NORA cuts the rope with a knife.", "cut", "rope", "knife"),
        ("NORA takes a coin out of her pocket.", "take", "coin", "coin"),
        ("NORA puts down the cup.", "put_down", "cup", "cup"),
    ],
)
def test_a_deed_has_both_ends(read_scene: Read, text: str, motion: str, target: str, prop: str) -> None:
    deed = next(deed for unit in read_scene(text).units for deed in unit.deeds if deed.motion == motion)
    assert (deed.target, deed.prop) == (target, prop)


def test_what_is_named_is_there_but_not_what_something_is_likened_to(read_scene: Read) -> None:
    reading = read_scene("A lantern hangs beside NORA. She looks at a stain the size of a plate.")
    assert "lantern" in {thing.id for thing in reading.things}
    assert "plate" not in {thing.id for thing in reading.things}
