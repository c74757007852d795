"""Way points that a person sets: the walk goes through them, and the crew has the rest of the way."""

from __future__ import annotations

from typing import Any

import pytest

from storyblender.edits.words import edits_of, place_edit
from storyblender.errors import InputError
from storyblender.memory.base import Vec2
from storyblender.memory.edits import BlockingEdit, Edit
from storyblender.memory.shot_context import Cue
from storyblender.session import Session

SHOT = "SC010_SH020"


def apply(session: Session, *edits: Edit | dict[str, Any]) -> str:
    applied = session.apply(tuple(edits_of([each])[0] if isinstance(each, dict) else each for each in edits))
    session.draw(applied)
    return applied.words


def goes(*via: Vec2, end: Vec2 | None = None) -> dict[str, Any]:
    marks = {"via": list(via), **({"end": {"location": end}} if end is not None else {})}
    return {"kind": "blocking", "shot": SHOT, "person": "tom", "marks": marks}


def walks(session: Session) -> list[Cue]:
    return [cue for cue in session.graph.shot(1, 2).cues if cue.asset_id == "tom" and cue.clip == "walk"]


def marks(session: Session) -> list[str]:
    return [each.message for each in session.graph.shot(1, 2).flaws if each.kind == "mark"]


ASIDE, GOAL = (1.2, -1.4), (-1.0, -1.0)
"""Floor points that are free: one off the straight way from where tom stands to where he is sent."""


def test_a_walk_goes_through_its_way_points_and_back_to_the_crews_way(session: Session) -> None:
    before = (session.folder / "graph.json").read_bytes()
    apply(session, goes(end=GOAL))
    [straight] = walks(session)
    said = apply(session, goes(ASIDE))
    assert f"Tom walks through {ASIDE[0]:g}, {ASIDE[1]:g}" in said
    [walk] = walks(session)
    assert walk.via == (ASIDE,) and not marks(session)
    assert walk.mark and straight.mark and walk.mark.location == straight.mark.location
    apply(session, goes())
    assert walks(session) == [straight]
    for _ in range(3):
        session.undo()
    assert (session.folder / "graph.json").read_bytes() == before


def test_who_goes_nowhere_has_no_way(session: Session) -> None:
    with pytest.raises(InputError, match="does not walk"):
        apply(session, goes(ASIDE))


def test_a_point_that_cannot_be_reached_is_on_the_checklist(session: Session) -> None:
    layout = session.graph.scene(1).layout
    assert layout is not None
    sofa = next(item for item in layout.objects if "sofa" in item.node_id).location[:2]
    apply(session, goes(sofa, end=GOAL))
    assert any("walk through" in each for each in marks(session))
    assert walks(session), "the way is the crew's then"


def test_way_points_on_the_command_line() -> None:
    edit = place_edit(SHOT, "tom", (None, None), via=["0,1.5", "-0.5,1"])
    assert isinstance(edit, BlockingEdit) and edit.marks.via == ((0.0, 1.5), (-0.5, 1.0))
    free = place_edit(SHOT, "tom", (None, None), via=["crew"])
    assert isinstance(free, BlockingEdit) and free.marks.via == ()
    with pytest.raises(InputError, match="point"):
        place_edit(SHOT, "tom", (None, None), via=["1"])
    with pytest.raises(InputError, match="--via"):
        place_edit("SC010", "sofa", ("1,1", None), via=["1,1"])
