"""Damaged projects: each opens, or is refused in one sentence. No traceback, no hang, no loss, no silent rewind.

All 5,000: ``pytest -m slow tests/fuzz``. One of them again: ``STORYBLENDER_FUZZ=1234 pytest tests/fuzz -k one``.
"""

from __future__ import annotations

import os
import random
import traceback
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from storyblender import studio
from storyblender.deliver.shot_list import write_shot_list
from storyblender.deliver.timeline import write_timeline
from storyblender.deliver.timeline_media import TimelineMedia
from storyblender.errors import StoryBlenderError
from storyblender.pipeline import compiling, delivery
from storyblender.pipeline.delivery import checks_of
from storyblender.pipeline.run import Run
from storyblender.project import Project, read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from tests.fuzz.damage import copied, damage
from tests.stage import camera_edit
from tests.stand_in_engine import StandInEngine

RELEASED = Path(__file__).parents[1] / "data" / "projects"
QUICK, MANY = 30, 5000
LONGEST = 400
"""Characters of a sentence, without the path."""


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[Path]]:
    """The released projects, drawn once without Blender, so that they have records of packs and frames."""
    patch = pytest.MonkeyPatch()
    patch.setattr(os, "fsync", lambda _: None)
    patch.setattr(studio, "BlenderEngine", StandInEngine)
    patch.setattr(delivery, "deliver", _deliver)
    made = [copied(source, tmp_path_factory.mktemp("whole") / source.name) for source in sorted(RELEASED.iterdir())]
    for folder in made:
        Studio(Settings.load(project=folder)).render(folder)
    yield made
    patch.undo()


def _deliver(run: Run, clips: object, story: compiling.Compilation) -> list[str]:
    """The deliverables that are text."""
    start = run.settings.start_timecode
    write_shot_list(run.graph, run.project.folder / "shots.csv", start)
    write_timeline(TimelineMedia(run.graph, {}, {}, run.project.folder, start), run.project.folder / "timeline.otio")
    checks_of(run)
    story.finish()
    return []


def _snapshot(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def _draw(folder: Path) -> None:
    Studio(Settings.load(project=folder)).render(folder)


def _edit(folder: Path) -> None:
    name = "SC010_SH010"
    Studio(Settings.load(project=folder)).edit(folder, [camera_edit(name, {"size": "CU"})])


def _undo(folder: Path) -> None:
    Studio(Settings()).undo(folder)


def _redo(folder: Path) -> None:
    Studio(Settings()).redo(folder)


def _check(folder: Path) -> None:
    Studio(Settings.load(project=folder)).check(folder)


def _plan(folder: Path) -> None:
    script = folder.parent / "story.fountain"
    script.write_text((RELEASED / "schema-1" / "script.fountain").read_text().replace("Title:", "Title: The"))
    Studio(Settings.load(project=folder)).plan(script, folder)


COMMANDS: tuple[Callable[[Path], None], ...] = (_draw, _edit, _undo, _redo, _check, _plan)


def _try(sources: list[Path], folder: Path, seed: int) -> str:
    """Damage a project and use it; return how it went, or raise AssertionError."""
    rng = random.Random(seed)
    copied(rng.choice(sources), folder)
    whole = _revision(folder)
    done = damage(folder, rng)
    before = _snapshot(folder)
    try:
        outcome = _opened(folder, before, whole)
        for command in rng.sample(COMMANDS, 2) if outcome == "opens" else ():
            _answered(lambda command=command: command(folder))
    except Exception as error:  # noqa: BLE001 - whatever it is, it is what is looked for
        raise AssertionError(f"case {seed}: {done}\n{''.join(traceback.format_exception(error))}") from None
    return outcome


def _revision(folder: Path) -> int:
    return int((folder / "history" / "HEAD").read_text().split()[0])


def _opened(folder: Path, before: dict[str, bytes], whole: int) -> str:
    """Open and close; refused, not a byte is changed; opened, it is at the revision that it was at, or says why not."""
    if not _answered(lambda: read_project_graph(folder)):
        assert not _answered(lambda: Project(folder).__exit__(None, None, None)), "refused to read, not to write"
        assert {**_snapshot(folder), ".lock": b""} == {**before, ".lock": b""}
        return "refused"
    with Project(folder) as project:
        says, revision = project.notices, project.revision
    assert revision >= whole or says, f"rewound to {revision} without a word"
    after = _snapshot(folder)
    for name, content in before.items():
        if name.startswith("history/0"):
            assert after[name] == content, f"{name} was touched"
    return "opens with a notice" if says else "opens"


def _answered(call: Callable[[], object]) -> bool:
    """Return whether a call was answered; refused, it says so in one sentence."""
    try:
        call()
    except StoryBlenderError as error:
        problem = getattr(error, "problem", str(error))
        assert problem and "\n" not in str(error) and len(problem) < LONGEST, error
        return False
    return True


def test_a_few_damaged_projects(sources: list[Path], tmp_path: Path) -> None:
    outcomes = Counter(_try(sources, tmp_path / "p", seed) for seed in range(QUICK))
    assert outcomes["refused"] > QUICK / 5 and outcomes["opens"] > QUICK / 10, outcomes


@pytest.mark.slow
@pytest.mark.timeout(3600)
def test_many_damaged_projects(sources: list[Path], tmp_path: Path) -> None:
    outcomes: Counter[str] = Counter()
    failed: list[str] = []
    for seed in range(MANY):
        try:
            outcomes[_try(sources, tmp_path / "p", seed)] += 1
        except AssertionError as error:
            failed.append(str(error))
    print(f"{MANY} damaged projects: {dict(outcomes)}, {len(failed)} failed")
    assert not failed, "\n\n".join(failed[:20])


@pytest.mark.skipif("STORYBLENDER_FUZZ" not in os.environ, reason="asked for by its number")
def test_one(sources: list[Path], tmp_path: Path) -> None:
    _try(sources, tmp_path / "p", int(os.environ["STORYBLENDER_FUZZ"]))
