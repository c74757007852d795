"""The Camera Operator does what a person asked for, also where it would choose otherwise by itself."""

from __future__ import annotations

from typing import Any

import pytest
from test_camera_operator import ANNA, GUARD, TOM, figure, shoot, view_of

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.geometry.boxes import Box
from storyblender.memory.camera_decision import CameraDecision, CameraInstruction

BOTH = {"focus_on_ids": ("anna", "tom")}


def asked(figures: tuple[Any, ...], now: dict[str, Any], decision: dict[str, Any], **more: Any) -> CameraOperatorView:
    """Return the view of a shot after a decision about its camera, as the graph gives it."""
    said = CameraDecision.model_validate(decision)
    wanted = said.applied(CameraInstruction.model_validate({**now, "explicit": True}))
    return view_of(figures, asked=said, **dict(wanted), **more)


@pytest.mark.parametrize("size", ["MCU", "CU"])
def test_a_tighter_two_shot_still_holds_both(size: str) -> None:
    view = asked(
        (figure("anna", -1.2, 0, 90), figure("tom", 1.2, 0, -90)), {"kind": "two_shot", **BOTH}, {"size": size}
    )
    assert len(view.people) == 2


def test_somebody_asked_for_alone_is_alone_in_the_picture() -> None:
    decision = {"kind": "single", "focus_on_ids": ["tom"], "size": "MCU"}
    alone = asked((ANNA, TOM, GUARD), {}, decision, in_frame=("anna", "tom", "guard"))
    assert {"anna", "guard"} <= set(alone.strangers)
    crew = view_of((ANNA, TOM, GUARD), kind="single", focus_on_ids=("tom",), in_frame=("anna", "tom", "guard"))
    assert not crew.strangers


def test_over_a_shoulder_that_was_asked_for_the_partner_turns_the_back_whatever_they_look_at() -> None:
    tom = figure("tom", 0.6, 0, 20)
    decision = {"kind": "ots", "over_id": "anna", "focus_on_ids": ["tom"], "size": "MS"}
    camera, residual, _ = shoot(asked((ANNA, tom), {}, decision))
    assert ANNA.turned_from(camera.position) > 100
    assert not [flaw for flaw in residual if flaw.kind == "no_shoulder"]


def walk(movement: str | None) -> CameraOperatorView:
    moments = tuple(Moment(frame, (figure("anna", x, 0, 90),)) for frame, x in ((0, -3.0), (24, 0.0), (47, 3.0)))
    decision = {"movement": movement} if movement else {"size": "MS"}
    return asked((), {"kind": "single", "focus_on_ids": ("anna",), "size": "MS"}, decision, moments=moments)


def test_a_camera_that_was_told_to_hold_still_lets_a_walker_go() -> None:
    assert compose_take(walk(None)).moves
    assert not compose_take(walk("static")).moves


def test_a_move_that_was_asked_for_is_made_while_a_group_walks() -> None:
    moments = tuple(
        Moment(frame, (ANNA, figure("tom", x, 0, -90))) for frame, x in ((0, 3.0), (24, 0.6), (47, 0.6))
    )  # fmt: skip
    now = {"kind": "two_shot", "size": "WS", **BOTH}
    assert compose_take(asked((), now, {"movement": "push in"}, moments=moments)).moves
    assert not compose_take(view_of(moments=moments, movement="push in", **now)).moves


def test_an_insert_of_a_large_thing_is_taken_from_near_by() -> None:
    piano = Box(0, 2, 0, 1.5, 0.7, 1.3)
    view = asked((ANNA,), {}, {"kind": "insert", "focus_on_ids": ["piano"], "size": "CU"}, props={"piano": piano})
    near = compose_take(view).camera
    assert near.distance < 4 and near.lens < 85
    lens = {"kind": "insert", "focus_on_ids": ["piano"], "size": "CU", "lens": 85}
    assert compose_take(asked((ANNA,), {}, lens, props={"piano": piano})).camera.lens == 85
