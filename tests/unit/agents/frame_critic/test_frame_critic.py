"""The Frame Critic rejects a frame that does not show what its lines are about, and passes one that does."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.agents.frame_critic.critic import FrameCritic, verdict_of
from storyblender.agents.frame_critic.frame_view import FrameView
from storyblender.look.picture_measure import PictureMeasure, measure_picture
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_context import (
    BodyState,
    CameraInstruction,
    CameraPose,
    CameraState,
    CharacterAction,
    Cue,
    Flag,
    Flaw,
    ShotContext,
)

_CUP = Asset(
    asset_id="cup",
    asset_type="object",
    description="a cup",
    canonical=CanonicalAsset(source="catalog", key="cup", dimensions=(0.1, 0.1, 0.1), digest="c0"),
)


def _seen(node: str, pixels: float, **fields: object) -> SubjectView:
    usual = {"visible_fraction": 0.9, "in_frame_fraction": 0.95, "face": (0.5, 0.4), "face_visible": 0.9}
    return SubjectView.model_validate({"node_id": node, "pixels": pixels, **usual, **fields})


def _shot(**fields: object) -> ShotContext:
    usual: dict[str, object] = {
        "scene_id": 1,
        "shot_id": 1,
        "on_stage": ("mara",),
        "in_frame": ("mara",),
        "states": (BodyState(asset_id="mara"),),
        "character_actions": (
            CharacterAction(asset_id="mara", action_description="takes a cup", motion="take", prop_id="cup"),
        ),
        "camera_instruction": CameraInstruction(focus_on_ids=("mara",), size="MS"),
        "cues": (Cue(asset_id="mara", clip="take", start=4, prop_id="cup"),),
        "duration": 96,
    }
    return ShotContext.model_validate({**usual, **fields})


def _view(*subjects: SubjectView, shot: ShotContext | None = None, **fields: object) -> FrameView:
    usual: dict[str, object] = {
        "shot": shot or _shot(),
        "seen": CameraView(subjects=subjects, void=0.0),
        "people": frozenset({"mara"}),
        "picture": PictureMeasure(flat=0.2, brightness=0.3),
        "assets": {"cup": _CUP},
        "nodes": {},
    }
    return FrameView(**{**usual, **fields})  # pyright: ignore[reportArgumentType]


_GOOD = (_seen("mara", 0.2), _seen("cup", 0.002, face=None))


def _faults(view: FrameView) -> set[str]:
    return {fault.kind for fault in FrameCritic().judge(view).faults}


def test_a_frame_that_shows_its_lines_passes() -> None:
    critique = FrameCritic().judge(_view(*_GOOD))
    assert critique.faults == () and verdict_of(critique.score) == "pass"


@pytest.mark.parametrize(
    ("view", "fault"),
    [
        (_view(_GOOD[1]), "person_missing"),
        (_view(_seen("mara", 0.01), _GOOD[1]), "person_small"),
        (_view(_GOOD[0]), "thing_missing"),
        (_view(*_GOOD, seen=CameraView(subjects=_GOOD, void=0.3)), "void"),
        (_view(*_GOOD, seen=CameraView(subjects=_GOOD, void=0.0, foreground=0.5)), "foreground"),
        (_view(*_GOOD, picture=PictureMeasure(flat=0.8, brightness=0.3)), "flat"),
        (_view(*_GOOD, picture=PictureMeasure(flat=0.2, brightness=0.01)), "dark"),
        (_view(*_GOOD, staged=(Flaw(kind="no_path", subject="mara", message="no way"),)), "no_path"),
        (
            _view(*_GOOD, shot=_shot(flags=(Flag(topic="action", choice="juggles", reason="not staged"),))),
            "not_staged_action",
        ),
    ],
)
def test_what_is_wrong_with_a_frame_is_named_and_costs(view: FrameView, fault: str) -> None:
    critique = FrameCritic().judge(view)
    assert fault in {each.kind for each in critique.faults}
    assert critique.score < FrameCritic().judge(_view(*_GOOD)).score


_TOM = _seen("tom", 0.1)
_TWO = {"on_stage": ("mara", "tom"), "in_frame": ("mara", "tom"), "character_actions": (), "cues": ()}
_BOTH = frozenset({"mara", "tom"})


def _asks(**fields: object) -> ShotContext:
    usual = {"focus_on_ids": ("mara",), "size": "MS", **fields}
    return _shot(**_TWO, camera_instruction=CameraInstruction.model_validate(usual))


@pytest.mark.parametrize(
    ("shot", "good", "bad", "kind"),
    [
        (_asks(kind="ots", over_id="tom"), (_GOOD[0], _TOM), (_GOOD[0], _seen("tom", 0.001)), "no_shoulder"),
        (_asks(kind="pov", pov_id="tom"), (_GOOD[0],), (_GOOD[0], _TOM), "pov_seen"),
        (_asks(), (_GOOD[0], _TOM), (_GOOD[0], _seen("tom", 0.3, face=(0.5, -0.2))), "headless"),
        (_asks(kind="insert", size="CU"), (_seen("mara", 0.1),), (_seen("mara", 0.001),), "detail_missing"),
    ],
)
def test_a_picture_without_what_its_kind_promises_is_no_such_picture(
    shot: ShotContext, good: tuple[SubjectView, ...], bad: tuple[SubjectView, ...], kind: str
) -> None:
    assert kind not in _faults(_view(*good, shot=shot, people=_BOTH))
    assert kind in _faults(_view(*bad, shot=shot, people=_BOTH))


def test_a_two_shot_needs_both_even_where_the_camera_left_one_out() -> None:
    shot = _asks(kind="two_shot", focus_on_ids=("mara", "tom"))
    assert "partner_missing" not in _faults(_view(_GOOD[0], _TOM, shot=shot, people=_BOTH))
    alone = CameraState(
        poses=(CameraPose(frame=0, pivot=(0, 0, 0), rotation=(1, 0, 0, 0), distance=1, lens=50),), leaves_out=("tom",)
    )
    left = shot.model_copy(update={"camera": alone})
    critique = FrameCritic().judge(_view(_GOOD[0], shot=left, people=_BOTH))
    assert [fault.subject for fault in critique.faults if fault.kind == "partner_missing"] == ["tom"]
    assert verdict_of(critique.score) != "pass"


def test_a_close_picture_of_a_thing_is_close() -> None:
    shot = _asks(kind="action", size="CU", focus_on_ids=("cup",))
    boxes = {"wide": (0.48, 0.48, 0.52, 0.52), "close": (0.2, 0.2, 0.7, 0.7)}
    small, large = (_view(_seen("cup", 0.002, box=box, face=None), shot=shot) for box in boxes.values())
    assert "thing_small" in _faults(small) and "thing_small" not in _faults(large)


def test_the_face_of_a_speaker_is_asked_for_and_of_others_not() -> None:
    away = (_seen("mara", 0.2, face_angle=170.0), _GOOD[1])
    assert "face_away" not in _faults(_view(*away))
    speaks = CharacterAction(asset_id="mara", action_description="speaks", motion="talk")
    assert "face_away" in _faults(_view(*away, shot=_shot(character_actions=(speaks,))))


def test_a_part_that_is_absent_is_not_asked_for() -> None:
    assert "thing_missing" not in _faults(_view(_GOOD[0], shot=_shot(absent=("cup",))))


def test_flat_is_the_largest_plain_surface() -> None:
    picture = np.zeros((180, 320, 3), np.uint8)
    picture[:, :80] = 200
    noise = np.random.default_rng(1).integers(0, 255, (180, 160, 3))
    picture[:, 160:] = noise
    measure = measure_picture(picture)
    assert measure.flat == pytest.approx(0.25, abs=0.03)
    assert measure_picture(np.full((90, 160, 3), 90, np.uint8)).flat == 1.0


def _pair(size: str, *xs: float, head: float = 0.1, kind: str = "two_shot") -> FrameView:
    faces = zip(("mara", "tom"), xs, strict=True)
    subjects = tuple(_seen(who, 0.1, face=(x, 0.4), head_height=head) for who, x in faces)
    instruction = CameraInstruction.model_validate({"focus_on_ids": ("mara", "tom"), "size": size, "kind": kind})
    shot = _shot(
        on_stage=("mara", "tom"), in_frame=("mara", "tom"), character_actions=(), camera_instruction=instruction
    )
    return _view(*subjects, shot=shot)


@pytest.mark.parametrize(
    ("view", "apart"),
    [
        (_pair("MS", 0.1, 0.9), True),
        (_pair("MS", 0.3, 0.7), False),
        (_pair("MS", 0.1, 0.9, head=0.3), False),
        (_pair("WS", 0.1, 0.9), False),
        (_pair("MS", 0.1, 0.9, kind="ots"), False),
    ],
)
def test_people_at_the_sides_of_an_empty_middle_are_a_fault_of_pictures_that_are_not_wide(
    view: FrameView, apart: bool
) -> None:
    assert ("apart" in _faults(view)) == apart


def test_whom_the_camera_leaves_out_is_not_asked_for() -> None:
    speaks = CharacterAction(asset_id="tom", action_description="speaks", motion="talk")
    pose = CameraPose(pivot=(0, 0, 1), rotation=(1, 0, 0, 0), distance=3, lens=50)
    for left, missing in (((), True), (("tom",), False)):
        camera = CameraState(poses=(pose,), leaves_out=left)
        shot = _shot(on_stage=("mara", "tom"), character_actions=(speaks,), camera=camera)
        assert ("person_missing" in _faults(_view(_seen("mara", 0.2), shot=shot))) == missing


def test_a_picture_of_backs_fails_unless_somebody_walks_off() -> None:
    away = (_seen("mara", 0.2, face_angle=150.0), _GOOD[1])
    assert "backs" in _faults(_view(*away))
    walks = CharacterAction(asset_id="mara", action_description="walks off", motion="walk")
    assert "backs" not in _faults(_view(*away, shot=_shot(character_actions=(walks,))))


def test_of_two_who_talk_one_face_is_seen() -> None:
    both = ("mara", "tom")
    speak = tuple(CharacterAction(asset_id=who, action_description="speaks", motion="talk") for who in both)
    instruction = CameraInstruction(focus_on_ids=both, size="MS", kind="two_shot")
    shot = _shot(on_stage=both, in_frame=both, character_actions=speak, camera_instruction=instruction)
    for second, away in ((20.0, False), (170.0, True)):
        seen = (_seen("mara", 0.2, face_angle=170.0), _seen("tom", 0.2, face_angle=second))
        assert ("face_away" in _faults(_view(*seen, shot=shot, people=frozenset(both)))) == away


def test_the_mask_of_a_point_of_view_is_no_plain_wall() -> None:
    picture = PictureMeasure(flat=0.8, brightness=0.03)
    for through, minded in ((None, True), ("keyhole", False)):
        instruction = CameraInstruction(focus_on_ids=("mara",), size="MS", kind="pov", through=through)
        faults = _faults(_view(*_GOOD, shot=_shot(camera_instruction=instruction), picture=picture))
        assert bool(faults & {"flat", "dark"}) == minded


@pytest.mark.parametrize(("size", "y", "cut"), [("FS", 0.04, True), ("FS", 0.2, False), ("CU", 0.04, False)])
def test_a_head_cut_by_the_top_of_the_picture_fails_where_all_of_it_is_wanted(size: str, y: float, cut: bool) -> None:
    shot = _shot(camera_instruction=CameraInstruction.model_validate({"focus_on_ids": ("mara",), "size": size}))
    view = _view(_seen("mara", 0.2, face=(0.5, y), head_height=0.14), _seen("cup", 0.01), shot=shot)
    assert any("cut by the frame" in fault.message for fault in FrameCritic().judge(view).faults) == cut


def _told(*motions: str, **fields: object) -> ShotContext:
    acts = tuple(CharacterAction(asset_id="mara", action_description=each, motion=each) for each in motions)
    return _shot(character_actions=acts, **fields)


def _cue(clip: str, start: int, **fields: object) -> Cue:
    return Cue.model_validate({"asset_id": "mara", "clip": clip, "start": start, **fields})


def _score(shot: ShotContext, **fields: object) -> float:
    return FrameCritic().judge(_view(*_GOOD, shot=shot, **fields)).score


def test_a_told_deed_that_nobody_does_does_not_pass() -> None:
    waved = _told("wave", cues=(_cue("wave", 4),))
    assert "not_done" not in _faults(_view(*_GOOD, shot=waved))
    idle = _told("wave", cues=())
    assert "not_done" in _faults(_view(*_GOOD, shot=idle))
    assert verdict_of(_score(waved)) == "pass" != verdict_of(_score(idle))


def test_a_deed_done_at_another_moment_than_the_drawn_one_does_not_pass() -> None:
    both = _told("salute", "wave", cues=(_cue("salute", 4, duration=10), _cue("wave", 60)), duration=140)
    assert verdict_of(_score(both)) != "pass"
    assert _score(both) > _score(_told("salute", "wave", cues=())), "one of two is more than none"
    lasting = _told("salute", "wave", cues=(_cue("salute", 4, lasting=True), _cue("wave", 60)), duration=140)
    assert "not_done" not in _faults(_view(*_GOOD, shot=lasting))


def test_looks_and_what_is_in_the_hand_already_need_no_moment_of_their_own() -> None:
    assert "not_done" not in _faults(_view(*_GOOD, shot=_told("look", cues=())))
    holds = CharacterAction(asset_id="mara", action_description="holds a cup", motion="hold", prop_id="cup")
    state = BodyState(asset_id="mara", held=("cup",))
    assert "not_done" not in _faults(_view(*_GOOD, shot=_shot(character_actions=(holds,), states=(state,), cues=())))


def test_a_group_that_does_one_thing_does_it_if_one_of_them_does() -> None:
    acts = tuple(
        CharacterAction(asset_id=f"mara_{number}", action_description="they wave", motion="wave") for number in (1, 2)
    )
    waving = (Cue(asset_id="mara_2", clip="wave", start=4),)
    shot = _shot(character_actions=acts, on_stage=("mara", "mara_1", "mara_2"), cues=waving)
    assert "not_done" not in _faults(_view(*_GOOD, shot=shot))
    assert "not_done" in _faults(_view(*_GOOD, shot=shot.model_copy(update={"cues": ()})))


def test_hands_at_work_are_not_turned_away_from_the_camera() -> None:
    back = (_seen("mara", 0.2, face_angle=150.0), _GOOD[1])
    assert "back_to_deed" in _faults(_view(*back))
    assert "back_to_deed" not in _faults(_view(*_GOOD))
    behind = CameraInstruction(focus_on_ids=("mara",), size="MS", behind=True)
    assert "back_to_deed" not in _faults(_view(*back, shot=_shot(camera_instruction=behind)))


@pytest.mark.parametrize("kind", ["unreachable", "late", "crossing", "no_path", "no_support", "missing"])
def test_no_frame_passes_in_which_the_staging_failed_and_it_counts_once(kind: str) -> None:
    flaw = Flaw(kind=kind, subject="mara", message="not as told")
    once, twice = (FrameCritic().judge(_view(*_GOOD, staged=(flaw,) * times)).score for times in (1, 2))
    assert verdict_of(once) != "pass"
    assert once == twice


def test_a_plain_thing_in_a_hand_is_a_stand_in_though_nothing_is_done_with_it() -> None:
    plain = CanonicalAsset(source="stand_in", key="box", dimensions=(0.1, 0.1, 0.1), digest="b0")
    horn = Asset(asset_id="horn", asset_type="object", description="a horn", canonical=plain)
    holds = _told("wave", cues=(_cue("wave", 4),), states=(BodyState(asset_id="mara", held=("horn",)),))
    assert "stand_in" in _faults(_view(*_GOOD, shot=holds, assets={"cup": _CUP, "horn": horn}))
    assert "stand_in" not in _faults(_view(*_GOOD, shot=holds, assets={"cup": _CUP}))


@pytest.mark.parametrize(("score", "focus", "loose"), [(6.5, False, True), (8.0, False, False), (8.0, True, True),
                                                       (9.5, True, False), (None, True, False)])  # fmt: skip
def test_what_the_library_has_only_loosely_does_not_pass(score: float | None, focus: bool, loose: bool) -> None:
    assert _CUP.canonical is not None
    cup = _CUP.model_copy(update={"canonical": _CUP.canonical.model_copy(update={"match_score": score})})
    about = CameraInstruction(focus_on_ids=("mara", "cup") if focus else ("mara",), size="MS")
    view = _view(*_GOOD, shot=_shot(camera_instruction=about), assets={"cup": cup})
    assert ("loose_match" in _faults(view)) is loose
    assert (verdict_of(FrameCritic().judge(view).score) != "pass") is loose


def test_a_posture_taken_before_and_the_way_to_a_deed_are_shown_by_it() -> None:
    kneels = _told("kneel", "wave", cues=(_cue("kneel", 4), _cue("wave", 60)), duration=140)
    comes = _told("walk", "wave", cues=(_cue("walk", 4), _cue("wave", 60)), duration=140)
    assert "not_done" not in _faults(_view(*_GOOD, shot=kneels)) | _faults(_view(*_GOOD, shot=comes))
