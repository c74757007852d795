"""What is written with meets what is written on, wherever that is."""

from __future__ import annotations

import bpy  # noqa: F401  # mathutils is its
import numpy as np
import pytest
from mathutils import Matrix, Vector
from tests.blender.motion_stage import build_bodies, chair_at, cue_of, mark_at, perform, table_at, world_at

from storyblender.blender.motion.plan import Performance, StageProp
from storyblender.blender.people.body import RiggedBody
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.shot_context import PropState
from storyblender.memory.vocabulary import Hand

PEN, SHEET = (0.012, 0.14, 0.012), (0.21, 0.3, 0.03)
_GRIP = Anchor(
    kind="grip", name="grip_r", location=(-0.02, 0.003, 0.02), direction=(0.5, -0.85, -0.2), normal=(0.75, 0.4, -0.5)
)


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    return build_bodies("man")


def _pen(hand: Hand) -> StageProp:
    state = PropState(asset_id="pen", held_by="man", hand=hand)
    return StageProp(world_at(0, 0, -5), PEN, anchors=(_GRIP,), state=state)


def _apart(shot: Performance, frame: int) -> float:
    """Metres between the nib and the nearest point of the sheet."""
    nib = Vector((shot.props["pen"][frame] @ (0, -PEN[1] / 2, PEN[2] / 2, 1))[:3])
    local = Matrix(shot.props["form"][frame].tolist()).inverted() @ nib
    low, high = np.array((-SHEET[0] / 2, -SHEET[1] / 2, 0)), np.array((SHEET[0] / 2, SHEET[1] / 2, SHEET[2]))
    return float(np.linalg.norm(np.array(local) - np.clip(np.array(local), low, high)))


@pytest.mark.parametrize("clip", ["write", "draw", "cross_out"])
@pytest.mark.parametrize(("pen", "page"), [("R", "L"), ("L", "R")])
def test_a_pen_writes_on_the_page_in_the_other_hand(
    bodies: dict[str, RiggedBody], clip: str, pen: Hand, page: Hand
) -> None:
    held = PropState(asset_id="form", held_by="man", hand=page)
    props = {"pen": _pen(pen), "form": StageProp(world_at(0, 0, -5), SHEET, state=held)}
    mark = mark_at("man", 0, 0, held=((page, "form"), (pen, "pen")))
    shot = perform(bodies, (mark,), (cue_of("man", clip, prop_id="pen", hand=pen, target_id="form"),), 3, props=props)
    assert max(_apart(shot, frame) for frame in (30, 45, 60)) < 0.015


def test_a_pen_writes_on_the_page_that_lies_on_the_table(bodies: dict[str, RiggedBody]) -> None:
    props = {"pen": _pen("R"), "form": StageProp(world_at(0, -0.52, 0.75), SHEET)}
    mark = mark_at("man", 0, -0.24, posture="sit", support_id="chair", anchor_name="seat", held=(("R", "pen"),))
    cue = cue_of("man", "write", prop_id="pen", hand="R", target_id="form")
    furniture = {"chair": chair_at(0, 0), "table": table_at(0, -0.8)}
    shot = perform(bodies, (mark,), (cue,), 3, furniture=furniture, props=props)
    assert max(_apart(shot, frame) for frame in (30, 45, 60)) < 0.015
