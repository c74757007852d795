"""The strips of EDIT as they were written against the strips as they are: the fewest edits of the cut."""

from __future__ import annotations

import random

from storyblender.edits.cut_changes import cut_changes
from storyblender.memory.blend_values import StripInEdit
from storyblender.memory.edits import ReorderEdit

NAMES = [f"SC010_SH{number:03d}" for number in range(10, 90, 10)]


def strip(name: str, start: int, **more: object) -> StripInEdit:
    return StripInEdit.model_validate({"name": name, "start": start, "frames": 24, "offset": 0, "muted": False, **more})


STRIPS = [strip(name, 1 + 24 * place) for place, name in enumerate(NAMES)]


def found(saved: list[StripInEdit]) -> list[tuple[str, str]]:
    return [(change.kind, change.subject) for change in cut_changes(STRIPS, saved)]


def test_each_kind_is_told_as_that_alone() -> None:
    first, second, *rest = STRIPS
    assert found(STRIPS) == []
    assert found([first, second.model_copy(update={"muted": True}), *rest]) == [("cut", NAMES[1])]
    assert found([first, *rest]) == [("cut", NAMES[1])]
    assert found([first, second.model_copy(update={"frames": 12}), *rest]) == [("cut", NAMES[1])]
    assert found([first, second.model_copy(update={"frames": 12, "offset": 12}), *rest]) == [("unknown", NAMES[1])]
    assert found([*STRIPS, strip("Titles", 900)]) == [("unknown", "EDIT")]


def test_moves_bring_any_order_about() -> None:
    chance = random.Random(5)
    for _ in range(200):
        wanted = list(NAMES)
        for _ in range(chance.randint(1, 4)):
            wanted.insert(chance.randrange(len(wanted)), wanted.pop(chance.randrange(len(wanted))))
        saved = [strip(name, place) for place, name in enumerate(wanted)]
        now = list(NAMES)
        for change in cut_changes(STRIPS, saved):
            [edit] = change.edits
            assert isinstance(edit, ReorderEdit)
            now.remove(edit.target)
            near = now.index(edit.before or edit.after or "")
            now.insert(near if edit.before else near + 1, edit.target)
        assert now == wanted
