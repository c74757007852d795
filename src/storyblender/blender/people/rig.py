"""The armature of a person, and the measured ``Body`` that the motion solver works with."""

from __future__ import annotations

import bpy
import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.people.body import Body
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON

Floats = NDArray[np.float64]
Joints = dict[str, Floats]

SHORTEST = 0.005
STUB = Vector((0.0, -0.03, 0.0))
"""Tail of a bone whose joints coincide."""


def build_armature(name: str, joints: Joints) -> bpy.types.Object:
    """Return an armature object at the origin with the 35 bones of the skeleton.

    Args:
        name: Of the object and its data.
        joints: Positions of the joints that the skeleton names, metres.
    """
    data = bpy.data.armatures.new(name)
    armature = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    for bone in SKELETON:
        edit = data.edit_bones.new(bone.name)
        edit.head, edit.tail = joints[bone.head], joints[bone.tail]
        if (edit.tail - edit.head).length < SHORTEST:
            edit.tail = edit.head + STUB
        lies_flat = bone.name.startswith(("foot", "toe", "eye", "jaw"))
        edit.align_roll((0, 0, 1) if lies_flat else (0, -1, 0))
        if bone.parent:
            edit.parent = data.edit_bones[bone.parent]
    bpy.ops.object.mode_set(mode="OBJECT")
    for pose_bone in armature.pose.bones:
        pose_bone.rotation_mode = "QUATERNION"
    data.display_type = "STICK"
    return armature


def measure_body(
    armature: bpy.types.Object, vertices: Floats, weights: Floats, stature: float, shape_keys: tuple[str, ...]
) -> Body:
    """Return the rest state of a person; weights are put in the order of the armature's bones, by name.

    Args:
        armature: From ``build_armature``.
        vertices: (V, 3) skin, metres.
        weights: (V, 35) columns as in ``SKELETON``.
        stature: Metres.
        shape_keys: Names of the face's shape keys.
    """
    bones = list(armature.data.bones)
    names = tuple(bone.name for bone in bones)
    return Body(
        bone_names=names,
        parents=tuple(names.index(bone.parent.name) if bone.parent else -1 for bone in bones),
        rest=np.array([bone.matrix_local for bone in bones], float),
        heads=np.array([bone.head_local for bone in bones], float),
        tails=np.array([bone.tail_local for bone in bones], float),
        stature=stature,
        vertices=vertices,
        weights=weights[:, [BONE_INDEX[name] for name in names]],
        shape_keys=shape_keys,
    )
