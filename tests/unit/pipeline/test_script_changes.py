"""What a revised script would change is listed before anything is changed, and then comes true."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.unit.pipeline.test_revision import GARDEN, KITCHEN, STATION, Stage, script, shot_of

from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraDecision
from storyblender.pipeline.script_changes import ScriptChanges
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio


@pytest.fixture
def cups(tmp_path: Path) -> Stage:
    stage = Stage(tmp_path)
    stage.plan(script(KITCHEN, GARDEN))
    return stage


def compared(stage: Stage, text: str) -> ScriptChanges:
    revised = stage.file.with_name("revised.fountain")
    revised.write_text(text)
    with Studio(Settings()).open(stage.folder) as session:
        return session.compare(revised)


def named(graph: ContinuityMemoryGraph, words: str) -> str:
    shot = shot_of(graph, words)
    return shot_name(shot.scene_id, shot.shot_id)


def test_nothing_is_changed_by_looking(cups: Stage) -> None:
    before = {path: path.read_bytes() for path in cups.folder.glob("*.json")}
    changes = compared(cups, script(STATION, KITCHEN.replace("cup", "bowl"), GARDEN))
    assert changes.shots
    assert {path: path.read_bytes() for path in cups.folder.glob("*.json")} == before


def test_the_same_script_changes_nothing(cups: Stage) -> None:
    changes = compared(cups, script(KITCHEN, GARDEN))
    assert not changes.shots and not changes.renamed and not changes.lost


def test_new_scenes_are_new_and_the_others_get_another_number(cups: Stage) -> None:
    changes = compared(cups, script(STATION, KITCHEN, GARDEN))
    assert {shot.kind for shot in changes.shots} == {"new"}
    assert all("Bea" in shot.words or "BEA" in shot.words or "Nobody" in shot.words for shot in changes.shots)
    assert changes.renamed and all(new > former for new, former in changes.renamed.items())


def test_a_scene_that_goes_is_omitted(cups: Stage) -> None:
    changes = compared(cups, script(KITCHEN))
    assert {shot.kind for shot in changes.shots} == {"omitted"}
    graph = read_project_graph(cups.folder)
    assert {shot.former for shot in changes.shots} == {
        shot_name(shot.scene_id, shot.shot_id) for shot in graph.shots if shot.scene_id == 2
    }


def test_a_changed_line_is_a_changed_shot_with_both_its_words(cups: Stage) -> None:
    graph = read_project_graph(cups.folder)
    changes = compared(cups, script(KITCHEN.replace("stands by the window", "sits by the window"), GARDEN))
    [changed] = [shot for shot in changes.shots if shot.kind == "changed"]
    assert changed.former == named(graph, "stands by the window")
    assert "stands by" in changed.former_words and "sits by" in changed.words
    assert not [shot for shot in changes.shots if shot.kind in ("new", "omitted")]


def test_scenes_that_change_places_move(cups: Stage) -> None:
    changes = compared(cups, script(GARDEN, KITCHEN))
    assert {shot.kind for shot in changes.shots} == {"moved"}


def test_what_is_listed_as_lost_is_lost_and_the_rest_is_kept(cups: Stage) -> None:
    cups.decide("You came back", CameraDecision(lens=85))
    cups.decide("It is late", CameraDecision(lens=35))
    revised = script(KITCHEN.replace("You came back.", "Go away at once, both of you!"), GARDEN)
    told = compared(cups, revised).lost
    assert [decided for _, decided in told] == ["lens 85"]
    graph = cups.plan(revised)
    assert shot_of(graph, "It is late").camera_decision == CameraDecision(lens=35)
    assert told[0][0] in cups.warnings
