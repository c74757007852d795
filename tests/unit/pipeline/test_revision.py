"""A changed script: decisions go with the words of their shot, the crew's work stays where nothing under it changed."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from tests.crew import RULES

from storyblender.edits.dispatcher import apply_edits
from storyblender.edits.undo import redo_edit, undo_edit
from storyblender.memory.base import shot_name
from storyblender.memory.edits import CameraEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import Layout, LayoutObject, Lighting, SceneSize, Sky
from storyblender.memory.shot_context import CameraDecision, CameraPose, CameraState, Flaw, ShotContext
from storyblender.pipeline.revision import decisions, matched_shots
from storyblender.pipeline.run import Run
from storyblender.pipeline.staging import design
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event

RELEASED = Path(__file__).parents[2] / "data" / "projects" / "schema-1"
KITCHEN = """INT. KITCHEN - DAY

ADA (60, grey hair) sits at the table.

ADA
You came back.

TOM (25, brown jacket) stands by the window.

TOM
I said I would.
"""
GARDEN = """EXT. GARDEN - NIGHT

Tom sits on the bench.

TOM
It is late.

Ada comes through the gate.

ADA
It always is.
"""
STATION = """INT. STATION - DAY

BEA (40, red coat) waits on the platform.

BEA
Nobody comes.
"""


def script(*scenes: str, title: str = "Two Cups") -> str:
    return f"Title: {title}\n\n" + "\n".join(scenes)


class Stage:
    """A project that is planned without Blender, and what is told meanwhile."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.file, self.told = folder / "p", folder / "cups.fountain", list[Event]()

    def plan(self, text: str, **settings: object) -> ContinuityMemoryGraph:
        self.told.clear()
        self.file.write_text(text)
        studio = Studio(Settings.model_validate(settings), self.told.append)
        return studio.plan(self.file, self.folder).graph

    def decide(self, words: str, decision: CameraDecision) -> None:
        """Set the camera of the shot with these words by hand."""
        with Project(self.folder) as project:
            shot = shot_of(project.graph, words)
            name = shot_name(shot.scene_id, shot.shot_id)
            apply_edits(project, [CameraEdit(shot=name, decision=decision)])

    def _run(self, project: Project) -> Run:
        return Run(project, None, RULES, Settings(), lambda _: None)  # type: ignore[arg-type]

    def stage(self) -> ContinuityMemoryGraph:
        """Stand in for the crew: something in every field that it fills."""
        with Project(self.folder) as project:
            run = self._run(project)
            for scene in project.graph.scenes:
                room = design(run, project.graph, scene.scene_id)
                thing = LayoutObject(
                    node_id="thing", asset_id=scene.setup.asset_ids[0], location=(scene.scene_id, 0, 0)
                )
                size = SceneSize(x=3, x_negative=-3, y=3, y_negative=-3)
                layout = Layout(scene_size=size, objects=(thing,))
                sky = Sky(zenith=(0, 0, 0), horizon=(0, 0, 0), ground=(0, 0, 0))
                update = {"environment": room, "layout": layout, "lighting": Lighting(sky=sky)}
                project.commit(replace(project.graph, scene.model_copy(update=update)), "animator", "stages")
            shots = [
                shot.model_copy(update={"camera": camera(shot)}) for shot in project.graph.shots if not shot.camera
            ]
            project.commit(replace(project.graph, *shots), "camera_operator", "films")
            return project.graph

    @property
    def warnings(self) -> dict[str, str]:
        return {event.subject: event.message for event in self.told if event.kind == "warning"}


def camera(shot: ShotContext) -> CameraState:
    pose = CameraPose(pivot=(shot.shot_id, 0, 1), rotation=(1, 0, 0, 0), distance=2, lens=50)
    flaw = Flaw(subject=f"SC{shot.scene_id * 10:03d}_SH{shot.shot_id * 10:03d}", message="close")
    return CameraState(poses=(pose,), residual=(flaw,))


def shot_of(graph: ContinuityMemoryGraph, words: str) -> ShotContext:
    for scene in graph.outline:
        for shot in scene.shots:
            if any(words in line.text for line in shot.lines):
                return graph.shot(scene.scene_id, shot.shot_id)
    raise AssertionError(words)


