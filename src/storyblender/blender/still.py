"""One moment of a scene with people as plain meshes, so that every further picture of it is cheap.

A render evaluates the whole scene again: rigs, garments, keys (measured: 0.13 s of processor for a dozen people, at any
picture size). A board frame takes nine renders of one moment and a camera a dozen looks; only the first pays for it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy

from storyblender.blender.render.session import DRAWN


@contextmanager
def held_still(scene: bpy.types.Scene, frame: int | None = None) -> Iterator[bpy.types.Scene]:
    """Yield a temporary scene that looks like ``scene`` at one frame.

    Objects that neither move nor bend are shared; the others are posed copies. It contains only what renders: no rigs,
    lamps or cameras. Inside the ``with`` block the window shows ``scene`` at the frame.

    Args:
        scene: The packed scene; it stays at the frame.
        frame: Timeline frame; None for the current one.
    """
    bpy.context.window.scene = scene
    if frame is not None and frame != scene.frame_current:
        scene.frame_set(frame)
    depsgraph = scene.view_layers[0].depsgraph
    depsgraph.update()
    still = bpy.data.scenes.new("still")
    copies: list[bpy.types.ID] = [still]
    try:
        for name in scene.keys():  # noqa: SIM118 - an ID is no mapping: iterating over it gives nothing
            if isinstance(scene[name], bool | int | float | str):
                still[name] = scene[name]
        for obj in scene.objects:
            if obj.type not in DRAWN or obj.hide_render:
                continue
            if obj.modifiers or obj.animation_data or obj.parent or obj.constraints:
                obj = _posed(obj, depsgraph, copies)
            still.collection.objects.link(obj)
        still.frame_set(scene.frame_current)
        yield still
    finally:
        bpy.context.window.scene = scene
        bpy.data.batch_remove(copies)


def _posed(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph, copies: list[bpy.types.ID]) -> bpy.types.Object:
    """Return a copy of an object in its evaluated pose, without what moved it; copies are added to ``copies``."""
    evaluated = obj.evaluated_get(depsgraph)
    copy = obj.copy()
    copies.append(copy)
    copy.animation_data_clear()
    copy.constraints.clear()
    if obj.type == "MESH" and obj.modifiers:
        mesh = bpy.data.meshes.new_from_object(evaluated, preserve_all_data_layers=True, depsgraph=depsgraph)
        copies.append(mesh)
        copy.modifiers.clear()
        copy.data = mesh
    copy.parent = None
    copy.matrix_world = evaluated.matrix_world
    return copy
