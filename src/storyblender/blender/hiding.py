"""Who and what is seen when: keys of visibility shot by shot, and objects taken out of a picture for a while."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager

import bpy

_RENDER, _VIEWPORT = "hide_render", "hide_viewport"


def key_hidden(obj: bpy.types.Object, shown: Sequence[tuple[int, bool]]) -> None:
    """Hide an object over time, in renders and in the viewport, in place of what was keyed before.

    Args:
        obj: The object; it is left as it is seen at the first frame.
        shown: Frame and whether it is seen from there on, in order; keys are written only where that changes, and none
            where it is always seen.
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
    """Return whether an object is hidden from renders at a frame of the timeline, by its keys or for good."""
    curves = _visibility_curves(obj)
    return any(curve.evaluate(frame) > 0.5 for curve in curves) if curves else obj.hide_render


@contextmanager
def out_of_picture(objects: Iterable[bpy.types.Object]) -> Iterator[None]:
    """Hide objects from renders inside ``with``.

    A render evaluates the animation again, so a keyed ``hide_render`` would win over the value that is set here;
    its curves are muted meanwhile.
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
    return [curve for bag in _bags(obj) for curve in bag.fcurves if curve.data_path == _RENDER]


def _bags(obj: bpy.types.Object) -> list[bpy.types.ActionChannelbag]:
    """The curves of the action that an object plays by itself, not those of its strips."""
    data = obj.animation_data
    if data is None or data.action is None or data.action_slot is None:
        return []
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [bag for bag in bags if bag is not None]
