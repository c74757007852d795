"""Drawings that are held: a frame in which nothing has moved by what an eye could see is the last drawn one again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.framing import Figure
from storyblender.look.gbuffer import View

_SEEN = 0.5
"""Pixels by which a point must move to be seen."""
_LEGIBLE = 14.0
"""Pixels from crown to chin from which the play of a face is seen."""
_PLAY = 0.04
"""Change of a shape key that is seen in a legible face."""
_AROUND = 20.0
"""Pixels beyond the picture's edge where a point still tells of what is in it."""


@dataclass(frozen=True)
class Pose:
    """What may have moved, at one frame.

    Attributes:
        points: (n, 3) joints, world.
        play: (k,) values of shape keys.
        players: node_id of each value's person.
    """

    points: NDArray[np.float64]
    play: NDArray[np.float32]
    players: tuple[str, ...]


def pose_now(scene: bpy.types.Scene) -> Pose:
    """Read joints and shape keys at the scene's frame."""
    rigs = [_joints(obj) for obj in scene.objects if obj.type == "ARMATURE"]
    play: list[NDArray[np.float32]] = []
    players: list[str] = []
    for obj in scene.objects:
        if obj.type == "MESH" and obj.data.shape_keys and not obj.hide_render:
            blocks = obj.data.shape_keys.key_blocks
            values = np.empty(len(blocks), np.float32)
            blocks.foreach_get("value", values)
            play.append(values)
            players += [str(obj.get("node_id", obj.name))] * len(blocks)
    points = np.concatenate([np.zeros((0, 3)), *rigs])
    return Pose(points, np.concatenate([np.zeros(0, np.float32), *play]), tuple(players))


def _joints(rig: bpy.types.Object) -> NDArray[np.float64]:
    tails = np.empty(len(rig.pose.bones) * 3, np.float32)
    rig.pose.bones.foreach_get("tail", tails)
    world = np.array(rig.matrix_world)
    return tails.reshape(-1, 3).astype(np.float64) @ world[:3, :3].T + world[:3, 3]


def drawn_anew(
    poses: Sequence[Pose],
    boxes: NDArray[np.float64],
    shown: NDArray[np.bool_],
    people: Sequence[Sequence[Figure]],
    view: View,
) -> tuple[bool, ...]:
    """Return of each frame whether it differs, to the eye, from the last one drawn.

    Args:
        poses: At each frame.
        boxes: (frames, n, 8, 3) corners of all that may move, world.
        shown: (frames, n) whether each is drawn.
        people: Everybody's face at each frame.
        view: Of the camera, which stands still.
    """
    legible = {figure.node_id for faces in people for figure in faces if _height(figure, view) > _LEGIBLE}
    result: list[bool] = []
    last = 0
    for frame, pose in enumerate(poses):
        before = poses[last]
        anew = frame == 0 or pose.players != before.players or bool((shown[frame] != shown[last]).any())
        if not anew:
            faces = np.array([player in legible for player in pose.players], bool)
            anew = bool((np.abs(pose.play - before.play)[faces] > _PLAY).any())
            anew |= _moved(before.points, pose.points, view)
            anew |= _moved(boxes[last].reshape(-1, 3), boxes[frame].reshape(-1, 3), view)
        result.append(anew)
        last = frame if anew else last
    return tuple(result)


def _height(figure: Figure, view: View) -> float:
    depth = float(view.project(np.asarray(figure.face))[2])
    return figure.head * view.pixels_per_metre / depth if depth > 0 else 0.0


def _moved(before: NDArray[np.float64], now: NDArray[np.float64], view: View) -> bool:
    """Return whether a point in the picture, or coming into it, has moved visibly."""
    places = [view.project(points) for points in (before, now)]
    inside = np.zeros(len(now), bool)
    for column, row, depth in places:
        inside |= (
            (depth > 0)
            & (np.abs(column - view.width / 2) < view.width / 2 + _AROUND)
            & (np.abs(row - view.height / 2) < view.height / 2 + _AROUND)
        )
    (first_column, first_row, _), (column, row, _) = places
    way = np.maximum(np.abs(column - first_column), np.abs(row - first_row))
    return bool((way[inside] > _SEEN).any())
