"""What a person decides of postures, looks and hands is so, holds in later shots, and goes back byte for byte."""

from __future__ import annotations

from typing import Any

import pytest
from tests.every import every

from storyblender.edits.words import edits_of, pose_edit
from storyblender.errors import InputError
from storyblender.memory.edits import EDITS
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import Mark
from storyblender.session import Session

FIRST, SHOT, NEXT = "SC010_SH010", "SC010_SH020", "SC010_SH030"


def pose(person: str, shot: str = SHOT, when: str = "start", **said: Any) -> dict[str, Any]:
    return {"kind": "blocking", "shot": shot, "person": person, "marks": {when: said}}


def apply(session: Session, *edits: dict[str, Any]) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    session.draw(applied)
    return applied.stale


def mark(graph: ContinuityMemoryGraph, person: str, shot: str, when: str = "start") -> Mark:
    blocking = graph.shot(int(shot[2:5]) // 10, int(shot[8:]) // 10).blocking
    [own] = [each for each in blocking if each.start.asset_id == person]
    return getattr(own, when)


def flaws(graph: ContinuityMemoryGraph, shot: str = SHOT) -> list[str]:
    return [each.message for each in graph.shot(1, int(shot[8:]) // 10).flaws if each.kind == "mark"]


def test_who_stood_sits_there_from_then_on_and_only_their_scene_is_stale(session: Session) -> None:
    before = session.graph
    stale = apply(session, pose("Tom", posture="sit", on="set_armchair_1"))
    after = session.graph
    assert {name[:5] for name in stale} == {"SC010"}
    assert mark(after, "tom", FIRST) == mark(before, "tom", FIRST)
    for shot in (SHOT, NEXT):
        assert (mark(after, "tom", shot).posture, mark(after, "tom", shot).support_id) == ("sit", "set_armchair_1")
    assert before.scenes == after.scenes and before.shots[3:] == after.shots[3:] and not flaws(after)
    apply(session, {"kind": "unlock", "target": SHOT, "parts": ["blocking"]})
    assert mark(session.graph, "tom", SHOT) == mark(before, "tom", SHOT), "the crew has it back"


def test_who_sat_stands_and_then_may_be_placed(session: Session) -> None:
    with pytest.raises(InputError, match="does not stand"):
        apply(session, pose("anna", location=[0.5, -0.5]))
    apply(session, pose("anna", posture="stand", location=[0.5, -0.5]))
    start = mark(session.graph, "anna", SHOT)
    assert (start.posture, start.support_id, start.location) == ("stand", None, (0.5, -0.5, 0.0))
    assert mark(session.graph, "anna", NEXT).posture == "stand"
    apply(session, pose("anna", location=[0.75, -0.5]))
    assert mark(session.graph, "anna", SHOT).location == (0.75, -0.5, 0.0)
    with pytest.raises(InputError, match="does not stand"):
        apply(session, pose("anna", posture="sit", on="sofa"), pose("anna", location=[0.75, -0.5]))


@every("posture", ["kneel", "crouch", "lie"])
def test_one_may_be_on_the_floor_where_one_is_put(posture: str, session: Session) -> None:
    apply(session, pose("tom", posture=posture, location=[1.2, -0.8]))
    assert (mark(session.graph, "tom", SHOT).posture, mark(session.graph, "tom", SHOT).support_id) == (posture, None)
    assert mark(session.graph, "tom", SHOT).location == (1.2, -0.8, 0.0)


def test_what_is_decided_for_the_end_is_acted(session: Session) -> None:
    apply(session, pose("tom", when="end", posture="sit", on="set_armchair_1"))
    shot = session.graph.shot(1, 2)
    assert mark(session.graph, "tom", SHOT).posture == "stand" and mark(session.graph, "tom", NEXT).posture == "sit"
    assert mark(session.graph, "tom", SHOT, "end").support_id == "set_armchair_1"
    assert "sit" in {cue.clip for cue in shot.cues if cue.asset_id == "tom"} and not flaws(session.graph)
    apply(session, pose("anna", when="end", posture="stand"))
    assert "rise" in {cue.clip for cue in session.graph.shot(1, 2).cues if cue.asset_id == "anna"}


def test_hands_hold_what_is_put_in_them_and_let_go(session: Session) -> None:
    apply(session, pose("tom", holding=["letter"]))
    for shot in (SHOT, NEXT):
        assert [prop for _, prop in mark(session.graph, "tom", shot).held] == ["letter"]
        [state] = [each for each in session.graph.shot(1, int(shot[8:]) // 10).prop_states if each.asset_id == "letter"]
        assert state.held_by == "tom"
    with pytest.raises(InputError, match="tom holds letter"):
        apply(session, pose("anna", holding=["letter"]))
    apply(session, pose("tom", NEXT, holding=[]), pose("anna", NEXT, holding=["letter"]))
    assert [mark(session.graph, each, NEXT).held for each in ("tom", "anna")] == [(), (("R", "letter"),)]
    apply(session, {"kind": "unlock", "target": SHOT}, {"kind": "unlock", "target": NEXT})
    apply(session, pose("tom", when="end", holding=["letter"]))
    assert not mark(session.graph, "tom", SHOT).held and mark(session.graph, "tom", SHOT, "end").held
    assert "pick_up" in {cue.clip for cue in session.graph.shot(1, 2).cues if cue.asset_id == "tom"}


def test_eyes_rest_on_what_was_decided_whoever_speaks(session: Session) -> None:
    apply(session, pose("tom", looking_at="letter"))
    own = [cue for cue in session.graph.shot(1, 2).cues if cue.asset_id == "tom"]
    assert {cue.target_id for cue in own if cue.clip in ("look", "listen", "talk")} == {"letter"}
    apply(session, pose("tom", looking_at="camera"))
    [look] = [cue for cue in session.graph.shot(1, 2).cues if cue.asset_id == "tom" and cue.clip == "look"]
    assert look.target_id is None and look.mark is not None and look.mark.location[1] < -3
    apply(session, pose("anna", when="end", looking_at="tom"))
    last = [cue for cue in session.graph.shot(1, 2).cues if cue.asset_id == "anna" and cue.clip == "look"][-1]
    assert last.target_id == "tom" and last.start > 0


def test_it_is_data_and_undone_byte_for_byte(session: Session) -> None:
    edit = pose("tom", posture="sit", on="set_armchair_1", looking_at="anna", holding=["letter"])
    [typed] = edits_of([edit])
    assert EDITS.validate_json(EDITS.dump_json((typed,))) == (typed,)
    before = (session.folder / "graph.json").read_bytes()
    apply(session, edit)
    after = session.graph
    decided = after.shot(1, 2).blocking_decision
    assert decided is not None
    assert decided.words == "tom starts sitting on set_armchair_1, looking at anna, holding letter"
    session.undo()
    assert (session.folder / "graph.json").read_bytes() == before
    session.redo()
    assert session.graph == after


def test_it_stays_in_another_staging(session: Session) -> None:
    apply(session, pose("tom", posture="sit", on="set_armchair_1"), {"kind": "layout", "scene": "SC010"})
    assert mark(session.graph, "tom", SHOT).support_id == "set_armchair_1" and not flaws(session.graph)


@every(
    "edit said",
    [
        (pose("tom", posture="sit", on="letters"), "no 'letters'"),
        (pose("tom", posture="lie", on="table"), "nobody can lie on table"),
        (pose("tom", posture="kneel", on="sofa"), "goes with the posture"),
        (pose("tom", posture="fly"), "posture"),
        (pose("tom", holding=["sofa"]), "too large"),
        (pose("tom", holding=["anna"]), "no 'anna'"),
        (pose("tom", looking_at="tom"), "themselves"),
        (pose("tom", looking_at="nowhere"), "no 'nowhere'"),
        (pose("tom"), "mark"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(edit: dict[str, Any], said: str, session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=said):
        apply(session, edit)
    assert session.graph == before


def test_the_command_line_says_the_same() -> None:
    [wanted] = edits_of([pose("tom", when="end", posture="sit", on="sofa")])
    assert pose_edit(SHOT, "tom", {"posture": "sit", "on": "Sofa"}, at_end=True) == wanted
    with pytest.raises(InputError):
        pose_edit(SHOT, "tom", {})
