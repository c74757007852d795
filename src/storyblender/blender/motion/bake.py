"""Bakes solved tracks into Blender: one slotted Action per shot, reduced keys, NLA strips named like the shot."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.motion.baked import quaternions
from storyblender.blender.motion.plan import Floats, Performance, PersonTrack

LEGS = ("hips", "thigh", "shin", "foot", "toe")
LEG_TOLERANCE = 0.0003
"""Of quaternion components: planted feet stay within a millimetre (notes: motion, section 6)."""
TOLERANCE = 0.006
"""Of the other bones' quaternion components."""
PLACE_TOLERANCE = 0.0003
"""Metres of root, hips and props; radians of the root's yaw."""
FACE_TOLERANCE = 0.02
SIT_KEY = "sit"
LINEAR = 1


def bake(
    performance: Performance,
    armatures: dict[str, bpy.types.Object],
    props: dict[str, bpy.types.Object],
    name: str,
    frame_start: int,
) -> bpy.types.Action:
    """Write a performance as one Action with a slot per person, face, cloth and prop, and add its strips to the NLA.

    Every strip is named ``name``, begins at ``frame_start`` and has no effect outside the shot.

    Args:
        performance: Solved tracks.
        armatures: Armature object of every person by asset id; meshes are its children.
        props: Object of every prop by asset id, unparented.
        name: Name of the shot, Action and strips, e.g. ``SC010_SH020``. An Action of that name is replaced.
        frame_start: Scene frame of the shot's first frame.

    Returns:
        The Action.
    """
    remove(name)
    action = bpy.data.actions.new(name)
    keys = action.layers.new("motion").strips.new(type="KEYFRAME")
    writer = _ActionWriter(action, keys, performance, frame_start)
    for asset_id, track in performance.people.items():
        armature = armatures.get(asset_id)
        if armature is not None:
            writer.person(asset_id, armature, track)
    for asset_id, matrices in performance.props.items():
        prop = props.get(asset_id)
        if prop is not None:
            writer.prop(asset_id, prop, matrices)
    return action


def remove(name: str) -> None:
    """Remove a shot's Action and all its strips."""
    action = bpy.data.actions.get(name)
    owners = [*bpy.data.objects, *bpy.data.shape_keys]
    for owner in owners:
        data = owner.animation_data
        for track in list(data.nla_tracks) if data else []:
            if track.name == name:
                data.nla_tracks.remove(track)
    if action is not None:
        bpy.data.actions.remove(action)


