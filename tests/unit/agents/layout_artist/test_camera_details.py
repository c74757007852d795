"""Inserts of a part of somebody: the hand that acts, not the face it belongs to."""

import math
from dataclasses import replace

import pytest
from test_camera_operator import ANNA, TOM, view_of

from storyblender.agents.layout_artist.camera_details import detail_box, held_box
from storyblender.agents.layout_artist.camera_operator_view import Moment
from storyblender.agents.layout_artist.camera_scout import scout_takes, take_cost
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Figure, project
from storyblender.memory.shot_context import CameraInstruction, Cue, PropState, ShotContext
from storyblender.memory.vocabulary import BodyPart

LEFT, RIGHT = (-0.4, -0.2, 0.9), (-0.3, 0.25, 1.0)
HANDED = Figure(ANNA.node_id, ANNA.face, ANNA.forward, ANNA.head, ANNA.base, (LEFT, RIGHT))


def shot(part: BodyPart, **more) -> ShotContext:
    wish = CameraInstruction(focus_on_ids=("anna",), kind="insert", size="CU", detail=part)
    return ShotContext(scene_id=1, shot_id=1, camera_instruction=wish, **more)


def middle(box: Box | None) -> tuple[float, float, float]:
    assert box is not None
    return box.x, box.y, box.z + box.height / 2


def test_the_hand_is_the_one_that_acts_or_holds_or_reaches_furthest() -> None:
    moments = [Moment(0, (HANDED, TOM))]
    cue = Cue(asset_id="anna", clip="pick_up", start=0, hand="L")
    holds = PropState(asset_id="cup", held_by="anna", hand="L")
    assert middle(detail_box(shot("hand", cues=(cue,)), moments)) == pytest.approx(LEFT)
    assert middle(detail_box(shot("hand", prop_states=(holds,)), moments)) == pytest.approx(LEFT)
    assert middle(detail_box(shot("hand"), moments)) == pytest.approx(RIGHT), "she looks to +X"


def test_a_hand_by_the_hip_is_seen_from_its_side() -> None:
    by_hip = Figure("anna", ANNA.face, ANNA.forward, ANNA.head, ANNA.base, ((-0.5, -0.5, 0.8), RIGHT))
    cue = Cue(asset_id="anna", clip="pick_up", start=0, hand="L")
    box = detail_box(shot("hand", cues=(cue,)), [Moment(0, (by_hip,))])
    assert box is not None and 15 < math.degrees(box.yaw) < 60, "between her front, +X, and -Y"


def test_eyes_are_above_the_mouth_and_feet_on_the_floor() -> None:
    moments = [Moment(0, (HANDED,))]
    eyes, mouth = (middle(detail_box(shot(part), moments))[2] for part in ("eyes", "mouth"))
    feet = detail_box(shot("feet"), moments)
    assert eyes > HANDED.face[2] > mouth and feet is not None and feet.z == 0
    assert detail_box(shot("hand"), [Moment(0, (TOM,))]) is None, "she is not there"


def test_what_is_held_is_at_the_hand() -> None:
    assert middle(held_box(HANDED, "R", (0.1, 0.1, 0.2))) == pytest.approx(RIGHT)
    assert held_box(HANDED, None, (0.1, 0.1, 0.2)).z < HANDED.face[2]


def test_an_insert_frames_the_hand_from_where_nobody_stands_before_it() -> None:
    box = Box(-0.35, 0.1, 0.9, 0.2, 0.2, 0.2)
    view = view_of((HANDED, TOM), kind="insert", size="CU", focus_on_ids=("anna",), detail=box)
    assert view.people == () and view.things == (box,)
    camera = scout_takes(view)[0].camera
    (hand, face), _ = project(camera, [middle(box), HANDED.face])
    assert hand == pytest.approx((0.5, 0.5), abs=0.1)
    assert not ((face > 0) & (face < 1)).all()


def test_what_a_hand_lies_in_does_not_hide_it_and_what_stands_before_it_does() -> None:
    box = Box(-0.35, 0.1, 0.5, 0.2, 0.2, 0.2)
    wish = {"kind": "insert", "size": "CU", "focus_on_ids": ("anna",), "detail": box}
    free = view_of((HANDED,), **wish)
    take = scout_takes(free)[0]
    chair, screen = Box(-0.35, 0.1, 0.0, 0.5, 0.5, 0.9), Box(-0.35, -0.5, 0.0, 2.5, 0.1, 2.5)
    price = take_cost(free, take)
    assert take_cost(view_of((HANDED,), props={"chair": chair}, **wish), take) < price + 1
    assert take_cost(view_of((HANDED,), props={"screen": screen}, **wish), take) > price + 2


def test_the_top_of_a_table_hides_the_hand_below_it() -> None:
    box = Box(0.4, -0.1, 0.25, 0.2, 0.2, 0.2)
    table = Box(0.6, -0.6, 0.0, 1.4, 1.4, 0.85)
    view = view_of((HANDED,), kind="insert", size="CU", focus_on_ids=("anna",), detail=box, props={"table": table})
    turns = (compose_take(view, turn) for turn in range(-180, 180, 15))
    across = min(turns, key=lambda take: take.camera.position[1])
    bare = replace(view, props={})
    assert take_cost(view, across) > take_cost(bare, across) + 2
    assert take_cost(view, scout_takes(view)[0]) < take_cost(view, across) - 1, "it is seen from where the table ends"


def test_whoever_holds_what_an_insert_shows_does_not_stand_aside() -> None:
    orange = held_box(HANDED, "R", (0.08, 0.08, 0.08))
    wish = {"kind": "insert", "size": "CU", "focus_on_ids": ("orange",), "props": {"orange": orange}}
    view = view_of((HANDED, TOM), carried={"anna": ("orange",)}, **wish)
    assert view.strangers == ("tom",)
    assert not {"anna", "orange"} & {*scout_takes(view)[0].hidden}
