"""Motion by hand in a project: a decision of its shot, that undo takes back and the crew takes over again."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from storyblender.edits.blend_change import BlendChange
from storyblender.edits.pulled_motion import keep_motions, with_hand_changes
from storyblender.edits.words import edits_of
from storyblender.errors import InputError, Rejected
from storyblender.folder import Folder
from storyblender.memory.blend_values import BlendReading, BlendValues
from storyblender.memory.history import replace
from storyblender.memory.jobs import SceneJob
from storyblender.memory.motion_by_hand import HandChannel, HandMotionRead, MotionByHand, by_hand_file
from storyblender.pipeline.hand_motions import with_hand_motions
from storyblender.pipeline.kept_decisions import marks_of
from storyblender.pipeline.packing import scene_job
from storyblender.project import Project
from storyblender.session import Session

SHOT = "SC010_SH020"
WAVE = MotionByHand(channels={"hand.R": HandChannel(frames=(0, 9), values=((1, 0, 0, 0), (0.8, 0.6, 0, 0)))})
NOD = MotionByHand(channels={"head": HandChannel(frames=(0,), values=((0.8, 0.6, 0, 0),))})


def edit(who: str = "tom", motion: str | None = WAVE.digest, shot: str = SHOT) -> dict[str, Any]:
    return {"kind": "by_hand", "shot": shot, "who": who, "motion": motion}


@pytest.fixture
def kept(session: Session) -> Session:
    """With the file of a motion in it."""
    Folder(session.folder).write(by_hand_file(WAVE.digest), WAVE.model_dump_json())
    return session


def project(session: Session) -> Any:
    return SimpleNamespace(files=Folder(session.folder), graph=session.graph)


def job(session: Session) -> SceneJob:
    run: Any = SimpleNamespace(project=project(session), tell=lambda event: None)
    return with_hand_motions(run, scene_job(session.graph, 1))


def test_it_is_packed_with_its_scene_and_nothing_else_of_the_shot_changes(kept: Session) -> None:
    before, bytes_before, packed = kept.graph.shot(1, 2), (kept.folder / "graph.json").read_bytes(), job(kept)
    applied = kept.apply(edits_of([edit()]))
    assert {name[:5] for name in applied.stale} == {"SC010"} and "Tom" in applied.words
    after = kept.graph.shot(1, 2)
    assert after == before.model_copy(update={"motion_by_hand": {"tom": WAVE.digest}}), "cameras and marks stay"
    [motion] = job(kept).by_hand
    assert (motion.shot_id, motion.asset_id, motion.motion) == (2, "tom", WAVE)
    assert job(kept).digest != packed.digest
    kept.undo()
    assert (kept.folder / "graph.json").read_bytes() == bytes_before and job(kept).digest == packed.digest


@pytest.mark.parametrize("given_back", [edit(motion=None), {"kind": "unlock", "target": SHOT, "parts": ["blocking"]}])
def test_the_crew_acts_it_again(kept: Session, given_back: dict[str, Any]) -> None:
    kept.apply(edits_of([edit()]))
    kept.apply(edits_of([given_back]))
    assert not kept.graph.shot(1, 2).motion_by_hand and not job(kept).by_hand


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        (edit(motion="0123456789abcdef"), "there is no by_hand/0123456789abcdef.json"),
        (edit(motion=None), "tom is not animated by hand in SC010_SH020"),
        (edit(who="nobody"), "no person or thing"),
    ],
)
def test_what_cannot_be_is_refused(kept: Session, wrong: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        kept.apply(edits_of([wrong]))


def test_a_locked_blocking_is_not_animated(kept: Session) -> None:
    kept.apply(edits_of([{"kind": "lock", "target": SHOT, "parts": ["blocking"]}]))
    with pytest.raises(InputError, match="locked"):
        kept.apply(edits_of([edit()]))


def test_a_file_that_is_gone_or_damaged_is_told_and_the_crew_acts(kept: Session) -> None:
    kept.apply(edits_of([edit()]))
    acted = scene_job(kept.graph, 1).digest
    for damage in (b"{}", None):
        if damage is None:
            Folder(kept.folder).delete(by_hand_file(WAVE.digest))
        else:
            Folder(kept.folder).write(by_hand_file(WAVE.digest), damage)
        assert job(kept).digest == acted


def test_a_second_pull_lies_over_the_first_and_tells_one_change_a_shot(kept: Session) -> None:
    kept.apply(edits_of([edit()]))
    read = HandMotionRead(scene="SC010", shot=SHOT, node_id="tom", asset_id="tom", motion=NOD)
    reading = BlendReading(compiled=None, saved=BlendValues(version="", scenes=(), surfaces={}), by_hand=(read,))
    keys = BlendChange(kind="keys added", scene="SC010", subject="tom", words="SC010.tom has 3 keys more")
    other = BlendChange(kind="keys added", scene="SC010", subject="anna", words="SC010.anna has 3 keys more")
    changes, motions = with_hand_changes(project(kept), [keys, other], reading)
    assert (
        changes[0] == other
        and len(changes) == 2
        and "tom is animated by hand in SC010_SH020 (head)" in changes[1].words
    )
    keep_motions(Folder(kept.folder), motions, changes[1].edits)
    kept.apply(changes[1].edits)
    [motion] = job(kept).by_hand
    assert motion.motion == WAVE.then(NOD)


def test_the_crew_does_not_take_it_away(kept: Session) -> None:
    kept.apply(edits_of([edit()]))
    shot, folder = kept.graph.shot(1, 2), kept.folder
    kept.close()
    with Project(folder) as project, pytest.raises(Rejected, match="by hand"):
        project.commit(replace(project.graph, shot.model_copy(update={"motion_by_hand": {}})), "animator", "acted")


def test_it_stays_with_the_words_of_its_shot(kept: Session) -> None:
    kept.apply(edits_of([edit()]))
    graph = kept.graph
    shot = graph.shot(1, 2)
    planned = shot.model_copy(update={"motion_by_hand": {}})
    assert marks_of(graph, graph, planned, shot) == {"motion_by_hand": {"tom": WAVE.digest}}
    without = planned.model_copy(update={"on_stage": ()})
    assert marks_of(graph, graph, without, shot) == {}, "who is not in it any more is not animated"
