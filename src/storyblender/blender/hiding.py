"""Visibility of objects: keys shot by shot, and temporary hiding from a render."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

import bpy

_RENDER, _VIEWPORT = "hide_render", "hide_viewport"


def key_hidden(obj: bpy.types.Object, shown: Sequence[tuple[int, bool]]) -> None:
    """Key the visibility of an object in renders and viewport, replacing earlier keys.

    Args:
        obj: The object; it is left as at the first frame.
        shown: (frame, whether it is visible from there on), in order; keys are written only at changes, and none if it
            is always visible.
    """
    for bag in _bags(obj):
        for curve in [curve for curve in bag.fcurves if curve.data_path in (_RENDER, _VIEWPORT)]:
            bag.fcurves.remove(curve)
    changes = [(frame, seen) for index, (frame, seen) in enumerate(shown) if index == 0 or seen != shown[index - 1][1]]
    keyed = not all(seen for _, seen in shown)
    for frame, seen in reversed(changes):
        obj.hide_render = obj.hide_viewport = not seen
        for path in (_RENDER, _VIEWPORT) if keyed else ():
            obj.keyframe_insert(path, frame=frame)


def is_hidden(obj: bpy.types.Object, frame: int) -> bool:
    """Return whether an object is hidden from renders at a frame of the timeline, by its keys or permanently."""
    curves = _visibility_curves(obj)
    return any(curve.evaluate(frame) > 0.5 for curve in curves) if curves else obj.hide_render


@contextmanager
def out_of_picture(objects: Iterable[bpy.types.Object]) -> Iterator[None]:
    """Hide objects from renders inside ``with``.

    A render evaluates the animation again, and a keyed ``hide_render`` would override the value set here; so its curves
    are muted meanwhile.
    """
    hidden = [(obj, obj.hide_render) for obj in objects]
    curves = [curve for obj, _ in hidden for curve in _visibility_curves(obj) if not curve.mute]
    try:
        for curve in curves:
            curve.mute = True
        for obj, _ in hidden:
            obj.hide_render = True
        yield
    finally:
        for obj, was_hidden in hidden:
            obj.hide_render = was_hidden
        for curve in curves:
            curve.mute = False


def _visibility_curves(obj: bpy.types.Object) -> list[bpy.types.FCurve]:
    """Return the curves of an object's visibility in renders."""
    return [curve for bag in _bags(obj) for curve in bag.fcurves if curve.data_path == _RENDER]


def _bags(obj: bpy.types.Object) -> list[bpy.types.ActionChannelbag]:
    """Return the channel bags of the action that an object plays directly, without its NLA strips."""
    data = obj.animation_data
    if data is None or data.action is None or data.action_slot is None:
        return []
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [bag for bag in bags if bag is not None]
