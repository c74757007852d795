"""Motions that a person adds, gives another time, or takes away: the rest of the shot is acted around them."""

from __future__ import annotations

from typing import Any

import pytest
from tests.every import every

from storyblender.edits.words import edits_of, motion_edit
from storyblender.errors import InputError
from storyblender.memory.shot_context import Cue
from storyblender.session import Session

SHOT, NEXT = "SC010_SH020", "SC010_SH030"


def does(person: str, shot: str = SHOT, **motions: dict[str, Any] | None) -> dict[str, Any]:
    return {"kind": "blocking", "shot": shot, "person": person, "marks": {"motions": motions}}


def apply(session: Session, *edits: dict[str, Any]) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    session.draw(applied)
    return applied.stale


def cues(session: Session, person: str, clip: str, shot: str = SHOT) -> list[Cue]:
    found = session.graph.shot(1, int(shot[8:]) // 10).cues
    return [cue for cue in found if (cue.asset_id, cue.clip) == (person, clip)]


def marks(session: Session) -> list[str]:
    return [each.message for each in session.graph.shot(1, 2).flaws if each.kind == "mark"]


def test_a_motion_is_added_from_its_second_on_retimed_and_taken_away(session: Session) -> None:
    assert not cues(session, "tom", "wave")
    before = (session.folder / "graph.json").read_bytes()
    stale = apply(session, does("tom", wave={"target": "anna", "at": 1.0}))
    [wave] = cues(session, "tom", "wave")
    assert wave.target_id == "anna" and 24 <= wave.start <= 72
    assert {name[:5] for name in stale} == {"SC010"}
    apply(session, does("tom", wave={"at": 3.0}))
    [later] = cues(session, "tom", "wave")
    assert later.target_id == "anna", "the rest of it is as it was decided"
    assert later.start == wave.start + 48 and not marks(session)
    apply(session, does("tom", wave=None))
    assert not cues(session, "tom", "wave")
    for _ in range(3):
        session.undo()
    assert (session.folder / "graph.json").read_bytes() == before


def test_what_the_script_has_is_left_out_or_begins_later(session: Session) -> None:
    spoken = [action for action in session.graph.shot(1, 3).character_actions if action.motion == "talk"]
    spoken = spoken or [action for action in session.graph.shot(1, 2).character_actions if action.motion == "talk"]
    [shot] = {
        f"SC010_SH{each.shot_id * 10:03d}" for each in session.graph.shots_of(1) if spoken[0] in each.character_actions
    }
    person = spoken[0].asset_id
    first = cues(session, person, "talk", shot)[0].start
    apply(session, does(person, shot, talk={"at": 2.0}))
    assert cues(session, person, "talk", shot)[0].start >= 48 > first
    with pytest.raises(InputError, match="script"):
        apply(session, does(person, shot, talk=None))


def test_one_goes_where_one_is_sent_and_stays_there(session: Session) -> None:
    apply(session, does("tom", walk={"target": "sofa"}))
    [walk] = cues(session, "tom", "walk")
    assert walk.mark is not None
    for each in session.graph.shot(1, 3).blocking:
        if each.start.asset_id == "tom":
            assert each.start.location == walk.mark.location
    told = session.graph.shot(1, 2).blocking_decision
    assert told is not None and told.words == "tom does walk, to sofa"


@every(
    "edit said",
    [
        (does("tom", wavee={}), "did you mean wave"),
        (does("tom", wave=None), "does not wave"),
        (does("tom", talk={}), "script"),
        (does("tom", sit={}), "posture"),
        (does("tom", wave={"target": "nobody_here"}), "no 'nobody_here'"),
        (does("tom", wave={"at": -1}), "at"),
        (does("tom", drink={"prop": "sofa"}), "too large"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(edit: dict[str, Any], said: str, session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=said):
        apply(session, edit)
    assert session.graph == before


def test_the_command_line_says_the_same() -> None:
    [wanted] = edits_of([does("tom", wave={"target": "anna", "at": 1.0})])
    assert motion_edit(SHOT, "tom", "Wave", {"target": "Anna", "at": 1.0, "prop": None}) == wanted
    assert [motion_edit(SHOT, "tom", "wave", {}, remove=True)] == list(edits_of([does("tom", wave=None)]))
