"""Things that a direction shows, and things where an earlier scene put them."""

from __future__ import annotations

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader import read_script
from storyblender.memory.graph import Storyboard
from storyblender.screenplay.source import read

BEFORE = "INT. BAR - NIGHT\n\nANN (30) stands by the table. {}\n\nEXT. STREET - NIGHT\n\nAnn walks.{}\n\n"
AFTER = "INT. BAR - LATER\n\nCLOSE ON the ring, alone on the table. Ann picks it up and drops it.\n"


def board_of(script: str) -> Storyboard:
    return storyboard(read_script(read(script, "fountain")))


@pytest.mark.parametrize(
    ("before", "between", "lying"),
    [
        ("She puts a ring on the table.", "", {"ring": "table"}),
        ("She puts a ring on the table. She puts a letter beside the ring.", "", {"ring": "table", "letter": "table"}),
        ("She puts a ring on the table and a letter on the table. She takes the letter.", "", {"ring": "table"}),
        ("She puts a letter on the table.", " She burns the letter. She drops the letter.", {"ring": "table"}),
    ],
)
def test_what_was_put_down_and_not_taken_lies_there_still(before: str, between: str, lying: dict[str, str]) -> None:
    scene = board_of(BEFORE.format(before, between) + AFTER).scene_details[2]
    assert {relation.asset_id: relation.anchor_asset_id for relation in scene.setup.relations} == lying
    assert set(lying) <= set(scene.setup.asset_ids)


def test_a_direction_on_a_thing_shows_it_and_it_is_what_is_picked_up() -> None:
    insert, action = board_of(AFTER.replace("Ann", "ANN (30)")).shot_details
    assert (insert.camera_instruction.kind, insert.camera_instruction.focus_on_ids) == ("insert", ("ring",))
    assert [(each.motion, each.prop_id) for each in action.character_actions] == [("pick_up", "ring"), ("drop", "ring")]


def test_an_insert_of_what_is_in_a_hand_has_a_shot_of_its_own_before_what_is_done() -> None:
    script = "INT. BAR - NIGHT\n\nJOE (40, a man) waits.\n\nCLOSE ON the coin in his palm. ANN (30) walks in.\n"
    board = board_of(script)
    insert, action = board.shot_details[1:]
    assert (insert.camera_instruction.kind, insert.in_frame, insert.on_stage) == ("insert", ("joe",), ("joe",))
    assert [state.held for state in insert.states] == [("coin",)]
    assert [line.text for line in board.storyboard_outline[0].shots[2].lines] == ["ANN (30) walks in."]
    assert action.camera_instruction.focus_on_ids == ("ann",)