@pytest.fixture
def cups(tmp_path: Path) -> Stage:
    stage = Stage(tmp_path)
    stage.plan(script(KITCHEN, GARDEN))
    stage.decide("I said I would", CameraDecision(size="ECU"))
    stage.decide("I said I would", CameraDecision(lens=75))
    stage.decide("It always is", CameraDecision(angle="low angle", movement="push in"))
    stage.stage()
    return stage


CLOSE = CameraDecision(size="ECU", lens=75)
LOW = CameraDecision(angle="low angle", movement="push in")


@pytest.mark.parametrize(
    "changed",
    [
        script(KITCHEN, GARDEN, title="Three Cups"),
        script(STATION, KITCHEN, GARDEN),
        script(KITCHEN, STATION, GARDEN),
        script(GARDEN, KITCHEN),
        script(KITCHEN, GARDEN.replace("It is late", "It is too late")),
        script(KITCHEN.replace("You came back", "So you came back"), GARDEN),
        script(KITCHEN.replace("DAY", "NIGHT"), GARDEN),
    ],
    ids=["title", "scene before", "scene between", "scenes swapped", "line after", "line before", "heading"],
)
def test_decisions_stay_with_their_words(cups: Stage, changed: str) -> None:
    graph = cups.plan(changed)
    close, low = shot_of(graph, "I said I would"), shot_of(graph, "It always is")
    assert (close.camera_decision, low.camera_decision) == (CLOSE, LOW)
    assert (close.camera_instruction.size, close.camera_instruction.lens) == ("ECU", 75)
    assert (low.camera_instruction.angle, low.camera_instruction.movement) == ("low angle", "push in")
    assert not cups.warnings
    assert sum(shot.camera_decision is not None for shot in graph.shots) == 2


def test_what_cannot_stay_is_told(cups: Stage) -> None:
    graph = cups.plan(script(KITCHEN.replace("I said I would.", "I never said so."), GARDEN))
    [(name, message)] = cups.warnings.items()
    assert name.startswith("SC010_SH") and message.startswith("size ECU, lens 75 is not kept")
    assert [shot.camera_decision for shot in graph.shots if shot.camera_decision] == [LOW]
    cups.plan(script(GARDEN, title="Again"))
    assert not cups.warnings, "it is told once"


def test_undo_takes_the_revision_back_and_nothing_else(cups: Stage) -> None:
    with Project(cups.folder) as project:
        before = project.graph
    changed = cups.plan(script(STATION, KITCHEN.replace("I said I would.", "Not me."), GARDEN))
    with Project(cups.folder) as project:
        assert [commit.reason for commit in undo_edit(project)] == ["plans cups.fountain"]
        assert project.graph == before
        assert "I said I would." in (cups.folder / "script.fountain").read_text()
        redo_edit(project)
        assert project.graph == changed
        assert "Not me." in (cups.folder / "script.fountain").read_text()
        undo_edit(project)
        assert undo_edit(project)[0].reason == "SC020_SH040: angle low angle, movement push in"


def test_untouched_scenes_stay_as_they_were_staged(cups: Stage) -> None:
    before = cups.stage()
    kitchen, garden = before.scene(1), before.scene(2)
    graph = cups.plan(script(STATION, KITCHEN, GARDEN, title="Three Cups"))
    assert graph.scene(1).layout is None
    assert (graph.scene(2).environment, graph.scene(2).layout) == (kitchen.environment, kitchen.layout)
    assert graph.scene(3).model_copy(update={"scene_id": 2, "setup": garden.setup}) == garden
    for past, present in zip(before.shots, graph.shots[-len(before.shots) :], strict=True):
        assert past.camera is not None and present.camera is not None
        assert present.camera.poses == past.camera.poses
        assert present.camera.residual[0].subject == f"SC{present.scene_id * 10:03d}_SH{present.shot_id * 10:03d}"

    changed = cups.plan(script(KITCHEN, GARDEN.replace("bench", "wall")))
    assert changed.scene(1).layout == kitchen.layout and changed.scene(2).layout is None
    assert all((shot.camera is None) == (shot.scene_id == 2) for shot in changed.shots)


def test_scenes_of_a_project_without_kinds_stay_as_they_were_staged(cups: Stage) -> None:
    before = cups.stage()
    assert any(asset.kind for asset in before.assets)
    with Project(cups.folder) as project:
        older = [asset.model_copy(update={"kind": None}) for asset in before.assets]
        project.commit(replace(before, *older), "director", "as schema 5 has it")
    graph = cups.plan(script(KITCHEN, GARDEN, STATION))
    assert [scene.layout for scene in graph.scenes] == [*(scene.layout for scene in before.scenes), None]


