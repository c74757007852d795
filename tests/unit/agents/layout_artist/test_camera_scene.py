from dataclasses import replace

import pytest
from test_camera_operator import ANNA, FILM, TOM, NumberFinder

from storyblender.agents.layout_artist import camera_scene
from storyblender.agents.layout_artist.camera_continuity import CUT_KINDS, judge_cuts
from storyblender.agents.layout_artist.camera_operator_view import Moment
from storyblender.agents.layout_artist.camera_scene import camera_operator_view, measured_frames, shoot_scene
from storyblender.agents.layout_artist.story_moment import story_moment
from storyblender.catalog.sets import plan_of
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.continuity import side_of_line
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, SceneContext, SceneSetup
from storyblender.memory.shot_context import (
    CameraInstruction,
    CameraPose,
    CameraState,
    CharacterAction,
    Cue,
    Flaw,
    PropState,
    ShotContext,
)
from storyblender.trace import Event

PLAN = plan_of(Environment(kit="street"))
AXIS = ("anna", "tom")
SET = CameraState(poses=(CameraPose(pivot=(0, 0, 1.6), rotation=(0.7, 0.7, 0, 0), distance=2, lens=50),))
CUP = AssetMeasure(asset_id="cup", digest="", geometry_hash="", dimensions=(0.08, 0.08, 0.1))


def graph(*instructions: dict, **shot) -> ContinuityMemoryGraph:
    layout = Layout(
        scene_size=PLAN.size, objects=(LayoutObject(node_id="cup_1", asset_id="cup", location=(1, 1, 0.8)),)
    )
    shots = tuple(
        ShotContext(scene_id=1, shot_id=index, camera_instruction=CameraInstruction(**instruction), **shot)
        for index, instruction in enumerate(instructions, 1)
    )
    return ContinuityMemoryGraph(scenes=(SceneContext(scene_id=1, setup=SceneSetup(), layout=layout),), shots=shots)


def moments(shot: ShotContext) -> list[Moment]:
    return [Moment(frame, (ANNA, TOM)) for frame in measured_frames(shot)]


def shoot(story: ContinuityMemoryGraph):
    finder = NumberFinder(moments(story.shots[0]), {})
    return shoot_scene(story, 1, PLAN, {"cup": CUP}, moments, finder)


DIALOGUE = (
    {"kind": "two_shot", "size": "MS", "focus_on_ids": AXIS, "axis": AXIS},
    {"kind": "ots", "size": "MS", "focus_on_ids": ("anna",), "over_id": "tom", "axis": AXIS},
    {"kind": "ots", "size": "MS", "focus_on_ids": ("tom",), "over_id": "anna", "axis": AXIS},
    {"kind": "single", "size": "CU", "focus_on_ids": ("anna",), "axis": AXIS},
    {"kind": "single", "size": "CU", "focus_on_ids": ("tom",), "axis": AXIS},
)


def test_a_conversation_is_shot_from_one_side_with_matching_reverses() -> None:
    cameras = shoot(graph(*DIALOGUE))
    orbits = [orbit_of(cameras[shot].poses[0], FILM) for shot in sorted(cameras)]
    assert {side_of_line(camera.position, ANNA.face, TOM.face) for camera in orbits} == {-1}
    assert orbits[3].azimuth * orbits[4].azimuth < 0
    assert abs(orbits[3].distance / orbits[4].distance - 1) < 0.25


def test_a_camera_that_is_set_stays_and_the_others_keep_to_its_side() -> None:
    story = graph(*DIALOGUE)
    first = shoot(story)[1]
    across = orbit_of(first.poses[0], FILM)
    pose = first.poses[0].model_copy(update={"rotation": _turned(across)})
    set_by_hand = first.model_copy(update={"poses": (pose,)})
    shots = (story.shots[0].model_copy(update={"camera": set_by_hand}), *story.shots[1:])
    cameras = shoot(story.model_copy(update={"shots": shots}))
    assert cameras[1] == set_by_hand
    assert side_of_line(orbit_of(cameras[3].poses[0], FILM).position, ANNA.face, TOM.face) == 1


