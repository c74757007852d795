"""Takes of blocking and layout: kept, chosen, dropped, and found again in a changed script."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from tests.home import SCRIPT, SETTINGS

from storyblender.edits.words import edits_of
from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext
from storyblender.session import Session
from storyblender.studio import Studio

ROOM, SHOT = "SC010", "SC010_SH010"
STAGED = {"kind": "layout", "scene": ROOM, "staging": 1}


def apply(session: Session, *edits: dict[str, Any], draw: bool = True) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    if draw:
        session.draw(applied)
    return applied.stale


def take(of: str, action: str = "keep", number: int | None = None) -> dict[str, Any]:
    return {"kind": "take", "shot": SHOT, "of": of, "action": action, "number": number}


def shot(graph: ContinuityMemoryGraph) -> ShotContext:
    return graph.shot(1, 1)


def room(graph: ContinuityMemoryGraph) -> SceneContext:
    return graph.scene(1)


def marks(session: Session) -> dict[str, Any]:
    """An edit of where somebody of the shot ends it: one step from where they do."""
    at = shot(session.graph).blocking[0]
    x, y = at.end.location[:2] if at.end is not None else at.start.location[:2]
    place = {"location": [round(x + 0.4, 2), round(y, 2)]}
    return {"kind": "blocking", "shot": SHOT, "person": at.start.asset_id, "marks": {"end": place}}


@pytest.mark.parametrize("of", ["blocking", "layout"])
def test_a_take_that_is_chosen_is_as_it_was_and_the_other_one_stays(session: Session, of: str) -> None:
    first = session.graph
    apply(session, take(of))
    assert not shot(session.graph).stale and not room(session.graph).stale, "keeping makes nothing anew"
    apply(session, marks(session) if of == "blocking" else STAGED)
    second = session.graph
    assert (shot(second).blocking, room(second).layout) != (shot(first).blocking, room(first).layout)
    stale = apply(session, take(of, "choose", 1))
    assert SHOT in stale
    assert (shot(session.graph).blocking, room(session.graph).layout) == (shot(first).blocking, room(first).layout)
    apply(session, take(of, "choose", 2))
    assert (shot(session.graph).blocking, room(session.graph).layout) == (shot(second).blocking, room(second).layout)
    apply(session, take(of, "drop", 1))
    with pytest.raises(InputError, match="no take 1"):
        apply(session, take(of, "choose", 1))
    with pytest.raises(InputError, match="the film shows"):
        apply(session, take(of, "drop", 2))


@pytest.mark.parametrize("of", ["camera", "blocking", "layout"])
def test_every_gesture_with_takes_is_undone_byte_by_byte(session: Session, of: str) -> None:
    before = session.graph.model_dump_json()
    steps = (take(of), take(of, "choose", 1), take(of, "drop", 2))
    for step in steps:
        apply(session, step, draw=False)
    for _ in steps:
        session.undo()
    assert session.graph.model_dump_json() == before


def test_what_is_locked_is_not_exchanged(session: Session) -> None:
    apply(session, take("blocking"), take("layout"), draw=False)
    apply(session, {"kind": "lock", "target": SHOT, "parts": ["blocking"]}, draw=False)
    for of in ("blocking", "layout"):
        with pytest.raises(InputError, match="the blocking of SC010_SH010 is locked"):
            apply(session, take(of, "choose", 1))


def test_takes_stay_with_their_words_when_the_script_changes(folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, take("blocking"), take("layout"), draw=False)
        apply(session, marks(session), STAGED, draw=False)
        kept, decided = shot(session.graph).blocking_takes, shot(session.graph).blocking_decision
        layouts = room(session.graph).layout_takes
        script = folder.parent / "home.fountain"
        script.write_text(f"INT. CELLAR - NIGHT\n\nA cat sleeps.\n\n{SCRIPT}")
        session.make(script)
        moved = session.graph.shot(2, 1)
        assert (moved.blocking_takes, moved.blocking_decision) == (kept, decided)
        assert session.graph.scene(2).layout_takes == layouts
