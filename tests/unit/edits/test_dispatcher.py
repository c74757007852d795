"""Edits become one commit or are refused; what a person decided or locked is kept against the crew until unlocked."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.stage import plan

from storyblender.edits.camera_edits import with_decided_camera
from storyblender.edits.dispatcher import Applied, apply_edits
from storyblender.edits.undo import undo_edit
from storyblender.edits.words import camera_decision, edits_of
from storyblender.errors import InputError, Rejected, StaleEdit
from storyblender.memory.camera_decision import CameraPosition, FreeCamera
from storyblender.memory.edits import EDITS, CameraEdit, DurationEdit, Edit, LightEdit, LockEdit, UnlockEdit
from storyblender.memory.history import replace
from storyblender.memory.locks import SCENE_LOCKS, SHOT_LOCKS
from storyblender.memory.scene_context import Lighting, Sky
from storyblender.memory.scene_decision import LightDecision
from storyblender.memory.shot_context import CameraDecision, CameraPose, ShotContext
from storyblender.memory.vocabulary import ShotKind
from storyblender.project import Project

SHOT, NEXT, SCENE, PERSON = "SC010_SH010", "SC010_SH020", "SC010", "anna"
PLACED = FreeCamera(start=CameraPosition(location=(0, -3, 1.6), target=(0, 0, 1.4)))
POSE = CameraPose(pivot=(0, 0, 1), rotation=(1, 0, 0, 0), distance=9, lens=35)


@pytest.fixture
def project(tmp_path: Path) -> Iterator[Project]:
    plan(tmp_path / "p")
    with Project(tmp_path / "p") as project:
        yield project


def camera(shot: str = SHOT, **decided: object) -> CameraEdit:
    return CameraEdit(shot=shot, decision=CameraDecision.model_validate(decided))


def shot_of(project: Project, number: int = 0) -> ShotContext:
    return project.graph.shots[number]


EVERY: list[Edit] = [
    camera(size="ECU"), camera(angle="low angle", lens=35), camera(movement="pan", direction="left"),
    camera(kind="insert", focus_on_ids=("anna",)), camera(f_number=2, focus="anna"), camera(placed=PLACED),
    DurationEdit(shot=SHOT, frames=90), DurationEdit(shot=SHOT, seconds=2.5),
    LockEdit(target=SHOT, parts=("camera",)), LockEdit(target=SCENE), LockEdit(target=PERSON),
]  # fmt: skip


@pytest.mark.parametrize("edit", EVERY, ids=lambda edit: str(edit)[:50])
def test_every_edit_is_data_one_commit_and_one_undo(edit: Edit, project: Project) -> None:
    assert EDITS.validate_json(EDITS.dump_json((edit,))) == (edit,)
    before, revision = project.graph, project.revision
    applied = apply_edits(project, [edit], project.version)
    assert project.graph != before and project.revision == revision + 1 and applied.version == project.version
    assert len(undo_edit(project)) == 1
    assert project.graph == before


def test_a_batch_is_one_commit_or_none_and_later_edits_see_earlier_ones(project: Project) -> None:
    before = project.graph
    lock = LockEdit(target=SHOT, parts=("duration",))
    with pytest.raises(InputError, match=f"the duration of {SHOT} is locked; unlock it first"):
        apply_edits(project, [camera(size="CU"), lock, DurationEdit(shot=SHOT, frames=9)])
    assert project.graph == before
    unlock = UnlockEdit(target=SHOT, parts=("duration",))
    applied = apply_edits(project, [camera(size="CU"), camera(NEXT, size="CU"), lock, unlock])
    assert applied.words == f"{SHOT}, {NEXT}: size CU; {SHOT}: duration locked; {SHOT}: duration unlocked"
    assert applied.stale == (SHOT, NEXT)
    undo_edit(project)
    assert project.graph == before


@pytest.mark.parametrize("now", ["two_shot", "group", "ots", "pov", "single", "establishing"])
def test_whom_a_picture_shows_decides_its_kind_where_none_is_said(now: ShotKind, project: Project) -> None:
    shot = shot_of(project)
    wanted = shot.camera_instruction.model_copy(update={"kind": now, "over_id": PERSON, "pov_id": PERSON})
    project.commit(replace(project.graph, shot.model_copy(update={"camera_instruction": wanted})), "user", "kind")
    apply_edits(project, [camera(focus_on_ids=(PERSON,))])
    assert shot_of(project).camera_instruction.kind == ("establishing" if now == "establishing" else "single")


def test_a_camera_edit_makes_its_own_camera_stale_and_touches_nothing_else(project: Project) -> None:
    before = project.graph
    apply_edits(project, [camera(size="CU")])
    [changed] = [new for old, new in zip(before.shots, project.graph.shots, strict=True) if old is not new]
    kept = changed.model_copy(
        update={
            field: getattr(before.shots[0], field)
            for field in ("camera_instruction", "camera_decision", "camera", "lights")
        }
    )
    assert kept == before.shots[0] and changed.camera is None


@pytest.mark.parametrize(
    ("edits", "said"),
    [
        ([{"kind": "camera", "shot": "SC010_SH099", "decision": {"size": "CU"}}], "there is no shot 'SC010_SH099'"),
        (
            [{"kind": "camera", "shot": SHOT, "decision": {"focus": "annna"}}],
            "thing 'annna'; did you mean",
        ),
        ([{"kind": "camera", "shot": SHOT, "decision": {"kind": "two_shot", "focus_on_ids": ["anna"]}}], "has 2 or"),
        ([{"kind": "camera", "shot": SHOT, "decision": {"kind": "ots", "focus_on_ids": ["anna"]}}], "whose shoulder"),
        ([{"kind": "camera", "shot": SHOT, "decision": {"kind": "pov"}}], "whose eyes"),
        ([{"kind": "camera", "shot": SHOT, "decision": {}}], "nothing is decided"),
        ([{"kind": "camera", "shot": SHOT, "decision": {"size": "HUGE"}}], "should be 'EWS'"),
        ([{"kind": "duration", "shot": SHOT}], "in frames or in seconds"),
        ([{"kind": "duration", "shot": SHOT, "frames": 0}], "greater than or equal to 1"),
        ([{"kind": "lock", "target": "bob"}], "there is no shot, scene or asset 'bob'"),
        ([{"kind": "lock", "target": SCENE, "parts": ["camera"]}], "is a scene and has no camera to lock; it has: lay"),
        ([{"kind": "fly"}], "does not match any of the expected tags"),
        ({"kind": "lock"}, "should be a valid tuple"),
    ],
)
def test_what_does_not_exist_or_cannot_be_is_refused_in_one_sentence(
    edits: object, said: str, project: Project
) -> None:
    before = project.graph
    with pytest.raises(InputError, match=said) as refused:
        apply_edits(project, edits_of(edits))
    assert project.graph == before and "\n" not in str(refused.value)


def crew_changes(project: Project, lock: str) -> None:
    """Let the crew change what a lock holds, in a way that the graph allows."""
    shot, scene = shot_of(project), project.graph.scenes[0]
    item = {
        "camera": lambda: shot.model_copy(
            update={"camera": shot.camera and shot.camera.model_copy(update={"score": 1})}
        ),
        "blocking": lambda: shot.model_copy(update={"blocking": ()}),
        "duration": lambda: shot.model_copy(update={"duration": shot.duration + 1}),
        "layout": lambda: scene.model_copy(update={"layout": None}),
        "light": lambda: scene.model_copy(update={"lighting": None}),
        "set": lambda: scene.model_copy(update={"environment": None}),
    }[lock]()
    project.commit(replace(project.graph, item), "animator", "changes it")


@pytest.mark.parametrize("lock", [lock for lock in (*SHOT_LOCKS, *SCENE_LOCKS) if lock != "blocking"])
def test_what_is_locked_stays_until_a_person_unlocks_it(lock: str, project: Project) -> None:
    target = SHOT if lock in SHOT_LOCKS else SCENE
    [edit] = edits_of([{"kind": "lock", "target": target, "parts": [lock]}])
    apply_edits(project, [edit])
    with pytest.raises(Rejected, match=f"the {lock} of {target} is locked"):
        crew_changes(project, lock)
    item = (shot_of(project) if lock in SHOT_LOCKS else project.graph.scenes[0]).model_copy(update={"locked": ()})
    with pytest.raises(Rejected, match=f"only a person unlocks the {lock} of {target}"):
        project.commit(replace(project.graph, item), "animator", "lifts it")
    apply_edits(project, edits_of([{"kind": "unlock", "target": target}]))
    crew_changes(project, lock)


def test_what_a_person_decided_the_crew_keeps_until_it_is_unlocked(project: Project) -> None:
    apply_edits(project, [camera(size="ECU"), DurationEdit(shot=SHOT, frames=90)])
    shot = shot_of(project)
    wider = shot.model_copy(update={"camera_instruction": shot.camera_instruction.model_copy(update={"size": "WS"})})
    longer = shot.model_copy(update={"duration": 91})
    for item, said in ((wider, "decided about the camera of SC010_SH010: size ECU"), (longer, "has 90 frames")):
        with pytest.raises(Rejected, match=said):
            project.commit(replace(project.graph, item), "frame_critic", "knows better")
    higher = shot.model_copy(update={"camera_instruction": shot.camera_instruction.model_copy(update={"lens": 90})})
    project.commit(replace(project.graph, higher), "frame_critic", "what nobody decided")
    apply_edits(project, [UnlockEdit(target=SHOT)])
    free = shot_of(project)
    assert (free.camera_decision, free.decided_duration, free.locked) == (None, None, ())
    project.commit(replace(project.graph, free.model_copy(update={"duration": 91})), "animator", "may now")


def stale(project: Project, version: str, edit: Edit) -> Applied | str:
    try:
        return apply_edits(project, [edit], version)
    except StaleEdit as error:
        return str(error)


def test_an_edit_of_an_older_revision_is_let_in_where_nothing_it_touches_changed(project: Project) -> None:
    version = project.version
    apply_edits(project, [camera(size="CU", lens=85)])
    said = stale(project, version, camera(angle="low angle"))
    assert said == f"{SHOT} changed since: user: {SHOT}: size CU, lens 85; look at it as it is now, then edit it"
    for other in (camera(NEXT, size="WS"), DurationEdit(shot=SHOT, frames=90), LockEdit(target=SCENE)):
        assert isinstance(stale(project, version, other), Applied)
    assert isinstance(stale(project, project.version, camera(angle="low angle")), Applied)


def test_what_the_crew_derives_since_is_no_conflict(project: Project) -> None:
    apply_edits(project, [camera(size="CU")])
    version, made = project.version, project.graph.shots[1].camera
    project.commit(
        replace(project.graph, shot_of(project).model_copy(update={"camera": made})), "camera_operator", "set"
    )
    assert isinstance(stale(project, version, camera(lens=50)), Applied)


def test_an_undone_revision_is_an_older_one_too(project: Project) -> None:
    apply_edits(project, [camera(size="CU")])
    edited = project.version
    undo_edit(project)
    assert "size CU" in str(stale(project, edited, camera(lens=50)))
    assert isinstance(stale(project, edited, camera(NEXT, size="WS")), Applied)
    with pytest.raises(InputError, match="was undone, and something else was done since"):
        apply_edits(project, [camera(lens=50)], edited)
    with pytest.raises(InputError, match="there is no revision 'yesterday'"):
        apply_edits(project, [camera(lens=50)], "yesterday")


def test_a_move_may_say_where_it_goes_and_a_slip_is_told() -> None:
    assert camera_decision({"movement": "pan left"}) == CameraDecision(movement="pan", direction="left")
    assert camera_decision({"kind": "Two-shot"}) == CameraDecision(kind="two_shot")
    with pytest.raises(InputError, match="movement cannot be 'spin left'; it is one of: static"):
        camera_decision({"movement": "spin left"})
    with pytest.raises(InputError, match="it is a number of mm"):
        camera_decision({"lens": 9000.0})


def test_a_later_decision_stands_on_an_earlier_one() -> None:
    first = CameraDecision(size="CU", lens=85, movement="pan", direction="left")
    assert first.then(CameraDecision(angle="low angle")) == first.model_copy(update={"angle": "low angle"})
    assert first.then(CameraDecision(size="WS")) == CameraDecision(size="WS", movement="pan", direction="left")
    assert first.then(CameraDecision(movement="push in")) == CameraDecision(size="CU", lens=85, movement="push in")
    racked = CameraDecision(f_number=2, focus="ana", focus_to="ben")
    assert racked.then(CameraDecision(size="WS")) == racked.model_copy(update={"size": "WS"})
    assert racked.then(CameraDecision(focus="ben")) == CameraDecision(f_number=2, focus="ben")
    assert racked.words == "f number 2, focus ana, focus to ben"
    placed = CameraDecision(placed=PLACED, lens=40)
    assert placed.then(CameraDecision(lens=50)) == CameraDecision(placed=PLACED, lens=50)
    assert placed.then(CameraDecision(size="CU")) == CameraDecision(size="CU"), "another picture is the crew's to find"


def test_what_the_crew_makes_of_a_decision_is_no_conflict_with_the_next_one(project: Project) -> None:
    """Warmer, and warmer again before the crew has lit the scene: the page has not seen its commit yet."""
    warmer = LightEdit(scene=SCENE, decision=LightDecision(warmth=1))
    version = apply_edits(project, [warmer]).version
    lit = Lighting(sky=Sky(zenith=(0.2, 0.4, 0.8), horizon=(0.6, 0.7, 0.8), ground=(0.2, 0.2, 0.2)))
    scene = project.graph.scenes[0].model_copy(update={"lighting": lit})
    project.commit(replace(project.graph, scene), "lighting_arranger", "lit")
    assert isinstance(stale(project, version, warmer), Applied)
    assert "light: warmth" in str(stale(project, version, warmer)), "but what a person decided meanwhile is"


def test_a_lock_comes_off_and_what_a_person_decided_stays_until_they_give_it_back(project: Project) -> None:
    warm = LightEdit(scene=SCENE, decision=LightDecision(warmth=1))
    apply_edits(project, [camera(size="ECU"), warm, LockEdit(target=SHOT), LockEdit(target=SCENE)])
    apply_edits(project, [UnlockEdit(target=SHOT), UnlockEdit(target=SCENE)])
    shot, scene = shot_of(project), project.graph.scenes[0]
    assert not shot.locked and not scene.locked
    assert shot.camera_decision is not None and scene.light_decision is not None
    apply_edits(project, [UnlockEdit(target=SHOT), UnlockEdit(target=SCENE)])
    shot, scene = shot_of(project), project.graph.scenes[0]
    assert shot.camera_decision is None and scene.light_decision is None


def test_a_picture_over_a_shoulder_shows_another_person_if_none_is_named(project: Project) -> None:
    anna = next(asset for asset in project.graph.assets if asset.asset_id == PERSON)
    graph = replace(project.graph, anna.model_copy(update={"asset_id": "ben", "name": "BEN"}))
    alone = shot_of(project)
    pair = alone.model_copy(update={"on_stage": (PERSON, "ben")})
    over = CameraDecision(kind="ots", over_id=PERSON)
    seen, _ = with_decided_camera(graph, pair, over)
    assert seen.camera_instruction.focus_on_ids == ("ben",)
    named, _ = with_decided_camera(graph, pair, over.model_copy(update={"focus_on_ids": (PERSON,)}))
    assert named.camera_instruction.focus_on_ids == (PERSON,), "what is named stands"
    with pytest.raises(InputError, match=f"nobody but {PERSON} for {SHOT} to show"):
        with_decided_camera(graph, alone, over)