def _turned(camera):
    from storyblender.geometry.orbit import orbit

    return orbit(camera, 180).rotation


def test_props_are_where_the_shot_has_them() -> None:
    shown = {"kind": "insert", "size": "CU", "focus_on_ids": ("cup",)}
    story = graph(shown)
    view = camera_operator_view(story, story.shots[0], PLAN, {"cup": CUP}, moments(story.shots[0]))
    assert view.focus == ("cup_1",)
    assert (view.props["cup_1"].x, view.props["cup_1"].z) == (1, 0.8)
    held = graph(shown, prop_states=(PropState(asset_id="cup", held_by="anna", hand="R"),))
    box = camera_operator_view(held, held.shots[0], PLAN, {"cup": CUP}, moments(held.shots[0])).props["cup_1"]
    assert 0.1 < box.x - ANNA.base[0] < 0.6, "before her, who looks to +X"
    there = (PropState(asset_id="bag", location=(-2, 1, 0.7)),)
    laid = graph({**shown, "focus_on_ids": ("bag",)}, prop_states=there)
    view = camera_operator_view(laid, laid.shots[0], PLAN, {"bag": CUP}, moments(laid.shots[0]))
    assert [(box.x, box.z) for box in view.things] == [(-2, 0.7)], "brought by somebody: no layout has it"
    gone = graph(shown, prop_states=(PropState(asset_id="cup", visible=False),))
    assert camera_operator_view(gone, gone.shots[0], PLAN, {"cup": CUP}, moments(gone.shots[0])).props == {}


def test_what_somebody_uses_never_goes_with_a_wall() -> None:
    uses = CharacterAction(asset_id="anna", action_description="closes it", motion="close", target_id="cup")
    for actions, used in (((), ()), ((uses,), ("cup_1",))):
        story = graph({"kind": "single", "size": "MS", "focus_on_ids": ("anna",)}, character_actions=actions)
        view = camera_operator_view(story, story.shots[0], PLAN, {"cup": CUP}, moments(story.shots[0]))
        assert view.used == used


@pytest.mark.parametrize(("frame", "focus"), [(20, ("anna", "cup")), (60, ("anna",))])
def test_what_was_put_down_before_is_not_what_a_picture_is_about(frame: int, focus: tuple[str, ...]) -> None:
    puts = Cue(asset_id="anna", clip="put_down", start=5, prop_id="cup"), Cue(asset_id="anna", clip="wave", start=50)
    story = graph({"kind": "action", "size": "MS", "focus_on_ids": ("anna", "cup")}, cues=puts)
    view = camera_operator_view(story, story.shots[0], PLAN, {}, [Moment(frame, (ANNA, TOM))])
    assert view.instruction.focus_on_ids == focus


def test_who_is_embraced_after_putting_something_down_is_not_seen_with_it() -> None:
    puts = Cue(asset_id="anna", clip="put_down", start=5, prop_id="cup")
    hugs = Cue(asset_id="tom", clip="hug", start=50, target_id="anna")
    story = graph({"kind": "action", "size": "MS", "focus_on_ids": (*AXIS, "cup")}, cues=(puts, hugs))
    view = camera_operator_view(story, story.shots[0], PLAN, {}, [Moment(80, (ANNA, TOM))])
    assert set(view.instruction.focus_on_ids) == set(AXIS)


