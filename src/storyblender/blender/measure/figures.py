"""Faces of people, read from their rigs; the Camera Operator frames them."""

from __future__ import annotations

import bpy
import numpy as np
from mathutils import Matrix, Vector

from storyblender.geometry.framing import Figure

_BROW = 1.1
"""Ratio in the body pack: crown above eyes to eyes above chin."""
_SHARE = 0.13
"""Head height over stature, for characters without a rig."""


def figures(scene: bpy.types.Scene, frame: int | None = None) -> tuple[Figure, ...]:
    """Return the faces of all visible people, in the scene's order.

    Args:
        scene: The scene; at its current evaluation if it is the window's scene.
        frame: Timeline frame to go to first, where the scene stays; None for the current one.
    """
    if frame is not None:
        scene.frame_set(frame)
    depsgraph = scene.view_layers[0].depsgraph
    drawn: dict[str, list[bpy.types.Object]] = {}
    for obj in scene.objects:
        if obj.get("kind") == "character" and obj.type == "MESH" and not obj.hide_render:
            drawn.setdefault(str(obj["node_id"]), []).append(obj)
    rigs = {str(obj["node_id"]): obj for obj in scene.objects if obj.type == "ARMATURE" and obj.get("node_id")}
    return tuple(
        _of_rig(node_id, rigs[node_id].evaluated_get(depsgraph))
        if node_id in rigs and "head" in rigs[node_id].pose.bones
        else _of_box(node_id, [part.evaluated_get(depsgraph) for part in parts])
        for node_id, parts in drawn.items()
    )


def _of_rig(node_id: str, rig: bpy.types.Object) -> Figure:
    """Return a figure from a rig: the eyes give the face's middle, the jaw its chin, the head bone its direction."""
    bones, world = rig.pose.bones, rig.matrix_world
    head = bones["head"]
    turned = world.to_3x3() @ head.matrix.to_3x3() @ head.bone.matrix_local.to_3x3().inverted()
    forward, up = (turned @ Vector((0, -1, 0))).normalized(), (turned @ Vector((0, 0, 1))).normalized()
    if "eye.L" in bones and "eye.R" in bones:
        eyes = world @ ((bones["eye.L"].head + bones["eye.R"].head) / 2)
    else:
        eyes = world @ head.tail - up * 0.4 * head.length
    below = (eyes - world @ bones["jaw"].tail).dot(up) if "jaw" in bones else 0.0
    if below <= 0.02:
        below = 0.55 * head.length
    face = eyes + up * below * (_BROW - 1) / 2
    base = world.translation
    hips = world @ bones["hips"].head if "hips" in bones else base
    sides = [bones[name] for name in ("hand.L", "hand.R") if name in bones]
    hands = tuple(tuple(world @ ((hand.head + hand.tail) / 2)) for hand in sides)
    return Figure(node_id, tuple(face), tuple(forward), below * (1 + _BROW), (hips.x, hips.y, base.z), hands)


def _of_box(node_id: str, parts: list[bpy.types.Object]) -> Figure:
    """Return a figure from bounding boxes, for animals and stand-ins without a rig: the top is the head, facing -Y."""
    corners = np.array([part.matrix_world @ Vector(corner) for part in parts for corner in part.bound_box])
    low, high = corners.min(0), corners.max(0)
    head = _SHARE * float(high[2] - low[2])
    turn: Matrix = parts[0].matrix_world.to_3x3()
    forward = (turn @ Vector((0, -1, 0))).normalized()
    x, y = (float(value) for value in (low + high)[:2] / 2)
    return Figure(node_id, (x, y, float(high[2]) - head / 2), tuple(forward), head, (x, y, float(low[2])))
