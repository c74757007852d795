"""Killed at any write: the project opens at the last whole change, and the same work goes on to the same end.

A child process is killed with SIGKILL just before or after a call that changes the disk. All 200 kills:
``pytest -m slow tests/fuzz/test_kills.py``.
"""

from __future__ import annotations

import os
import random
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from storyblender import studio
from storyblender.edits.undo import redo_edit, undo_edit
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.edits import DurationEdit, LockEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.shot_context import CameraDecision
from storyblender.pipeline import delivery
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.studio import Studio
from tests.fuzz.damage import copied
from tests.stage import camera_edit
from tests.stand_in_engine import StandInEngine

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="kills a forked process")
RELEASED = sorted((Path(__file__).parents[1] / "data" / "projects").iterdir())[-1]
DEEDS = ("replace", "fsync", "open", "unlink", "ftruncate", "mkdir")
"""Calls of the system around which a process is killed."""
Step = Callable[[Path], object]


def _add(*names: str) -> Step:
    """Commit things as a person does, each followed by something of the crew's."""

    def step(folder: Path) -> None:
        with Project(folder) as project:
            for name in names:
                for author, asset_id in (("user", name), ("animator", f"{name}_moves")):
                    asset = Asset(asset_id=asset_id, asset_type="object", description="")
                    project.commit(replace(project.graph, asset), author, f"adds {asset_id}")

    return step


def _work(name: str) -> Step:
    """Commit something of the crew's, on a story as an undo left it."""

    def step(folder: Path) -> None:
        with Project(folder) as project:
            asset = Asset(asset_id=name, asset_type="object", description="")
            project.commit(replace(project.graph, asset), "animator", f"adds {name}")

    return step


def _undo(folder: Path) -> None:
    with Project(folder) as project:
        undo_edit(project)


def _redo(folder: Path) -> None:
    with Project(folder) as project:
        redo_edit(project)


def _edit(size: str) -> Step:
    edits = [camera_edit("SC010_SH030", {"size": size})]
    return lambda folder: Studio(Settings.load(project=folder)).edit(folder, edits)


def _lengthen(frames: int) -> Step:
    edits = [DurationEdit(shot="SC010_SH030", frames=frames), LockEdit(target="SC010_SH010", parts=("camera",))]
    return lambda folder: Studio(Settings.load(project=folder)).edit(folder, edits)


def _plan(word: str) -> Step:
    def step(folder: Path) -> None:
        script = folder.parent / f"{word}.fountain"
        script.write_text((RELEASED / "script.fountain").read_text().replace("It is late", f"It is {word}"))
        Studio(Settings.load(project=folder)).plan(script, folder)

    return step


COMMITS: tuple[Step, ...] = (
    _add("cup", "key"), _undo, _redo, _add("hat"), _undo, _work("rehearsal"), _redo, _undo, _undo,
    _add("box", "pen"), _undo, _work("retake"), _undo, _redo, _redo,
)  # fmt: skip
COMMANDS: tuple[Step, ...] = (_edit("CU"), _plan("early"), _undo, _lengthen(96), _edit("ECU"), _undo, _plan("noon"))


class Killed:
    """Runs steps in a child process that is killed at one of its writes.

    Args:
        folder: The project.
        steps: What the child does.
    """

    def __init__(self, folder: Path, steps: tuple[Step, ...]) -> None:
        self._folder, self._steps = folder, steps

    def run(self, start: int, at: int | None) -> tuple[int, int]:
        """Return how many steps were done, and how many writes, of a child that is killed at a write, if at any."""
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:
            self._work(start, at, writer)
        os.close(writer)
        with os.fdopen(reader, "rb") as pipe:
            told = pipe.read().split()
        _, status = os.waitpid(child, 0)
        died = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGKILL
        assert died if at is not None else status == 0, f"the child ended with {status}"
        return start + told.count(b"step"), told.count(b"write")

    def _work(self, start: int, at: int | None, writer: int) -> None:
        count = 0

        def counted(deed: Callable[..., Any]) -> Callable[..., Any]:
            def wrapped(*arguments: Any, **named: Any) -> Any:
                nonlocal count
                for moment in (0, 1):  # before it and after it
                    os.write(writer, b"write\n")
                    if count == at:
                        os.kill(os.getpid(), signal.SIGKILL)
                    count += 1
                    if moment == 0:
                        result = deed(*arguments, **named)
                return result

            return wrapped

        status = 1
        try:
            for name in DEEDS:
                setattr(os, name, counted(getattr(os, name)))
            for step in self._steps[start:]:
                step(self._folder)
                os.write(writer, b"step\n")
            status = 0
        finally:
            os._exit(status)