@pytest.mark.parametrize(
    ("kind", "size", "x", "held"),
    [
        ("group", "MWS", 2.0, True),
        ("group", "MWS", 5.0, False),
        ("group", "WS", 5.0, True),
        ("action", "MWS", 5.0, False),
        ("two_shot", "MS", 3.0, False),
        ("action", "WS", 5.0, True),
    ],
)
def test_a_group_of_medium_size_holds_only_who_is_near(kind: str, size: str, x: float, held: bool) -> None:
    far = replace(TOM, face=(ANNA.face[0] + x, *TOM.face[1:]), base=(ANNA.base[0] + x, *ANNA.base[1:]))
    story = graph({"kind": kind, "size": size, "focus_on_ids": AXIS}, in_frame=("tom",))
    view = camera_operator_view(story, story.shots[0], PLAN, {}, [Moment(0, (ANNA, far))])
    assert (view.focus == AXIS) == held
    assert (view.in_frame == ("tom",)) == held


def test_a_camera_says_whom_it_leaves_out(monkeypatch) -> None:
    far = replace(TOM, face=(9.0, *TOM.face[1:]), base=(9.0, *TOM.base[1:]))
    story = graph({"kind": "group", "size": "MWS", "focus_on_ids": AXIS}, in_frame=AXIS)
    monkeypatch.setattr(camera_scene, "operate", lambda *_, **more: SET)
    cameras = shoot_scene(story, 1, PLAN, {"cup": CUP}, lambda _: [Moment(0, (ANNA, far))], NumberFinder([], {}))
    assert cameras[1].leaves_out == ("tom",)
    assert story.shots[0].shown == AXIS
    assert story.shots[0].model_copy(update={"camera": cameras[1]}).shown == ("anna",)


def test_a_reverse_answers_only_where_the_two_have_not_walked_around_each_other(monkeypatch) -> None:
    story = graph(*DIALOGUE[3:])
    behind = replace(TOM, face=(-0.6, 1.2, TOM.face[2]), base=(-0.6, 1.2, 0.0))
    for second, answers in ((TOM, True), (behind, False)):
        views = []
        monkeypatch.setattr(camera_scene, "operate", lambda view, *_, seen=views, **more: seen.append(view) or SET)
        at = {1: (ANNA, TOM), 2: (ANNA, second)}
        faces = lambda shot, at=at: [Moment(frame, at[shot.shot_id]) for frame in measured_frames(shot)]  # noqa: E731
        shoot_scene(story, 1, PLAN, {"cup": CUP}, faces, NumberFinder([], {}))
        assert (views[1].reverse is not None) == answers
        assert (views[1].side != 0) == answers, "a new line has no side yet"


TALK = {"clip": "talk", "start": 5, "duration": 60, "target_id": "tom"}
TAKE = {"clip": "pick_up", "start": 80}
HUG = {"clip": "hug", "start": 120, "target_id": "tom"}


@pytest.mark.parametrize(
    ("cues", "low", "high"),
    [
        ([TALK], 30, 50),
        ([TALK, TAKE], 80, 160),
        ([TAKE, {"clip": "shout", "start": 140, "duration": 40, "target_id": "tom"}], 140, 180),
        ([TALK, HUG, {**TAKE, "start": 160}], 120, 160),
        (
            [{"clip": "play_piano", "start": 5, "duration": 60}, {"clip": "shout", "start": 100, "duration": 40}],
            100,
            140,
        ),
        ([{"clip": "walk", "start": 5}], 188, 197),
        ([{"clip": "walk", "start": 5}, {**TALK, "start": 100}], 100, 160),
        ([{"clip": "rise", "start": 5}, {"clip": "point", "start": 90, "duration": 60}], 90, 150),
        ([TAKE, {**HUG, "start": 210}], 80, 199),
        ([{"clip": "turn", "start": 5}], 100, 120),
        ([{"clip": "walk", "start": 5}, {"clip": "sit", "start": 100}], 185, 199),
        ([{"clip": "take", "start": 5, "target_id": "anna"}, {"clip": "put_down", "start": 100}], 100, 199),
        ([{"clip": "wave", "start": 5, "target_id": "tom"}, {"clip": "fall", "start": 120}], 120, 180),
    ],
    ids=[
        "words",
        "deed",
        "deed, shout",
        "two people",
        "answered play",
        "way to somebody",
        "way, words",
        "rise, point",
        "after the end",
        "turn",
        "way, seat",
        "out of a pocket, down",
        "wave, fall",
    ],
)
def test_a_shot_is_drawn_at_the_last_of_the_strongest_things_that_happen(cues, low: int, high: int) -> None:
    instruction = CameraInstruction(focus_on_ids=AXIS, kind="action", size="MS")
    acts = tuple(Cue(asset_id="anna", **cue) for cue in cues)
    shot = ShotContext(scene_id=1, shot_id=1, on_stage=AXIS, camera_instruction=instruction, duration=200, cues=acts)
    assert low <= story_moment(shot) <= high


