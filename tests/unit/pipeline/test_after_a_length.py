"""A shot of another length, a placed camera: what follows from them, what stays, and what is kept."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from tests.stage import SETTINGS, Stage

from storyblender.errors import InputError
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film
from storyblender.memory.camera_decision import CameraPosition, FreeCamera
from storyblender.memory.edits import CameraEdit, DurationEdit, LockEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.shot_context import CameraDecision, ShotContext
from storyblender.project import Project, read_project_graph
from storyblender.results import Delivery
from storyblender.studio import Studio

SHOT, LENGTH = "SC010_SH010", 150
STILL = SETTINGS.model_copy(update={"animatic": False})
LONGER = DurationEdit(shot=SHOT, frames=LENGTH)


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    stage = Stage(tmp_path / "p", monkeypatch)
    with Project(stage.folder) as project:  # the stage has set no motion
        unset = (shot.model_copy(update={"stale": ("motion",)}) for shot in project.graph.shots)
        project.commit(replace(project.graph, *unset), "user", "animate all")
    Studio(STILL).render(stage.folder)
    return stage


def edited(stage: Stage, *edits: DurationEdit | CameraEdit | LockEdit) -> Delivery:
    _, delivery = Studio(STILL).edit(stage.folder, edits)
    assert delivery is not None
    return delivery


def test_a_length_reaches_the_animator_the_lists_and_only_its_scene(stage: Stage) -> None:
    before = read_project_graph(stage.folder)
    graph = edited(stage, LONGER).graph
    shot, others = graph.shots[0], graph.shots[1:]
    assert (shot.duration, shot.decided_duration, shot.stale) == (LENGTH, LENGTH, ())
    assert [each.duration for each in others] == [each.duration for each in before.shots[1:]]
    assert graph.shots[2] == before.shots[2], "a shot of another scene is as it was"
    assert stage.engine.calls["pack_scene"] == 1
    rows = list(csv.DictReader((stage.folder / "shots.csv").open(encoding="utf-8-sig")))
    assert rows[0]["frames"] == str(LENGTH)
    with Project(stage.folder) as project:
        assert [commit.author for commit in project.log()][-1] != "user", "the crew's work is a commit of its own"
    Studio(STILL).undo(stage.folder)
    assert read_project_graph(stage.folder).shots == before.shots


def test_an_edit_killed_before_it_was_drawn_is_gone_on_with(stage: Stage) -> None:
    Studio(STILL).edit(stage.folder, [LONGER, CameraEdit(shot=SHOT, decision=CameraDecision(size="ECU"))], draw=False)
    assert read_project_graph(stage.folder).shots[0].stale == ("motion",)
    with pytest.raises(InputError, match="not up to date; run `storyblender render` first"):
        Studio(STILL).check(stage.folder)
    graph = Studio(STILL).render(stage.folder).graph
    assert graph.shots[0].stale == () and graph.shots[0].camera is not None and graph.shots[0].duration == LENGTH


def test_the_move_of_a_camera_ends_with_the_shot(stage: Stage) -> None:
    shot = edited(stage, CameraEdit(shot=SHOT, decision=CameraDecision(movement="push in"))).graph.shots[0]
    longer = edited(stage, LONGER).graph.shots[0]
    assert shot.camera is not None and longer.camera is not None and len(longer.camera.poses) > 1
    for share in (0.0, 1.0):
        before, after = (camera_at(s.camera, share * (s.duration - 1), Film()) for s in (shot, longer) if s.camera)
        assert before == after


def test_a_length_and_locks_stay_with_their_words_in_a_changed_script(stage: Stage) -> None:
    camera = edited(stage, LONGER, LockEdit(target=SHOT, parts=("camera",))).graph.shots[0].camera
    script = stage.folder.parent / f"{stage.folder.name}.fountain"
    script.write_text("EXT. HARBOUR - DAY\n\nTOM waits.\n\n" + script.read_text() + "\nAnna stops.\n")
    Studio(STILL).plan(script, stage.folder)
    moved = read_project_graph(stage.folder).shot(2, 1)
    assert (moved.duration, moved.decided_duration, moved.locked) == (LENGTH, LENGTH, ("camera",))
    assert moved.camera is not None and camera is not None and moved.camera.poses == camera.poses


def test_a_lock_that_a_changed_script_does_not_keep_is_told(stage: Stage) -> None:
    Studio(STILL).edit(stage.folder, [LockEdit(target="SC010", parts=("layout",)), LockEdit(target=SHOT)])
    script = stage.folder.parent / f"{stage.folder.name}.fountain"
    script.write_text(script.read_text().replace("sits at the table", "lies on the floor"))
    told: list[str] = []
    studio = Studio(STILL, lambda event: told.append(f"{event.subject}: {event.message}"))
    studio.plan(script, stage.folder)
    assert any(text.startswith("SC010: the lock of its layout is not kept") for text in told)
    assert any(text.startswith(f"{SHOT}: the lock of its camera, the lock of its blocking") for text in told)


def test_a_placed_camera_stands_where_it_was_placed_until_another_picture_is_asked_for(stage: Stage) -> None:
    first, last = ((1.0, -3.0, 1.6), (0.5, -2.0, 1.5))
    target = (0.0, 0.0, 1.4)
    ends = [CameraPosition(location=place, target=target) for place in (first, last)]
    placed = CameraDecision(placed=FreeCamera(start=ends[0], end=ends[1]), lens=40)
    shot = edited(stage, CameraEdit(shot=SHOT, decision=placed)).graph.shots[0]
    assert shot.camera is not None
    for frame, place in ((0, first), (shot.duration - 1, last)):
        camera = camera_at(shot.camera, frame, Film())
        assert camera.position == pytest.approx(place) and camera.pivot == pytest.approx(target) and camera.lens == 40
    again = edited(stage, CameraEdit(shot=SHOT, decision=CameraDecision(size="CU"))).graph.shots[0]
    assert again.camera_decision == CameraDecision(size="CU", lens=None)


def test_a_cut_that_an_edit_spoils_is_in_its_result_and_in_the_events(stage: Stage) -> None:
    graph: ContinuityMemoryGraph = read_project_graph(stage.folder)
    second: ShotContext = graph.shots[1]
    told: list[str] = []
    size = second.camera_instruction.size
    edited(stage, CameraEdit(shot=SHOT, decision=CameraDecision(size=size)))
    with Project(stage.folder) as project:
        first = project.graph.shots[0].camera
        assert first is not None
        same = second.model_copy(update={"camera": first.model_copy(update={"residual": ()})})
        project.commit(replace(project.graph, same), "user", "the same camera twice")
    studio = Studio(STILL, lambda event: told.append(event.subject) if event.kind == "warning" else None)
    _, delivery = studio.edit(stage.folder, [CameraEdit(shot=SHOT, decision=CameraDecision(angle="eye-level"))])
    assert delivery is not None and "SC010_SH020" in [flaw.shot for flaw in delivery.wrong_cuts]
    assert "SC010_SH020" in told
