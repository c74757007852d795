"""What the drawer does first: the shot that is looked at, alone; frames only when nothing is to be seen."""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from typing import Any, cast

import pytest

from storyblender.errors import Cancelled
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.session import Session
from storyblender.web_studio import drawer
from storyblender.web_studio.drawer import Drawer

SHOTS = [f"SC010_SH0{number}0" for number in range(1, 6)]
ELSEWHERE = "SC020_SH010"


class Call:
    """A shot of the graph."""

    joined = False

    def __init__(self, shot_id: int, scene_id: int = 1) -> None:
        self.shot_id, self.scene_id = shot_id, scene_id


class Rehearsals:
    """Stands in for a session: notes its calls; each waits until it is let on, or cancelled."""

    def __init__(self) -> None:
        self.calls: list[str] = []
        self.slow = self.broken = ""
        self.delivered = True
        self.saved_in_blender: tuple[str, ...] = ()
        self.folder = Path()
        shots = [*(Call(number) for number in range(1, 6)), Call(1, scene_id=2)]
        self.graph = cast(ContinuityMemoryGraph, type("Graph", (), {"shots": shots}))
        self._changed, self._cancelled = threading.Condition(), False

    def warm(self) -> None:
        self._note("warm")

    def stale_frames(self) -> list[str]:
        return []

    def preview(self, names: Sequence[str]) -> dict[str, Path]:
        self._note(f"preview {' '.join(names)}")
        return {name: Path(name) for name in names}

    def rehearse(self, name: str) -> None:
        self._note(f"rehearse {name}")

    def shoot(self, names: Sequence[str]) -> None:
        self._note(f"shoot {' '.join(names)}")

    def cancel(self) -> None:
        with self._changed:
            self._cancelled = True
            self._changed.notify_all()

    def heard(self, call: str) -> None:
        with self._changed:
            assert self._changed.wait_for(lambda: call in self.calls, 30), (call, self.calls)

    def heard_again(self, call: str) -> None:
        with self._changed:
            assert self._changed.wait_for(lambda: self.calls.count(call) > 1, 30), (call, self.calls)

    def _note(self, call: str) -> None:
        with self._changed:
            self.calls.append(call)
            self._cancelled = False
            self._changed.notify_all()
            if self.broken and call.startswith(self.broken):
                raise IndexError("a fault of the program")
            if self.slow and call.startswith(self.slow):
                self._changed.wait_for(lambda: self._cancelled, 30)
                raise Cancelled


@pytest.fixture
def session() -> Rehearsals:
    return Rehearsals()


@pytest.fixture
def drawing(session: Rehearsals) -> Any:
    silent: Callable[[Collection[str]], None] = lambda _: None  # noqa: E731
    made = Drawer(cast(Session, session), lambda _: None, silent, lambda _: None, lambda: None)
    session.heard("warm")
    yield made
    made.close()


def previews(session: Rehearsals) -> list[str]:
    return [call.removeprefix("preview ") for call in session.calls if call.startswith("preview")]


def test_the_shot_looked_at_is_previewed_first_and_alone(session: Rehearsals, drawing: Drawer) -> None:
    drawing.look_at(SHOTS[3])
    session.heard(f"rehearse {SHOTS[3]}")
    drawing.draw(SHOTS, first=SHOTS[1])
    session.heard(f"shoot {SHOTS[3]} {SHOTS[0]}")
    assert previews(session)[0] == SHOTS[3]
    assert sorted(previews(session)) == SHOTS, "the others follow, each once"


def test_without_a_look_the_edited_shot_is_the_first(session: Rehearsals, drawing: Drawer) -> None:
    drawing.draw(SHOTS, first=SHOTS[1])
    session.heard(f"shoot {SHOTS[1]} {SHOTS[0]}")
    assert previews(session)[0] == SHOTS[1]