def test_a_lone_walk_is_drawn_on_the_way() -> None:
    instruction = CameraInstruction(focus_on_ids=("anna",), kind="action", size="FS")
    walk = Cue(asset_id="anna", clip="walk", start=0)
    shot = ShotContext(scene_id=1, shot_id=1, on_stage=AXIS, camera_instruction=instruction, duration=100, cues=(walk,))
    assert 40 <= story_moment(shot) <= 60


def test_who_takes_a_thing_from_the_floor_is_drawn_with_the_face_up_again_and_an_insert_shows_the_hand_at_work() -> (
    None
):
    drawn = {}
    for kind in ("action", "insert"):
        instruction = CameraInstruction(focus_on_ids=("anna",), kind=kind, size="MS")
        cues = (Cue(asset_id="anna", clip="pick_up", start=20),)
        shot = ShotContext(scene_id=1, shot_id=1, camera_instruction=instruction, duration=72, cues=cues)
        drawn[kind] = story_moment(shot)
    assert drawn["insert"] < 50 and 60 < drawn["action"] < 71


def test_a_blow_is_drawn_when_it_has_landed_however_long_the_shot_is() -> None:
    instruction = CameraInstruction(focus_on_ids=AXIS, kind="action", size="MS")
    act = Cue(asset_id="anna", clip="punch", start=24, target_id="tom")
    shot = ShotContext(scene_id=1, shot_id=1, on_stage=AXIS, camera_instruction=instruction, duration=200, cues=(act,))
    assert 24 + 12 < story_moment(shot) < 24 + 36


@pytest.mark.parametrize(("moment", "low", "high"), [("start", 0, 5), ("middle", 30, 60), ("end", 120, 150)])
def test_the_script_may_name_the_moment(moment: str, low: int, high: int) -> None:
    instruction = CameraInstruction(focus_on_ids=AXIS, kind="action", size="MS")
    acts = tuple(
        Cue(asset_id="anna", clip=clip, start=at, target_id="tom") for clip, at in (("punch", 24), ("nod", 120))
    )
    shot = ShotContext(scene_id=1, shot_id=1, camera_instruction=instruction, duration=200, cues=acts)
    shot = ShotContext.model_validate({**shot.model_dump(), "moment": moment})
    assert low <= story_moment(shot) <= high


def test_a_shot_whose_subject_does_nothing_shows_what_somebody_else_does() -> None:
    instruction = CameraInstruction(focus_on_ids=("cup",), kind="action", size="MS")
    act = Cue(asset_id="anna", clip="punch", start=24, target_id="tom")
    shot = ShotContext(scene_id=1, shot_id=1, on_stage=AXIS, camera_instruction=instruction, duration=200, cues=(act,))
    assert 24 + 12 < story_moment(shot) < 24 + 36


def _shown(*cues: dict[str, object], told: tuple[str, ...] = (), length: int = 300) -> int:
    instruction = CameraInstruction(focus_on_ids=AXIS, kind="action", size="MS")
    acts = tuple(Cue.model_validate({"asset_id": "anna", **cue}) for cue in cues)
    does = tuple(CharacterAction(asset_id="anna", action_description=each, motion=each) for each in told)
    shot = ShotContext(
        scene_id=1,
        shot_id=1,
        on_stage=AXIS,
        camera_instruction=instruction,
        duration=length,
        cues=acts,
        character_actions=does,
    )
    return story_moment(shot)