@contextmanager
def _without_blender() -> Iterator[None]:
    patch = pytest.MonkeyPatch()
    patch.setattr(studio, "BlenderEngine", StandInEngine)
    patch.setattr(delivery, "deliver", lambda run, clips, story: [])
    yield
    patch.undo()


def _graph(folder: Path) -> ContinuityMemoryGraph:
    with Project(folder) as project:
        lost = [told for told in project.notices if "missing" in told]
        assert not lost, "a kill loses nothing that would have to be rebuilt"
        return project.graph


def _kill_and_go_on(source: Path, room: Path, steps: tuple[Step, ...], kills: int, seed: int) -> int:
    """Kill runs of the steps at writes chosen by chance; return how many writes there are to be killed at."""
    states: list[ContinuityMemoryGraph] = []
    whole = copied(source, room / "whole")
    states.append(_graph(whole))
    for step in steps:
        step(whole)
        states.append(_graph(whole))
    _, writes = Killed(copied(source, room / "p"), steps).run(0, None)
    rng = random.Random(seed)
    for at in sorted(rng.sample(range(writes), min(kills, writes))):
        folder = copied(source, room / "p")
        done, _ = Killed(folder, steps).run(0, at)
        found = _graph(folder)
        between = _between(states, done)
        assert found in between, f"killed at write {at} of {writes}, in step {done}: neither before nor after it"
        if found == states[done]:  # the step can simply be done again
            for step, state in zip(steps[done:], states[done + 1 :], strict=True):
                step(folder)
                assert _graph(folder) == state
    return writes


def _between(states: list[ContinuityMemoryGraph], done: int) -> list[ContinuityMemoryGraph]:
    """Return the states that a step may be killed in: before it, after it, or between its commits."""
    before, after = states[done], states[min(done + 1, len(states) - 1)]
    assets = {asset.asset_id: asset for graph in (before, after) for asset in graph.assets}
    kept = tuple(asset for asset in before.assets if asset in after.assets)
    # A redo first drops what the crew did on the story as the undo had left it; it will do that again.
    grown = [before.model_copy(update={"assets": kept}), before]
    for asset in after.assets:
        if asset.asset_id not in {known.asset_id for known in before.assets}:
            grown += [replace(start, assets[asset.asset_id]) for start in grown[-2:]]
    return [before, after, *grown]


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """A killed process leaves what it wrote in the care of the system; to wait for the disk tells nothing more."""
    monkeypatch.setattr(os, "fsync", lambda _: None)


@pytest.fixture
def empty(tmp_path: Path) -> Path:
    with Project(tmp_path / "empty") as project:
        project.commit(ContinuityMemoryGraph(title="Cups"), "director", "plans")
    return tmp_path / "empty"


def test_a_few_killed_commits(empty: Path, tmp_path: Path) -> None:
    assert _kill_and_go_on(empty, tmp_path, COMMITS, kills=25, seed=1) > 100


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_many_killed_commits(empty: Path, tmp_path: Path) -> None:
    _kill_and_go_on(empty, tmp_path, COMMITS, kills=150, seed=2)


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_killed_edits_and_plans(tmp_path: Path) -> None:
    """An edit has commits of the crew's after it: killed between them, the camera is set and not yet drawn."""
    with _without_blender():
        source = copied(RELEASED, tmp_path / "source")
        Studio(Settings.load(project=source)).render(source)
        _, writes = Killed(copied(source, tmp_path / "p"), COMMANDS).run(0, None)
        for at in sorted(random.Random(3).sample(range(writes), 60)):
            folder = copied(source, tmp_path / "p")
            Killed(folder, COMMANDS).run(0, at)
            staged = [scene.layout is not None for scene in _graph(folder).scenes]
            assert staged[0], "nothing changed in the first scene"
            if not all(staged):  # killed after the changed script was planned
                _undo(folder)
            for step in (_edit("MCU"), _undo):
                step(folder)
            assert all((shot.camera_decision or CameraDecision()).size != "MCU" for shot in _graph(folder).shots)
