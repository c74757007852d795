"""How people stand where nobody acts: upright, their arms hanging, as on a costume fitting."""

from __future__ import annotations

import math

import bpy
import mathutils

_DOWN = math.radians(28)
"""How far arms come down from where a rig at rest has them."""
_BENT = math.radians(-6)


def stand_at_ease(armature: bpy.types.Object) -> None:
    """Let the arms of a rig hang.

    Args:
        armature: At rest; it is put into the open scene.
    """
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.update()  # a rig that was appended has no pose before
    for side, sign in (("L", 1), ("R", -1)):
        _turn(armature, f"upper_arm.{side}", (0, 1, 0), sign * _DOWN)
        _turn(armature, f"forearm.{side}", (1, 0, 0), _BENT)


def _turn(armature: bpy.types.Object, name: str, axis: tuple[float, float, float], angle: float) -> None:
    """Turn a bone about an axis of the rig."""
    bone = armature.pose.bones[name]
    rest = bone.bone.matrix_local.to_3x3()
    turn = mathutils.Matrix.Rotation(angle, 3, axis)
    bone.rotation_mode = "QUATERNION"
    bone.rotation_quaternion = (rest.inverted() @ turn @ rest).to_quaternion()