def test_an_edit_does_not_wait_until_what_is_delivered_is_written(
    session: Rehearsals, drawing: Drawer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(drawer, "IDLE", 90.0)
    drawing.draw(SHOTS[:1])
    session.heard(f"shoot {SHOTS[0]}")
    while drawing.stale:
        threading.Event().wait(0.05)
    threading.Event().wait(0.1)  # it waits now until the board may be written
    drawing.draw(SHOTS[3:4])
    session.heard(f"shoot {SHOTS[3]}")


def test_frames_under_way_give_way_to_a_look_and_go_on(session: Rehearsals, drawing: Drawer) -> None:
    session.slow = "shoot"
    drawing.draw(SHOTS[:1])
    session.heard(f"shoot {SHOTS[0]}")
    drawing.look_at(SHOTS[4])
    session.slow = ""
    session.heard(f"rehearse {SHOTS[4]}")
    session.heard_again(f"shoot {SHOTS[0]}")


def test_a_paused_drawing_begins_nothing_before_it_goes_on(session: Rehearsals, drawing: Drawer) -> None:
    session.slow = "preview"
    drawing.draw(SHOTS[:2], first=SHOTS[0])
    session.heard(f"preview {SHOTS[0]}")
    drawing.pause()
    session.slow = ""
    before = list(session.calls)
    assert not threading.Event().wait(0.2)
    assert session.calls == before, "the edit has the session to itself"
    drawing.go_on()
    session.heard_again(f"preview {SHOTS[0]}")


def test_previews_stay_in_the_scene_that_is_looked_at(session: Rehearsals, drawing: Drawer) -> None:
    drawing.look_at(SHOTS[0])
    drawing.draw([ELSEWHERE, *SHOTS[:2]])
    session.heard(f"shoot {SHOTS[0]} {SHOTS[1]}")
    session.heard(f"shoot {ELSEWHERE}")
    assert previews(session) == SHOTS[:2]


def test_previews_of_a_scene_that_nobody_looks_at_any_more_are_left(session: Rehearsals, drawing: Drawer) -> None:
    drawing.look_at(SHOTS[0])
    session.slow = "preview"
    drawing.draw(SHOTS[:2])
    session.heard(f"preview {SHOTS[0]}")
    drawing.look_at(ELSEWHERE)
    session.heard(f"rehearse {ELSEWHERE}")
    session.heard(f"shoot {SHOTS[0]} {SHOTS[1]}")
    assert previews(session) == [SHOTS[0]]


def test_a_look_at_what_is_gone_is_no_work(session: Rehearsals, drawing: Drawer) -> None:
    drawing.look_at("SC990_SH010")
    drawing.draw(SHOTS[:1])
    session.heard(f"shoot {SHOTS[0]}")
    assert not [call for call in session.calls if "SC990" in call]


def test_a_fault_of_the_program_does_not_end_the_drawing(session: Rehearsals, drawing: Drawer) -> None:
    session.broken = f"preview {SHOTS[0]}"
    drawing.draw(SHOTS[:2], first=SHOTS[0])
    session.heard(session.broken)
    session.heard(f"preview {SHOTS[1]}")
    session.heard(f"shoot {SHOTS[0]} {SHOTS[1]}")


def test_what_cannot_be_drawn_stays_stale_until_a_call_draws_it(session: Rehearsals, drawing: Drawer) -> None:
    session.broken = "shoot"
    drawing.draw(SHOTS[:1])
    session.heard(f"shoot {SHOTS[0]}")
    drawing.look_at(SHOTS[4])
    session.heard(f"rehearse {SHOTS[4]}")
    assert drawing.stale == {SHOTS[0]} and session.calls.count(f"shoot {SHOTS[0]}") == 1
    drawing.is_drawn(SHOTS[0])
    assert not drawing.stale


def test_what_is_saved_in_blender_is_told_once_a_save_while_nothing_is_drawn(
    session: Rehearsals, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(drawer, "LOOK", 0.01)
    session.folder, told = tmp_path, queue.Queue[str]()
    story = tmp_path / "story.blend"
    silent: Callable[[Collection[str]], None] = lambda _: None  # noqa: E731
    made = Drawer(cast(Session, session), lambda _: None, silent, lambda _: None, lambda: told.put("saved"))
    try:
        for save in (b"one", b"another"):
            (tmp_path / "part").write_bytes(save)
            os.utime(tmp_path / "part", (len(save), len(save)))
            (tmp_path / "part").replace(story)
            session.saved_in_blender = ("story.blend",)
            assert told.get(timeout=60) == "saved"
    finally:
        made.close()
    assert told.empty()
