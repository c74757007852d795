"""What people read after a camera edit is of the new camera, and what could not be staged is told."""

from __future__ import annotations

import csv
import html
import re
from concurrent.futures import Future
from pathlib import Path

import pytest
from tests.stage import SETTINGS, Stage, camera_edit
from tests.stand_in_engine import StandInEngine

from storyblender.memory.history import replace
from storyblender.memory.jobs import PackRef, SceneJob
from storyblender.memory.shot_context import Flaw
from storyblender.project import Project
from storyblender.studio import Studio

EDITED, OTHERS = "SC010_SH010", slice(1, None)


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    stage = Stage(tmp_path / "p", monkeypatch)
    stage.render()
    return stage


def rows(stage: Stage) -> list[dict[str, str]]:
    return list(csv.DictReader((stage.folder / "shots.csv").open(encoding="utf-8-sig")))


def cards(stage: Stage) -> dict[str, str]:
    """Return what the page says of each shot, by its name."""
    page = (stage.folder / "index.html").read_text(encoding="utf-8")
    found = re.findall(r'<article[^>]*id="(SC\d+_SH\d+)"(.*?)</article>', page, flags=re.DOTALL)
    return {name: " ".join(re.sub(r"<[^>]*>", " ", text).split()) for name, text in found}


def checks_on_page(stage: Stage, shot: str) -> str:
    page = (stage.folder / "index.html").read_text(encoding="utf-8")
    found = re.search(rf'id="check-{shot}">.*?</dd>', page, flags=re.DOTALL)
    return found.group() if found else ""


def test_texts_follow_a_camera_edit_and_those_of_other_shots_stay(stage: Stage) -> None:
    before, shown = rows(stage), cards(stage)
    assert before[0]["size"] != "ECU" and before[0]["angle"] != "low angle"
    Studio(SETTINGS).edit(stage.folder, [camera_edit(EDITED, {"size": "ECU", "angle": "low angle", "lens": 90.0})])
    after, now = rows(stage), cards(stage)
    assert (after[0]["shot"], after[0]["size"], after[0]["angle"]) == (EDITED, "ECU", "low angle")
    assert after[0]["lens_mm"] == "90"
    assert "extreme close-up" in after[0]["description"] and "low angle" in after[0]["description"]
    assert all(word in now[EDITED] for word in ("ECU", "low angle", "90 mm"))
    assert not re.search(rf"\b{before[0]['size']}\b", now[EDITED]), "the page still says what it was"
    assert after[OTHERS] == before[OTHERS]
    assert {name: text for name, text in now.items() if name != EDITED} == {
        name: text for name, text in shown.items() if name != EDITED
    }


def test_texts_are_as_before_after_undo(stage: Stage) -> None:
    before, shown = rows(stage), cards(stage)
    Studio(SETTINGS).edit(stage.folder, [camera_edit(EDITED, {"size": "ECU", "movement": "push in"})])
    assert rows(stage) != before
    Studio(SETTINGS).undo(stage.folder)
    Studio(SETTINGS).render(stage.folder)
    assert (rows(stage), cards(stage)) == (before, shown)


def test_a_cut_that_another_camera_made_wrong_is_told_and_goes_with_it(stage: Stage) -> None:
    neighbour = rows(stage)[1]
    assert neighbour["shot"] == "SC010_SH020"
    Studio(SETTINGS).edit(stage.folder, [camera_edit(EDITED, {"size": neighbour["size"]})])
    with Project(stage.folder) as project:
        first, second, _ = project.graph.shots
        assert first.camera is not None
        same = first.camera.model_copy(update={"residual": ()})
        project.commit(replace(project.graph, second.model_copy(update={"camera": same})), "user", "the same camera")
    for camera, told in ({}, True), ({"size": "EWS", "angle": "high angle"}, False):
        if camera:
            Studio(SETTINGS).edit(stage.folder, [camera_edit(EDITED, camera)])
        else:
            Studio(SETTINGS).render(stage.folder)
        findings = Studio(SETTINGS).check(stage.folder).findings
        on_page = checks_on_page(stage, neighbour["shot"])
        assert any("SC010_SH020: the cut moves only" in finding for finding in findings) == told
        assert ("The cut goes to almost the same picture" in on_page) == told


DROPPED = {
    "missing": "Anna cannot open: the safe is not on stage",
    "no_path": "Anna finds no way there and stays",
    "no_support": "There is nothing to sit on",
    "unreachable": "Anna's hand does not reach what it should",
    "late": "Anna does not get there before the cut",
    "a kind that nobody has written a sentence for": "Anna does not fly",
}


@pytest.mark.parametrize(("kind", "words"), DROPPED.items(), ids=range(len(DROPPED)))
def test_what_could_not_be_staged_is_told_by_check_and_on_the_page(
    kind: str, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flaw = Flaw(kind=kind, subject="anna", weight=1.0, message=words.lower(), shot=EDITED)
    whole = StandInEngine.pack_scene

    def with_flaw(engine: StandInEngine, job: SceneJob) -> Future[PackRef]:
        ref = whole(engine, job).result()
        found: Future[PackRef] = Future()
        found.set_result(ref if ref.scene_id != 1 else ref.model_copy(update={"problems": (flaw,)}))
        return found

    monkeypatch.setattr(StandInEngine, "pack_scene", with_flaw)
    stage = Stage(tmp_path / "p", monkeypatch)
    stage.render()
    findings = Studio(SETTINGS).check(stage.folder).findings
    assert [finding for finding in findings if finding.lower() == f"{EDITED}: {words}".lower()]
    assert html.escape(words) in checks_on_page(stage, EDITED)
