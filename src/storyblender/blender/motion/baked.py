"""Baked motion read back: the channels of a strip, frame by frame, and the poses that they make."""

from __future__ import annotations

import re
from collections.abc import Iterator

import bpy
import numpy as np
from mathutils import Matrix

from storyblender.geometry.solids import Floats

_CHANNEL = re.compile(r'pose\.bones\["(?P<bone>[^"]+)"\]\.(?P<kind>location|rotation_quaternion)')

Channels = dict[str, Floats]
"""Values (N, C) by data path; quaternions are not normalised."""


def bag_of(action: bpy.types.Action | None, slot: bpy.types.ActionSlot | None) -> bpy.types.ActionChannelbag | None:
    """Return the curves that an action has for a slot."""
    if action is None or slot is None or not action.layers or not action.layers[0].strips:
        return None
    return action.layers[0].strips[0].channelbag(slot)


def bags_of(obj: bpy.types.Object) -> Iterator[bpy.types.ActionChannelbag]:
    """Yield the curves of the strips of an object."""
    data = obj.animation_data
    for strip in (strip for track in data.nla_tracks for strip in track.strips) if data else ():
        bag = bag_of(strip.action, strip.action_slot)
        if bag is not None:
            yield bag


def read_channels(bag: bpy.types.ActionChannelbag, frames: Floats) -> Channels:
    """Return what linear keys play.

    Args:
        bag: Curves of one object.
        frames: (N,) of the action.
    """
    columns: dict[str, dict[int, Floats]] = {}
    for curve in bag.fcurves:
        points = np.empty(2 * len(curve.keyframe_points), np.float32)
        curve.keyframe_points.foreach_get("co", points)
        columns.setdefault(curve.data_path, {})[curve.array_index] = np.interp(frames, points[::2], points[1::2])
    return {path: np.stack([each[index] for index in sorted(each)], axis=1) for path, each in columns.items()}


def pose_matrices(rig: bpy.types.Armature, channels: Channels) -> dict[str, Floats]:
    """Return the poses (N, 4, 4) in armature space of the bones of a rig, parents before children.

    Args:
        rig: The bones at rest.
        channels: Of one object; what is missing is at rest.
    """
    moves: dict[str, dict[str, Floats]] = {}
    for path, values in channels.items():
        if (found := _CHANNEL.fullmatch(path)) is not None:
            moves.setdefault(found["bone"], {})[found["kind"]] = values
    count = max((len(values) for values in channels.values()), default=1)
    poses: dict[str, Floats] = {}
    for bone in rig.bones:  # Blender keeps parents before their children
        rest = bone.matrix_local
        local = np.array(rest if bone.parent is None else bone.parent.matrix_local.inverted() @ rest)
        pose = local @ _basis(moves.get(bone.name, {}), count)
        poses[bone.name] = pose if bone.parent is None else poses[bone.parent.name] @ pose
    return poses


def _basis(moves: dict[str, Floats], count: int) -> Floats:
    """Return the matrices (N, 4, 4) of a bone's own location and rotation."""
    basis = np.tile(np.eye(4), (count, 1, 1))
    if "location" in moves:
        basis[:, :3, 3] = moves["location"]
    if "rotation_quaternion" in moves:
        basis[:, :3, :3] = rotation_matrices(moves["rotation_quaternion"])
    return basis


def rotation_matrices(quaternions: Floats) -> Floats:
    """Return the rotations (N, 3, 3) of quaternions w, x, y, z, which need not be normalised."""
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def quaternions(rotations: Floats) -> Floats:
    """Return the quaternions w, x, y, z (N, 4) of matrices (N, 3, 3) or (N, 4, 4), neighbours on one hemisphere."""
    turns = np.array([Matrix(matrix.tolist()).to_quaternion() for matrix in rotations])
    flips = np.where(np.sum(turns[1:] * turns[:-1], axis=1) < 0, -1.0, 1.0)
    turns[1:] *= np.cumprod(flips)[:, None]
    return turns
