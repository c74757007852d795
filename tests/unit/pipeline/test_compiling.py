"""What of ``story.blend`` is compiled: everything once, then the scenes that changed, and nothing where nothing did."""

from __future__ import annotations

import re
from concurrent.futures import Future
from pathlib import Path
from typing import Any, cast

import pytest
from tests.crew import RULES

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.jobs import CutJob, PackRef, StoryJob
from storyblender.memory.scene_context import Layout, SceneContext, SceneSetup, SceneSize
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.pipeline import compiling
from storyblender.pipeline.compiling import Compilation, file_of, story_files
from storyblender.pipeline.run import Run
from storyblender.ports import Engine
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event

SCRIPT = "INT. ROOM - DAY\n\nANNA waits.\n\nEXT. STREET - NIGHT\n\nANNA runs.\n"


class Compiler:
    """Writes what it was asked for into the file."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.asked = folder, []

    def compile_story(self, job: StoryJob) -> Future[str]:
        self.asked.append(job.changed)
        return self._written(job)

    def compile_cut(self, job: CutJob) -> Future[str]:
        self.asked.append("cut")
        return self._written(job)

    def _written(self, job: StoryJob | CutJob) -> Future[str]:
        (self.folder / job.out).parent.mkdir(exist_ok=True)
        (self.folder / job.out).write_text(job.model_dump_json())
        done: Future[str] = Future()
        done.set_result(job.out)
        return done


@pytest.fixture(scope="module")
def graph(tmp_path_factory: pytest.TempPathFactory) -> ContinuityMemoryGraph:
    folder = tmp_path_factory.mktemp("plan")
    script = folder / "s.fountain"
    script.write_text(SCRIPT)
    return Studio(Settings()).plan(script, folder / "p").graph


def test_only_what_changed_is_compiled_and_what_a_person_changed_is_kept(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiler, told = Compiler(tmp_path), list[Event]()
    packs = {
        scene.scene_id: PackRef(scene_id=scene.scene_id, path=f"{scene.scene_id}.blend", starts=((1, 1),))
        for scene in graph.scenes
    }

    def compiled(graph: ContinuityMemoryGraph) -> list[Any]:
        compiler.asked.clear()
        run = Run(project, cast(Engine, compiler), RULES, Settings(), told.append)
        run.packs.update(packs)
        monkeypatch.setattr(Run, "graph", graph)
        Compilation(run).finish()
        return list(compiler.asked)

    with Project(tmp_path) as project:
        assert compiled(graph) == [None]
        assert compiled(graph) == []
        shot = graph.shots_of(2)[0]
        other = replace(graph, shot.model_copy(update={"duration": shot.duration + 1}))
        assert compiled(other) == [(2,)]
        assert compiled(graph) == [(2,)]
        packs[1] = packs[1].model_copy(update={"path": "another.blend"})
        assert compiled(graph) == [(1,)]
        wider = graph.model_copy(update={"format": graph.format.model_copy(update={"width": 1280})})
        assert compiled(wider) == [None]
        (tmp_path / "build" / "story.json").write_text("{")
        assert compiled(wider) == [None]
        assert not told and not list(tmp_path.glob("story *"))
        for content in ("painted over", "painted again"):
            (tmp_path / "story.blend").write_text(content)
            assert compiled(wider) == [None] and compiled(wider) == []
        copies = sorted(tmp_path.glob("story *.blend"), key=lambda path: path.stat().st_mtime_ns)
        assert [path.read_text() for path in copies] == ["painted over", "painted again"]
        assert [event.message.rpartition(" as ")[2] for event in told] == [path.name for path in copies]
        assert re.fullmatch(r"story \d{4}-\d\d-\d\d \d\d\.\d\d\.blend", copies[0].name)
    (tmp_path / "outputs.jsonl").unlink()
    with Project(tmp_path) as project:
        assert compiled(wider) == [None]
        assert len(list(tmp_path.glob("story *.blend"))) == 3, "what is unknown may be a person's"


def test_a_long_story_is_a_file_a_sequence_and_a_cut_that_links_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compiling, "MOST_SCENES", 3)
    monkeypatch.setattr(compiling, "SEQUENCE", 2)
    compiler, told = Compiler(tmp_path), list[Event]()
    layout = Layout(scene_size=SceneSize(x=1, x_negative=-1, y=1, y_negative=-1))

    def compiled(scenes: int, longer: int = 0) -> list[Any]:
        compiler.asked.clear()
        numbers = range(1, scenes + 1)
        graph = ContinuityMemoryGraph(
            scenes=tuple(SceneContext(scene_id=number, setup=SceneSetup(), layout=layout) for number in numbers),
            shots=tuple(
                ShotContext(
                    scene_id=number, shot_id=1, duration=49 if number == longer else 48,
                    camera_instruction=CameraInstruction(),
                )
                for number in numbers
            ),
        )  # fmt: skip
        run = Run(project, cast(Engine, compiler), RULES, Settings(), told.append)
        for number in numbers:
            path = f"{number}.{longer == number}.blend"
            run.packs[number] = PackRef(scene_id=number, path=path, starts=((1, 1),))
        monkeypatch.setattr(Run, "graph", graph)
        assert len(story_files(graph)) == (1 if scenes <= 3 else 1 + -(-scenes // 2))
        assert file_of(graph, 1) == ("story.blend" if scenes <= 3 else "story/SEQ010.blend")
        Compilation(run).finish()
        return list(compiler.asked)

    def files() -> list[str]:
        return [path.relative_to(tmp_path).as_posix() for path in sorted(tmp_path.rglob("*.blend"))]

    with Project(tmp_path) as project:
        assert compiled(3) == [None] and files() == ["story.blend"]
        assert compiled(5) == [None, None, None, "cut"]
        assert files() == ["story/SEQ010.blend", "story/SEQ020.blend", "story/SEQ030.blend", "story.blend"]
        steps = [(event.step, event.total) for event in told if event.role == "story"]
        assert steps == [(step, 4) for step in range(5)]
        assert compiled(5) == []
        assert compiled(5, longer=3) == [(3,), "cut"], "the cut has another length"
        (tmp_path / "story" / "SEQ020.blend").write_text("painted over")
        assert compiled(5, longer=3) == [None]
        assert sum(file.startswith("story/SEQ020 ") for file in files()) == 1, "what was painted is kept"
        assert compiled(4, longer=3)[-1] == "cut" and "story/SEQ030.blend" not in files()
        assert compiled(3) == [None] and "story/SEQ010.blend" not in files()
