"""Doors swing for whoever comes through or opens them; their leaves carry the keys."""

from __future__ import annotations

import dataclasses
import math

import bpy
import numpy as np
import pytest

from storyblender.blender.doors import Door, swing_doors
from storyblender.blender.motion.plan import Performance, PersonTrack
from storyblender.blender.sets.build import build_set
from storyblender.catalog.openings import openings_of
from storyblender.catalog.set_plan import Opening, SetPlan, Wall
from storyblender.memory.scene_context import SceneSize
from storyblender.memory.shot_context import Cue

pytestmark = pytest.mark.blender
FPS, FRAMES = 24, 96
LEAF = Opening(name="door_1", kind="door", x=1.0, width=0.9, height=2.0)
WALL = Wall(node_id="wall", start=(3.0, 2.0), end=(-3.0, 2.0), height=2.6, material="plaster_cream", openings=(LEAF,))
PLAN = SetPlan(
    kit="room", indoor=True, size=SceneSize(x=3, x_negative=-3, y=2, y_negative=-2), walls=(WALL,)
)  # fmt: skip


def _performance(start: tuple[float, float], end: tuple[float, float]) -> Performance:
    share = np.linspace(0, 1, FRAMES)[:, None]
    root = np.zeros((FRAMES, 4))
    root[:, :2] = np.array(start) * (1 - share) + np.array(end) * share
    empty = np.zeros((FRAMES, 0))
    track = PersonTrack((), root, np.zeros((FRAMES, 3)), np.zeros((FRAMES, 0, 4)), (), empty, np.zeros(FRAMES))
    return Performance(FPS, np.arange(FRAMES), {"rick": track}, {}, (), {})


def _door() -> Door:
    return Door(openings_of(WALL)[0], FPS)


def test_the_handle_is_on_the_room_side_away_from_the_hinge() -> None:
    (place,) = openings_of(WALL)
    assert place.location[:2] == pytest.approx((1.55, 2.0))
    assert (math.sin(place.yaw), -math.cos(place.yaw)) == pytest.approx((0, -1), abs=1e-9)
    x, y, _ = place.handle
    assert x < -0.3, "the leaf hangs at the wall's start, its own +X"
    assert y < 0


def test_a_door_stands_open_for_who_comes_in_and_shuts_behind() -> None:
    door = _door()
    door.play(_performance((1.55, 1.5), (1.55, -2.0)), (), FRAMES)
    assert door.amounts[0] == 1.0
    assert door.amounts[-1] == 0.0
    assert np.abs(np.diff(door.amounts)).max() < 0.06, "the leaf swings, it does not jump"


def test_who_stands_by_a_door_leaves_it_shut_and_who_opens_it_leaves_it_open() -> None:
    door = _door()
    still = _performance((1.55, 1.5), (1.6, 1.4))
    door.play(still, (), FRAMES)
    assert set(door.amounts) == {0.0}
    door.play(still, (Cue(asset_id="rick", clip="open", start=10, target_id="door_1"),), FRAMES)
    assert door.amounts[FRAMES + 20] == 0.0
    assert door.amounts[-1] == 1.0


def test_the_leaf_is_keyed_where_its_movement_begins_and_ends() -> None:
    scene = bpy.context.scene
    objects = build_set(PLAN, scene, scene.collection)
    door = _door()
    door.play(_performance((1.55, 1.5), (1.55, -2.0)), (), FRAMES)
    swing_doors([door], objects)
    (leaf,) = (obj for obj in objects if "opening" in obj)
    angles = []
    for frame in (1, FRAMES):
        scene.frame_set(frame)
        angles.append(leaf.rotation_euler[2] - leaf["shut"])
    assert angles == pytest.approx([leaf["swing"], 0.0], abs=1e-4)
    curve = leaf.animation_data.action.layers[0].strips[0].channelbags[0].fcurves[0]
    assert len(curve.keyframe_points) <= 5


def test_the_leaf_moves_when_the_hand_does_not_when_the_walk_to_it_begins() -> None:
    door = _door()
    still = dataclasses.replace(_performance((1.55, 1.5), (1.6, 1.4)), grasps={("rick", 5): 2.5})
    door.play(still, (Cue(asset_id="rick", clip="open", start=5, target_id="door_1"),), FRAMES)
    first = next(frame for frame, amount in enumerate(door.amounts) if amount > 0)
    assert first == pytest.approx(2.5 * FPS, abs=1)