@pytest.mark.parametrize("setting", [{"lens_kit": (35.0,)}, {"fps": 25}, {"seed": 7}])
def test_other_settings_ask_for_other_work_and_keep_decisions(cups: Stage, setting: dict[str, object]) -> None:
    graph = cups.plan(script(KITCHEN, GARDEN), **setting)
    assert all(scene.layout is None for scene in graph.scenes) and all(shot.camera is None for shot in graph.shots)
    assert shot_of(graph, "I said I would").camera_decision == CLOSE and not cups.warnings


def test_another_look_of_a_person_asks_for_their_scenes_anew(cups: Stage) -> None:
    before = cups.stage()
    graph = cups.plan(script(KITCHEN.replace("grey hair", "red hair"), STATION))
    assert graph.scene(1).layout is None and before.scene(1).layout is not None


def test_decisions_of_schema_1_are_found_by_what_they_changed(tmp_path: Path) -> None:
    folder = shutil.copytree(RELEASED, tmp_path / "p")
    with Project(folder) as project:
        assert all(shot.camera_decision is None for shot in project.graph.shots)
        assert decisions(project.graph, project.log()) == {(1, 2): CameraDecision(size="CU", lens=50)}
        redo_edit(project)
        text = (folder / "script.fountain").read_text()
    stage = Stage(tmp_path)
    graph = stage.plan(text.replace("Two Cups", "Three Cups"), look="fast", width=320)
    assert graph.shot(1, 2).camera_decision == CameraDecision(size="CU", lens=50)
    assert graph.shot(2, 1).camera_decision == CameraDecision(angle="low angle") and not stage.warnings


def test_a_script_can_be_changed_though_the_history_is_lost(cups: Stage) -> None:
    shutil.rmtree(cups.folder / "history")
    graph = cups.plan(script(KITCHEN, GARDEN, title="Three Cups"))
    assert [shot.camera_decision for shot in graph.shots if shot.camera_decision] == [CLOSE, LOW]
    assert any("missing" in message for message in cups.warnings.values())


def outline(*scenes: str) -> list[SceneOutline]:
    """A scene a string, a shot a word."""
    return [
        SceneOutline(
            scene_id=number,
            scene_description="",
            heading="INT. ROOM",
            shots=tuple(ShotOutline(shot_id=place, lines=(line(word),)) for place, word in enumerate(words.split(), 1)),
        )
        for number, words in enumerate(scenes, 1)
    ]


def line(word: str) -> ScriptLine:
    return ScriptLine(kind="action", text=word, span=SourceSpan(start=0, end=1))


@pytest.mark.parametrize(
    ("old", "new", "pairs"),
    [
        (["a b c"], ["a x b c"], {(1, 1): (1, 1), (1, 3): (1, 2), (1, 4): (1, 3)}),
        (["yes no yes"], ["no yes"], {(1, 1): (1, 2), (1, 2): (1, 3)}),
        (["a b", "c d"], ["c d", "a b"], {(1, 1): (2, 1), (1, 2): (2, 2), (2, 1): (1, 1), (2, 2): (1, 2)}),
        (["a b c d"], ["a b", "c d"], {(1, 1): (1, 1), (1, 2): (1, 2), (2, 1): (1, 3), (2, 2): (1, 4)}),
        (["a", "a"], ["a", "a", "a"], {(1, 1): (1, 1), (2, 1): (2, 1)}),
        (["a"], ["b"], {}),
    ],
)
def test_shots_are_matched_by_their_words(old: list[str], new: list[str], pairs: dict[object, object]) -> None:
    assert matched_shots(outline(*old), outline(*new)) == pairs


def test_most_of_a_feature_is_matched_whatever_it_repeats() -> None:
    old = outline(*("yes no maybe yes" for _ in range(300)))
    new = outline(*("yes no maybe yes no" if n % 7 == 0 else "yes no maybe yes" for n in range(300)))
    assert len(matched_shots(old, new)) > 1000


def test_the_graph_says_what_was_decided(cups: Stage) -> None:
    body = json.loads((cups.folder / "graph.json").read_text())
    assert [shot["camera_decision"]["lens"] for shot in body["shots"] if shot["camera_decision"]] == [75.0, None]
