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