def test_a_face_alone_is_no_moment() -> None:
    walk = {"clip": "walk", "start": 5}
    assert _shown({"clip": "face", "start": 0}, walk) == _shown(walk)
    assert _shown({"clip": "face", "start": 0}) > 100


def test_what_is_told_is_shown_and_not_what_frees_the_hands_for_it() -> None:
    cues = ({"clip": "put_down", "start": 10, "prop_id": "bag"}, {"clip": "drum", "start": 60, "duration": 60})
    assert _shown(*cues, told=("drum",)) >= 60
    assert _shown(*cues[:1], told=("put_down",)) < 60
    risen = ({"clip": "rise", "start": 10}, {"clip": "talk", "start": 90, "duration": 60})
    assert _shown(*risen, told=("walk", "talk")) >= 90
    assert _shown(*risen, told=("stand", "talk")) < 60


def test_what_goes_on_since_before_the_shot_yields_to_what_is_done_in_it() -> None:
    goes_on = {"clip": "work", "start": 0, "lasting": True, "target_id": "desk"}
    assert _shown(goes_on, {"clip": "drum", "start": 120, "duration": 60}, told=("drum",)) >= 120


def test_a_speech_is_drawn_while_its_first_words_are_stressed() -> None:
    assert _shown({"clip": "talk", "start": 24, "duration": 240}) < 24 + 36
    assert _shown({"clip": "talk", "start": 24, "duration": 24}) == 24 + 12


def _of_line(moment: str | None, line: int | None, clips: tuple[tuple[str, int], ...]) -> int:
    """Return the drawn frame of a shot with an action and a cue a line, where one line names its moment."""
    does = tuple(
        CharacterAction(asset_id="anna", action_description=clip, motion=clip, line_index=index)
        for index, (clip, _) in enumerate(clips)
    )
    shot = ShotContext(
        scene_id=1,
        shot_id=1,
        on_stage=AXIS,
        camera_instruction=CameraInstruction(focus_on_ids=AXIS, kind="action", size="MS"),
        duration=300,
        cues=tuple(Cue(asset_id="anna", clip=clip, start=at) for clip, at in clips),
        character_actions=does,
    )
    return story_moment(ShotContext.model_validate({**shot.model_dump(), "moment": moment, "moment_line": line}))


CLIPS = (("wave", 20), ("fall", 120), ("point", 220))


@pytest.mark.parametrize("moment", ["start", "middle", "end"])
@pytest.mark.parametrize("line", [0, 1, 2])
def test_the_moment_of_a_line_is_the_moment_of_what_is_done_in_it(moment: str, line: int) -> None:
    begun = CLIPS[line][1]
    assert begun < _of_line(moment, line, CLIPS) < begun + 60


def test_what_starts_is_drawn_before_its_key_pose_and_has_begun() -> None:
    assert 120 + 5 < _of_line("start", 1, CLIPS) < _of_line("middle", 1, CLIPS)


def test_the_moment_of_a_line_without_action_is_not_that_of_the_other_lines() -> None:
    assert _of_line("start", 7, CLIPS) == _of_line(None, None, CLIPS)


def filmed(story: ContinuityMemoryGraph, **others: CameraState) -> ContinuityMemoryGraph:
    """Return a story with the cameras that the crew sets, or with others, by ``shot_1``."""
    cameras = shoot(story) | {int(name.removeprefix("shot_")): state for name, state in others.items()}
    shots = tuple(shot.model_copy(update={"camera": cameras[shot.shot_id]}) for shot in story.shots)
    return story.model_copy(update={"shots": shots})


