"""Visibility keyed shot by shot."""

from __future__ import annotations

import bpy
import pytest

from storyblender.blender.hiding import is_hidden, key_hidden


@pytest.fixture
def obj() -> bpy.types.Object:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    made = bpy.data.objects.new("ada", None)
    bpy.context.scene.collection.objects.link(made)
    return made


def _hidden(obj: bpy.types.Object, frames: list[int]) -> list[bool]:
    seen = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        assert obj.hide_render == obj.hide_viewport == is_hidden(obj, frame)
        seen.append(obj.hide_render)
    return seen


def test_who_enters_later_is_hidden_from_the_first_frame_on(obj: bpy.types.Object):
    key_hidden(obj, [(1, False), (50, True), (90, True)])
    assert obj.hide_render, "also before the timeline moves"
    assert _hidden(obj, [1, 49, 50, 120]) == [True, True, False, False]


def test_new_keys_take_the_place_of_former_ones(obj: bpy.types.Object):
    key_hidden(obj, [(1, False), (50, True), (90, False)])
    key_hidden(obj, [(1, False), (90, True)])
    assert _hidden(obj, [1, 50, 90]) == [True, True, False]
    key_hidden(obj, [(1, True), (90, True)])
    assert _hidden(obj, [1, 90]) == [False, False]


def test_who_is_always_seen_gets_no_keys(obj: bpy.types.Object):
    key_hidden(obj, [(1, True), (50, True)])
    assert obj.animation_data is None
