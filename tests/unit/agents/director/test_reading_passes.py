"""Several people with a thing each."""

from __future__ import annotations

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.screenplay.source import read


@pytest.mark.parametrize(
    ("action", "props"),
    [
        ("Two SOLDIERS drop their spears.", ["spear", "spear_2"]),
        ("ANN (30) and JOE (40) pick up their cups.", ["cup", "cup_2"]),
        ("Two SOLDIERS drop a spear.", ["spear", "spear"]),
        ("ANN (30) drops her spears.", ["spear"]),
    ],
)
def test_each_has_one_where_the_word_is_plural(action: str, props: list[str]) -> None:
    board = storyboard(read_script(read(f"INT. HALL - DAY\n\n{action}\n", "fountain")))
    (shot,) = board.shot_details
    assert [each.prop_id for each in shot.character_actions] == props
    assert {each.asset_id for each in board.asset_sheet} >= set(props)
    assert set(board.scene_details[0].setup.asset_ids) >= set(props)