def reduce_keys(frames: Floats, values: Floats, tolerance: float) -> NDArray[np.int_]:
    """Return the indices of the samples to keep for linear interpolation (Ramer-Douglas-Peucker).

    Args:
        frames: (N,) numbers of the samples, increasing.
        values: (N, C) sampled values.
        tolerance: Largest error of the interpolation in any column, in the unit of the values.
    """
    keep = np.zeros(len(frames), bool)
    keep[[0, -1]] = True
    spans = [(0, len(frames) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        share = ((frames[first + 1 : last] - frames[first]) / (frames[last] - frames[first]))[:, None]
        line = values[first] * (1 - share) + values[last] * share
        error = np.abs(line - values[first + 1 : last]).max(axis=1)
        worst = int(error.argmax())
        if error[worst] > tolerance:
            worst += first + 1
            keep[worst] = True
            spans += [(first, worst), (worst, last)]
    return np.flatnonzero(keep)


class _ActionWriter:
    """Writes tracks into the slots of one Action and strings them into the NLA of their objects."""

    def __init__(self, action: bpy.types.Action, keys: object, performance: Performance, frame_start: int) -> None:
        self.action, self.keys, self.frame_start = action, keys, frame_start
        self.frames = performance.frames.astype(float)
        self.length = float(performance.frames[-1]) + 1

    def person(self, asset_id: str, armature: bpy.types.Object, track: PersonTrack) -> None:
        """Write root and pose bones into one slot, shape keys of face and clothes into slots of their own."""
        armature.rotation_mode = "XYZ"
        bag = self._add_slot("OBJECT", asset_id, [armature])
        yaw = np.zeros((len(track.root), 3))
        yaw[:, 2] = track.root[:, 3]
        self._curves(bag, "location", track.root[:, :3], PLACE_TOLERANCE, "Root")
        self._curves(bag, "rotation_euler", yaw, PLACE_TOLERANCE, "Root")
        self._curves(bag, 'pose.bones["hips"].location', track.hips, PLACE_TOLERANCE, "hips")
        for index, bone in enumerate(track.bone_names):
            if bone not in armature.pose.bones:
                continue
            armature.pose.bones[bone].rotation_mode = "QUATERNION"
            tolerance = LEG_TOLERANCE if bone.startswith(LEGS) else TOLERANCE
            path = f'pose.bones["{bone}"].rotation_quaternion'
            self._curves(bag, path, track.rotations[:, index], tolerance, bone)
        self._shapes(asset_id, armature, track)

    def prop(self, asset_id: str, prop: bpy.types.Object, matrices: Floats) -> None:
        """Write world location and rotation of a prop; its scale stays."""
        prop.rotation_mode = "QUATERNION"
        bag = self._add_slot("OBJECT", asset_id, [prop])
        self._curves(bag, "location", matrices[:, :3, 3], PLACE_TOLERANCE, "Root")
        self._curves(bag, "rotation_quaternion", quaternions(matrices), TOLERANCE / 2, "Root")

    def _shapes(self, asset_id: str, armature: bpy.types.Object, track: PersonTrack) -> None:
        """Write shape keys; meshes that are driven by the same keys share a slot."""
        values = {key: track.face[:, [index]] for index, key in enumerate(track.face_keys)}
        values[SIT_KEY] = track.seated[:, None]
        groups: dict[tuple[str, ...], list[bpy.types.Key]] = {}
        for child in armature.children_recursive:
            keys = child.data.shape_keys if child.type == "MESH" else None
            driven = tuple(key for key in values if keys is not None and key in keys.key_blocks)
            if driven and keys not in groups.setdefault(driven, []):
                groups[driven].append(keys)
        for number, (driven, keys) in enumerate(sorted(groups.items())):
            label = "cloth" if driven == (SIT_KEY,) else f"face{number or ''}"
            bag = self._add_slot("KEY", f"{asset_id}.{label}", keys)
            for key in driven:
                self._curves(bag, f'key_blocks["{key}"].value', values[key], FACE_TOLERANCE, "")

    def _add_slot(self, id_type: str, label: str, owners: list) -> object:
        """Create a slot, add a strip of it to each owner's NLA, and return the slot's channel bag."""
        slot = self.action.slots.new(id_type, label)
        for owner in owners:
            data = owner.animation_data_create()
            data.action = None
            track = data.nla_tracks.new()
            track.name = self.action.name
            strip = track.strips.new(self.action.name, self.frame_start, self.action)
            strip.action_slot = slot
            strip.name = self.action.name
            strip.action_frame_start, strip.action_frame_end = 0, self.length
            strip.frame_start, strip.frame_end = self.frame_start, self.frame_start + self.length
            strip.extrapolation, strip.blend_type = "NOTHING", "REPLACE"
        return self.keys.channelbag(slot, ensure=True)

    def _curves(self, bag: object, path: str, values: Floats, tolerance: float, group: str) -> None:
        write_curves(bag, path, self.frames, values, tolerance, group)


def write_curves(bag: object, path: str, frames: Floats, values: Floats, tolerance: float, group: str) -> None:
    """Write linear keys of one property, as few as keep to a tolerance.

    Args:
        bag: Curves of one object.
        path: Of the property.
        frames: (N,) of the action, increasing.
        values: (N, C) of the property.
        tolerance: In the unit of the values.
        group: Of the curves; empty for none.
    """
    still = np.abs(values - values[0]).max() < tolerance / 2
    kept = np.array([0]) if still else reduce_keys(frames, values, tolerance)
    for column in range(values.shape[1]):
        curve = bag.fcurves.new(path, index=column)
        if group:
            curve.group = bag.groups.get(group) or bag.groups.new(group)
        curve.keyframe_points.add(len(kept))
        points = np.c_[frames[kept], values[kept, column]].astype(np.float32)
        curve.keyframe_points.foreach_set("co", points.ravel())
        curve.keyframe_points.foreach_set("interpolation", np.full(len(kept), LINEAR, np.int32))
        curve.update()
