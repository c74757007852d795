"""The armature of a person, and the measured ``RiggedBody`` that the motion solver works with."""

from __future__ import annotations

import bpy
import numpy as np
from mathutils import Vector

from storyblender.blender.people.body import RiggedBody
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.geometry.solids import Floats

Joints = dict[str, Floats]

SHORTEST = 0.005
"""Metres; shorter bones get the tail ``STUB``."""
STUB = Vector((0.0, -0.03, 0.0))
"""Head to tail of a bone whose joints coincide, metres."""


def build_armature(name: str, joints: Joints) -> bpy.types.Object:
    """Return an armature object at the origin with the 35 bones of the skeleton.

    Args:
        name: Of the object and its data-block.
        joints: Position of each joint, metres.
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
) -> RiggedBody:
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
    return RiggedBody(
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
