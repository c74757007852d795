"""The critic of a cut: what it says of a storyboard that a model of language may propose."""

from __future__ import annotations

import pytest

from storyblender.agents.director.director import RulesShotDirector, ShotDirectorCritic, ShotDirectorView
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.settings import DirectorSettings
from storyblender.screenplay.source import read

SCRIPT = "INT. ROOM - DAY\n\nANN (30) sits at the table with a cup.\n\nANN\nHello.\n"


def test_a_kind_that_is_no_prop_is_a_fault() -> None:
    view = ShotDirectorView(read_script(read(SCRIPT, "fountain")), DirectorSettings())
    board, critic = RulesShotDirector().propose(view), ShotDirectorCritic()
    assert not critic.judge(board, view).faults
    sheet = tuple(
        asset.model_copy(update={"kind": "zeppelin"}) if asset.asset_id == "cup" else asset
        for asset in board.asset_sheet
    )
    (fault,) = critic.judge(board.model_copy(update={"asset_sheet": sheet}), view).faults
    assert (fault.kind, fault.subject) == ("vocabulary", "cup")


@pytest.mark.parametrize("wrong", [{"kit": ""}, {"kit": "nowhere"}, {"set_options": ("palms",)}])
def test_a_set_that_does_not_exist_is_never_accepted(wrong: dict[str, object]) -> None:
    view = ShotDirectorView(read_script(read(SCRIPT, "fountain")), DirectorSettings())
    board = RulesShotDirector().propose(view)
    (scene,) = board.scene_details
    scene = scene.model_copy(update={"setup": scene.setup.model_copy(update=wrong)})
    critique = ShotDirectorCritic().judge(board.model_copy(update={"scene_details": (scene,)}), view)
    assert [(fault.kind, fault.subject) for fault in critique.faults] == [("vocabulary", "SC010")]
    assert critique.score == 1
