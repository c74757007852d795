"""The critic of a cut: what it says of a storyboard that a model of language may propose."""

from __future__ import annotations

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
