"""Keys of a rig's controls in every shot: where the limbs are, so that a limb that is switched to IK stays there."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np

from storyblender.blender.motion.bake import write_curves
from storyblender.blender.motion.baked import bag_of, pose_matrices, quaternions, read_channels
from storyblender.blender.people.control_rig import LOOK_AT, LOOK_AWAY, limbs_of, pole_keys, scale_of
from storyblender.geometry.solids import Floats

PLACE, TURN, FAR = 0.0005, 0.004, 0.003
"""Tolerances of the keys: metres of hands and feet, of quaternions, and metres of poles and of what is looked at."""


def key_controls(rigs: Sequence[bpy.types.Object]) -> None:
    """Key the controls of rigs in all their strips.

    Args:
        rigs: Armature objects with controls, and a strip of baked motion for each shot.
    """
    for rig in rigs:
        data = rig.animation_data
        for strip in (strip for track in data.nla_tracks for strip in track.strips) if data else ():
            bag = bag_of(strip.action, strip.action_slot)
            if bag is not None:
                _key_strip(rig.data, bag, np.arange(strip.action_frame_start, strip.action_frame_end))


def _key_strip(rig: bpy.types.Armature, bag: bpy.types.ActionChannelbag, frames: Floats) -> None:
    poses, scale = pose_matrices(rig, read_channels(bag, frames)), scale_of(rig)

    def place(name: str, points: Floats, tolerance: float) -> None:
        """Key a control to points (N, 3) in armature space; its parent, the root, is at rest."""
        back = np.array(rig.bones[name].matrix_local.inverted())
        values = points @ back[:3, :3].T + back[:3, 3]
        write_curves(bag, f'pose.bones["{name}"].location', frames, values, tolerance, name)

    for limb in limbs_of(rig):
        end, middle = poses[limb.end], poses[limb.lower][:, :3, 3]
        turn = np.array(rig.bones[limb.control].matrix_local.inverted())[:3, :3] @ end[:, :3, :3]
        place(limb.control, end[:, :3, 3], PLACE)
        path = f'pose.bones["{limb.control}"].rotation_quaternion'
        write_curves(bag, path, frames, quaternions(turn), TURN, limb.control)
        pole, angle = pole_keys(limb, poses[limb.upper], middle, end[:, :3, 3], scale)
        place(limb.pole, pole, FAR)
        path = f'pose.bones["{limb.lower}"].constraints["{limb.switch}"].pole_angle'
        write_curves(bag, path, frames, angle[:, None], TURN, limb.pole)
    if LOOK_AT in rig.bones:
        head = poses["head"]
        place(LOOK_AT, head[:, :3, 3] + LOOK_AWAY * scale * head[:, :3, 2], FAR)
