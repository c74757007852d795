"""Controls of a person's rig, for animators: hands and feet with IK, a target to look at, the whole body.

They do nothing until they are used: every limb has a switch, a custom property of the armature object, that drives the
influence of its constraints. The drivers have no expression, so they work where scripts are disabled. In every shot
the controls are keyed to where the limbs are (``motion.control_keys``): a limb that is switched stays where it is.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Final

import bpy
import numpy as np
from mathutils import Vector

from storyblender.blender.motion.baked import bags_of
from storyblender.geometry.solids import Floats

SWITCHES: Final[dict[str, str]] = {
    **{f"ik_hand_{side}": f"How far hand_ik.{side} and elbow_pole.{side} move the arm" for side in "LR"},
    **{f"ik_foot_{side}": f"How far foot_ik.{side} and knee_pole.{side} move the leg" for side in "LR"},
    "look_at_head": "How far the head turns to look_at",
    "look_at_eyes": "How far the eyes turn to look_at",
}
"""Custom properties of the armature object, 0 to 1, and what Blender says of them; constraints are named so too."""
ROOT, TORSO, LOOK_AT = "root", "torso", "look_at"
GROWN = 1.7
"""Metres: stature of a person whose controls have the sizes below."""
POLE_AWAY, LOOK_AWAY = 0.45, 1.2
"""Metres from elbow or knee to its pole, and from the head to what it looks at."""
STRAIGHT = 0.004
"""Metres from elbow or knee to the line between its ends, under which a limb says nothing of where it bends."""


@dataclass(frozen=True)
class Limb:
    """A limb of two bones that follows a control.

    Attributes:
        upper: Upper arm or thigh.
        lower: Forearm or shin.
        end: Hand or foot.
        control: Moves and turns the end.
        pole: The elbow or the knee points at it.
        forward: Whether it bends to the front, where the Z axes of its bones point at rest (``people.rig``).
        switch: Of ``SWITCHES``.
    """

    upper: str
    lower: str
    end: str
    control: str
    pole: str
    forward: bool
    switch: str


def _limbs(s: str) -> tuple[Limb, Limb]:
    arm = Limb(f"upper_arm.{s}", f"forearm.{s}", f"hand.{s}", f"hand_ik.{s}", f"elbow_pole.{s}", False, f"ik_hand_{s}")
    leg = Limb(f"thigh.{s}", f"shin.{s}", f"foot.{s}", f"foot_ik.{s}", f"knee_pole.{s}", True, f"ik_foot_{s}")
    return arm, leg


LIMBS: Final = (*_limbs("L"), *_limbs("R"))
CONTROLS: Final = (ROOT, TORSO, LOOK_AT, *(name for limb in LIMBS for name in (limb.control, limb.pole)))
"""Names of the bones that are added."""


def add_controls(rigs: Sequence[bpy.types.Object]) -> None:
    """Add the controls to rigs, with their switches at 0.

    Args:
        rigs: Armature objects with data of their own and the bones of ``catalog.skeleton``, or some of them.
    """
    with _edited(rigs):
        for rig in rigs:
            _add_bones(rig.data)
    for rig in rigs:
        for name, words in SWITCHES.items():
            rig[name] = 0.0
            rig.id_properties_ui(name).update(min=0.0, max=1.0, soft_min=0.0, soft_max=1.0, description=words)
        for limb in limbs_of(rig.data):
            _reach(rig, limb)
        if LOOK_AT in rig.pose.bones:
            _look(rig, "head", "TRACK_Z", "look_at_head")
            _look(rig, "eye.L", "TRACK_Y", "look_at_eyes")
            _look(rig, "eye.R", "TRACK_Y", "look_at_eyes")
        for name in CONTROLS:
            if name in rig.pose.bones:
                rig.pose.bones[name].rotation_mode = "QUATERNION"


def remove_controls(rigs: Sequence[bpy.types.Object]) -> None:
    """Remove the controls of rigs, with their keys and switches: other programs have no use for them.

    Args:
        rigs: Armature objects that ``add_controls`` was given.
    """
    paths = tuple(
        [f'pose.bones["{name}"]' for name in CONTROLS] + [f'pose.bones["{limb.lower}"].constraints' for limb in LIMBS]
    )
    for rig in rigs:
        for name in SWITCHES:
            rig.pop(name, None)
        for bone in rig.pose.bones:
            for constraint in [each for each in bone.constraints if each.name in SWITCHES]:
                constraint.driver_remove("influence")
                bone.constraints.remove(constraint)
        for bag in bags_of(rig):
            for curve in [curve for curve in bag.fcurves if curve.data_path.startswith(paths)]:
                bag.fcurves.remove(curve)
    with _edited(rigs):
        for rig in rigs:
            bones = rig.data.edit_bones
            for bone in [bone for bone in bones if bone.name in CONTROLS]:
                bones.remove(bone)


def limbs_of(rig: bpy.types.Armature) -> list[Limb]:
    """Return the limbs that a rig has, whose controls may not be there yet."""
    bones = rig.edit_bones if rig.is_editmode else rig.bones
    return [limb for limb in LIMBS if all(name in bones for name in (limb.upper, limb.lower, limb.end))]


def pole_keys(limb: Limb, upper: Floats, middle: Floats, end: Floats, scale: float) -> tuple[Floats, Floats]:
    """Return where the pole is (N, 3), and the angle of the constraint (N,), that leave a limb as it is posed.

    Blender turns the upper bone about the line from its head to the end until a direction points at the pole: that of
    its X axis, turned by the angle about the bone. A posed arm is twisted, so the angle is another in every pose.

    Args:
        limb: Of a person.
        upper: (N, 4, 4) poses of its upper bone.
        middle: (N, 3) where elbow or knee are.
        end: (N, 3) where hand or foot begin.
        scale: The person's stature over ``GROWN``.
    """
    start, x, z = upper[:, :3, 3], upper[:, :3, 0], upper[:, :3, 2]
    along = _unit(end - start)
    bend = _square(middle - start, along)
    straight = np.linalg.norm(bend, axis=1, keepdims=True) < STRAIGHT * scale
    bend = _unit(np.where(straight, _square(z if limb.forward else -z, along), bend))
    across = np.cross(along, bend)
    angle = np.arctan2(-_dot(x, across), _dot(z, across))
    backward = _dot(x, bend) * np.cos(angle) + _dot(z, bend) * np.sin(angle) < 0
    angle = np.where(backward, angle + math.pi, angle)
    place = start + along * _dot(middle - start, along) + POLE_AWAY * scale * bend
    return place, (angle[:, 0] + math.pi) % math.tau - math.pi


def scale_of(rig: bpy.types.Armature) -> float:
    """Return the stature of a person over ``GROWN``, from the rest position of the head."""
    bones = rig.edit_bones if rig.is_editmode else rig.bones
    if "head" not in bones:
        return 1.0
    head = bones["head"]
    return max((head.tail if rig.is_editmode else head.tail_local).z / GROWN, 0.1)


def _add_bones(rig: bpy.types.Armature) -> None:
    """Add the bones to a rig in edit mode, each where the bone is at rest that it moves."""
    bones, scale = rig.edit_bones, scale_of(rig)

    def add(name: str, head: Vector, tail: Vector, parent: str = ROOT) -> bpy.types.EditBone:
        bone = bones.new(name)
        bone.head, bone.tail, bone.use_deform = head, tail, False
        bone.parent = bones.get(parent)
        return bone

    up, back = Vector((0.0, 0.0, 0.1 * scale)), Vector((0.0, 0.3 * scale, 0.0))
    add(ROOT, Vector(), back, "")
    if "hips" in bones:
        hips = bones["hips"]
        add(TORSO, hips.head, hips.tail).roll = hips.roll  # in another frame, Blender would round the hips' by 20 um
        hips.parent = bones[TORSO]
    if "head" in bones:
        rest = bones["head"].matrix
        at = rest.translation + LOOK_AWAY * scale * rest.col[2].to_3d()
        add(LOOK_AT, at, at + up)
    for limb in limbs_of(rig):
        upper, lower, end = (bones[name] for name in (limb.upper, limb.lower, limb.end))
        add(limb.control, end.head, end.tail).roll = end.roll
        places, _ = pole_keys(limb, *(np.array([each]) for each in (upper.matrix, lower.head, end.head)), scale=scale)
        at = Vector(places[0])
        add(limb.pole, at, at + up)


def _reach(rig: bpy.types.Object, limb: Limb) -> None:
    """Let a limb reach its control, and its end turn with it."""
    lower, end = rig.pose.bones[limb.lower], rig.pose.bones[limb.end]
    reach = lower.constraints.new("IK")
    reach.target = reach.pole_target = rig
    reach.subtarget, reach.pole_subtarget = limb.control, limb.pole
    reach.pole_angle = math.pi / 2 if limb.forward else -math.pi / 2
    reach.chain_count = 2
    lower.ik_stiffness_y = lower.ik_stiffness_z = 0.95  # elbows and knees bend about X before anything else
    turn = end.constraints.new("COPY_ROTATION")
    turn.target, turn.subtarget = rig, limb.control
    for constraint in (reach, turn):
        _drive(rig, constraint, limb.switch)


def _look(rig: bpy.types.Object, bone: str, axis: str, switch: str) -> None:
    """Let a bone turn to the target."""
    if bone in rig.pose.bones:
        track = rig.pose.bones[bone].constraints.new("DAMPED_TRACK")
        track.target, track.subtarget, track.track_axis = rig, LOOK_AT, axis
        _drive(rig, track, switch)


def _drive(rig: bpy.types.Object, constraint: bpy.types.Constraint, switch: str) -> None:
    """Let a switch be the influence of a constraint, which is named after it."""
    constraint.name = switch
    constraint.influence = 0.0
    driver = constraint.driver_add("influence").driver
    driver.type = "SUM"
    variable = driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = rig, f'["{switch}"]'


@contextmanager
def _edited(rigs: Sequence[bpy.types.Object]) -> Iterator[None]:
    """Have the bones of rigs in edit mode: through stand-ins in a scene of their own.

    Entering edit mode evaluates all of a scene, and leaves out what is hidden in it, as people are in some shots.
    """
    if not rigs:
        yield
        return
    before, scene = bpy.context.window.scene, bpy.data.scenes.new("rigs")
    bpy.context.window.scene = scene
    stand_ins = [bpy.data.objects.new("rig", rig.data) for rig in rigs]
    for stand_in in stand_ins:
        scene.collection.objects.link(stand_in)
        stand_in.select_set(True)
    scene.view_layers[0].objects.active = stand_ins[0]
    bpy.ops.object.mode_set(mode="EDIT")
    try:
        yield
    finally:
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.window.scene = before
        bpy.data.batch_remove([scene, *stand_ins])


def _dot(a: Floats, b: Floats) -> Floats:
    return np.sum(a * b, axis=1, keepdims=True)


def _square(vectors: Floats, along: Floats) -> Floats:
    return vectors - along * _dot(vectors, along)


def _unit(vectors: Floats) -> Floats:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-9)
