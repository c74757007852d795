"""Takes objects out of a picture for a while, even those whose visibility is keyed shot by shot."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

import bpy

_PATH = "hide_render"


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
    data = obj.animation_data
    if data is None or data.action is None or data.action_slot is None:
        return []
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [curve for bag in bags if bag is not None for curve in bag.fcurves if curve.data_path == _PATH]
