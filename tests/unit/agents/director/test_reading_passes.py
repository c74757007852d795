"""Several people with a thing each; motions by any of their names."""

from __future__ import annotations

import pytest
from handmade import Script

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.memory.graph import Storyboard
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


@pytest.mark.parametrize(
    ("word", "key"), [("stand_up", "rise"), ("play_music", "play_piano"), ("clean", "wipe"), ("wear", "dress")]
)
def test_a_reading_may_name_a_motion_by_its_key(word: str, key: str) -> None:
    def board(motion: str) -> Storyboard:
        script = Script("Ann", things=("coat",)).action("Ann sits.", ("ann", "sit"))
        acts = {"ann": motion}
        return storyboard(script.action("Ann goes on.", ("ann", motion, None, "coat"), activities=acts).read())

    assert board(word) == board(key)
