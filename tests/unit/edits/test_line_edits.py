"""When lines are said: a person moves one, what is said after it follows, and the crew gets it back."""

from __future__ import annotations

from typing import Any

import pytest

from storyblender.deliver.panel import panels
from storyblender.deliver.speech import speeches
from storyblender.edits.words import edits_of, line_edit
from storyblender.errors import InputError
from storyblender.memory.edits import Edit
from storyblender.session import Session


def spoken(session: Session) -> tuple[str, str, int]:
    """Return the shot, the speaker and the number of the first line that is said."""
    panel = next(each for each in panels(session.graph) if each.dialogue)
    line = panel.dialogue[0]
    return panel.name, str(line.speaker), panel.outline.lines.index(line) + 1


def begins(session: Session, shot: str) -> float:
    panel = next(each for each in panels(session.graph) if each.name == shot)
    return speeches(panel)[0].start / panel.fps


def apply(session: Session, edit: Edit) -> str:
    applied = session.apply((edit,))
    session.draw(applied)
    return applied.words


def test_a_line_is_said_when_a_person_decided_and_as_long(session: Session) -> None:
    shot, person, number = spoken(session)
    first, before = begins(session, shot), (session.folder / "graph.json").read_bytes()
    words = apply(session, line_edit(shot, person, number, {"at": first + 3.0}))
    assert f"{person.title()} says line {number} at" in words
    assert begins(session, shot) == pytest.approx(first + 3.0, abs=0.5)
    apply(session, line_edit(shot, person, number, {"seconds": 5.0}))
    panel = next(each for each in panels(session.graph) if each.name == shot)
    said = speeches(panel)[0]
    assert said.start / panel.fps == pytest.approx(first + 3.0, abs=0.5), "the rest of it is as it was decided"
    assert (said.end - said.start) / panel.fps == pytest.approx(5.0, abs=0.2), "and the shot has grown"
    apply(session, line_edit(shot, person, number, {}))
    assert begins(session, shot) == first
    for _ in range(3):
        session.undo()
    assert (session.folder / "graph.json").read_bytes() == before


def test_lines_of_others_are_refused(session: Session) -> None:
    shot, person, number = spoken(session)
    on_stage = [each.start.asset_id for each in session.graph.shot(int(shot[2:5]) // 10, int(shot[8:]) // 10).blocking]
    for who, line in ((person, 99), *((other, number) for other in on_stage if other != person)):
        with pytest.raises(InputError, match="is not said by"):
            apply(session, line_edit(shot, who, line, {"at": 1.0}))
    edit: dict[str, Any] = {"kind": "blocking", "shot": shot, "person": person, "marks": {"lines": {"0": {"at": 1}}}}
    with pytest.raises(InputError):
        edits_of([edit])
