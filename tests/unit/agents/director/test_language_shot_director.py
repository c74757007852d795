"""The Director cutting by a model: its pictures become shots, the script's directions come first, rules fill gaps."""

from __future__ import annotations

import json
from typing import Any

import pytest
from tests.answering import Answering, Scripted

from storyblender.agents.director.director import RulesShotDirector, ShotDirectorCritic, ShotDirectorView
from storyblender.agents.director.language_shot_director import LanguageShotDirector
from storyblender.agents.director.reader.reader import read_script
from storyblender.agents.director.settings import DirectorSettings
from storyblender.errors import AnswerAwaited, NoAnswer
from storyblender.memory.base import shot_name
from storyblender.memory.camera_decision import CameraInstruction
from storyblender.memory.graph import Storyboard
from storyblender.ports import Answerer
from storyblender.reflection import Critique, Fault
from storyblender.screenplay.fountain import parse

SCRIPT = """INT. KITCHEN - DAY

ANA sits at the table. BEN walks in.

BEN
Where is the ring?

ANA
In the river.

CLOSE ON Ben.

He sits down.

EXT. RIVER - NIGHT

Ana waits on the bank.
"""
READING = read_script(parse(SCRIPT))
for _scene, _kit in zip(READING.scenes, ("kitchen", "open_ground"), strict=True):
    _scene.kit = _kit
VIEW = ShotDirectorView(READING, DirectorSettings())
ANA, BEN = (person.id for person in READING.people)
FIRST = [number for number, unit in enumerate(READING.units, start=1) if unit.scene == 0]
DIRECTED = next(number for number, unit in enumerate(READING.units, start=1) if unit.camera)


def director(answerer: Answerer) -> LanguageShotDirector:
    return LanguageShotDirector(answerer, RulesShotDirector())


def picture(first: int, last: int, **more: Any) -> dict[str, Any]:
    return {"first": first, "last": last, "kind": "single", "size": "MCU", "subjects": [ANA], **more}


def cut(*pictures: dict[str, Any]) -> Storyboard:
    """Return the storyboard in which the model made these pictures of the first scene."""
    board = director(Scripted([json.dumps({"pictures": pictures}), "{}"])).propose(VIEW)
    assert ShotDirectorCritic().judge(board, VIEW) == Critique(score=10.0)
    return board


def cameras(board: Storyboard, number: int) -> list[CameraInstruction]:
    """Return the cameras of the shots that cover a unit."""
    unit = READING.units[number - 1]
    return [
        detail.camera_instruction
        for scene in board.storyboard_outline
        for shot in scene.shots
        for detail in board.shot_details
        if (detail.scene_id, detail.shot_id) == (scene.scene_id, shot.shot_id)
        and any(line.span.start < unit.end and unit.start < line.span.end for line in shot.lines)
    ]


def test_each_picture_is_a_shot_with_the_camera_that_the_model_wants() -> None:
    board = cut(
        picture(1, 2, kind="establishing", size="FS", subjects=[ANA, BEN], angle="high angle"),
        picture(3, 3, kind="ots", size="MS", subjects=[BEN], who=ANA),
        picture(4, 4, size="CU", movement="push in"),
    )
    wide, over, close = (cameras(board, number)[0] for number in (1, 3, 4))
    assert (wide.kind, wide.size, wide.angle, cameras(board, 2)) == ("establishing", "FS", "high angle", [wide])
    assert (over.kind, over.size, over.focus_on_ids, over.over_id) == ("ots", "MS", (BEN,), ANA)
    assert (close.kind, close.size, close.movement) == ("single", "CU", "push in")
    assert {*(over.axis or ())} == {*(close.axis or ())} == {ANA, BEN}, "the camera stays on one side of the talkers"
    assert not any(each.explicit for each in (wide, over, close)), "it is no order of the script"


def test_a_direction_of_the_script_comes_first() -> None:
    board = cut(picture(DIRECTED, DIRECTED, size="EWS", subjects=[BEN]))
    (camera,) = cameras(board, DIRECTED)
    assert (camera.size, camera.explicit) == ("CU", True)


def test_without_pictures_the_rules_cut() -> None:
    assert cut() == RulesShotDirector().propose(VIEW)


def test_units_in_no_picture_are_covered_all_the_same() -> None:
    board = cut(picture(4, 4))
    assert all(cameras(board, number) for number in FIRST)


@pytest.mark.parametrize(
    ("pictures", "why"),
    [
        ([picture(1, 2), picture(2, 3)], "no unit is in two"),
        ([picture(3, 3), picture(1, 1)], "pictures go in order"),
        ([picture(1, 99)], "pictures go in order"),
        ([picture(3, 2)], "pictures go in order"),
        ([picture(1, 1, subjects=["ghost"])], "'ghost', which is neither"),
        ([picture(1, 1, subjects=[BEN])], "is not on stage then"),
        ([picture(3, 3, kind="ots")], "over whose shoulder"),
        ([picture(1, 1, size="HUGE")], "pictures[0].size"),
    ],
)
def test_what_cannot_be_is_sent_back_with_the_reason(pictures: list[dict[str, Any]], why: str) -> None:
    model = Scripted([json.dumps({"pictures": pictures}), "{}", "{}"])
    director(model).propose(VIEW)
    assert any(why in sentence for sentence in model.asked[1].feedback)


def test_panels_of_the_page_are_kept() -> None:
    reading = read_script(parse(SCRIPT))
    for number, unit in enumerate(reading.units, start=1):
        unit.picture = 7 if number <= 2 else None
    model = Scripted([json.dumps({"pictures": [picture(1, 1)]}), "{}", "{}"])
    director(model).propose(ShotDirectorView(reading, DirectorSettings()))
    assert any("panels of the page" in sentence for sentence in model.asked[1].feedback)


def test_only_the_scene_with_a_fault_is_cut_again() -> None:
    model = Answering(lambda view: {})
    policy = director(model)
    draft = policy.propose(VIEW)
    fault = Fault(kind="speaker", subject=shot_name(2, 1), message="nobody speaks there")
    assert policy.refine(draft, Critique.of((fault,)), VIEW) == draft
    assert [json.loads(request.view)["scene"]["number"] for request in model.asked] == [1, 2, 2]
    assert model.asked[2].feedback == (fault.message,)


def test_all_scenes_are_asked_about_before_the_run_stops() -> None:
    waiting = [AnswerAwaited("it waits", mend="answer it", names=(name,)) for name in ("one", "two")]
    with pytest.raises(AnswerAwaited) as stopped:
        director(Scripted(waiting)).propose(VIEW)
    assert stopped.value.names == ("one", "two")


def test_a_silent_model_leaves_the_cut_to_the_rules() -> None:
    with pytest.raises(NoAnswer):
        director(Scripted([NoAnswer("gone")])).propose(VIEW)