def wrong_cuts(story: ContinuityMemoryGraph) -> dict[int, set[str]]:
    pairs = [(shot, camera_operator_view(story, shot, PLAN, {"cup": CUP}, moments(shot))) for shot in story.shots]
    told = {key: {flaw.kind for flaw in state.residual} & {*CUT_KINDS} for key, state in judge_cuts(pairs).items()}
    return {key: kinds for key, kinds in told.items() if kinds}


def test_a_changed_camera_makes_the_cuts_of_others_wrong_and_another_change_mends_them() -> None:
    story = filmed(graph(*DIALOGUE))
    assert wrong_cuts(story) == {}, "the crew's own cuts match"
    first = story.shots[0].camera
    across = first.poses[0].model_copy(update={"rotation": _turned(orbit_of(first.poses[0], FILM))})
    crossed = filmed(graph(*DIALOGUE), shot_1=first.model_copy(update={"poses": (across,)}))
    assert all("line" in wrong_cuts(crossed)[shot] for shot in (2, 3, 4, 5))
    stale = as_judged(crossed)
    mended = stale.model_copy(update={"shots": (story.shots[0], *stale.shots[1:])})
    assert wrong_cuts(mended) == {}, "what was wrong before is no longer told"


def as_judged(story: ContinuityMemoryGraph) -> ContinuityMemoryGraph:
    """Return a story whose cameras were left with the faults that they have."""
    states = judge_cuts(
        [(shot, camera_operator_view(story, shot, PLAN, {"cup": CUP}, moments(shot))) for shot in story.shots]
    )
    shots = tuple(shot.model_copy(update={"camera": states[shot.shot_id]}) for shot in story.shots)
    return story.model_copy(update={"shots": shots})


def test_a_camera_set_as_the_one_before_is_a_jump_cut_and_other_faults_stay() -> None:
    singles = ({"kind": "single", "size": "CU", "focus_on_ids": ("anna",)},) * 2
    story = filmed(graph(*singles))
    assert wrong_cuts(story) == {}
    headroom = Flaw(kind="headroom", subject="anna", weight=0.4, message="close")
    same = story.shots[0].camera.model_copy(update={"residual": (headroom,)})
    jumped = filmed(graph(*singles), shot_2=same)
    assert wrong_cuts(jumped) == {2: {"jump"}}
    assert headroom in as_judged(jumped).shots[1].camera.residual


def staged_again(story: ContinuityMemoryGraph, *formers: CameraState) -> ContinuityMemoryGraph:
    """Return a story whose shots had these cameras before it was staged again."""
    shots = (shot.model_copy(update={"former_camera": each}) for shot, each in zip(story.shots, formers, strict=True))
    return story.model_copy(update={"shots": tuple(shots)})


def shoot_and_hear(story: ContinuityMemoryGraph) -> tuple[dict[int, CameraState], list[Event]]:
    heard: list[Event] = []
    finder = NumberFinder(moments(story.shots[0]), {})
    cameras = shoot_scene(story, 1, PLAN, {"cup": CUP}, moments, finder, listener=heard.append)
    return cameras, heard


def test_cameras_that_still_work_are_kept_and_nobody_plans_them() -> None:
    story = graph(*DIALOGUE)
    cameras = shoot(story)
    kept, heard = shoot_and_hear(staged_again(story, *cameras.values()))
    assert kept == cameras and heard == []


def test_a_camera_that_no_longer_sees_its_subject_is_another_and_says_why() -> None:
    story = graph(*DIALOGUE)
    cameras = shoot(story)
    away = cameras[4].model_copy(update={"poses": (cameras[4].poses[0].model_copy(update={"pivot": (40, 40, 1)}),)})
    after, heard = shoot_and_hear(staged_again(story, *({**cameras, 4: away}).values()))
    assert after == cameras
    [told] = [event for event in heard if event.kind == "follow"]
    assert told.subject == "SC010_SH040"
    assert told.message == "has another camera: in the picture of the one before, anna is not in the picture"
