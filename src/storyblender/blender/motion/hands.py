"""Targets of hands: palm, finger direction, palm normal, elbow direction and curl of the fingers.

A hand target is 15 numbers in the world frame (``hand``). It aims the centre of the palm, not the wrist, so that clips
can name grips, table tops and shoulders directly. Functions that return a ``TargetOf`` give a target for every second
of the shot, computed from the pose of the body at that moment.
"""

from __future__ import annotations

import math

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import facing_yaw, frame, sign

Triple = tuple[float, float, float]
"""Three numbers of a hand: (outwards, forwards, up), or degrees of index finger, other fingers and thumb."""

RELAXED: Triple = (16, 22, 0)
FLAT: Triple = (6, 8, 0)
FIST: Triple = (75, 85, 30)
ELBOW: Triple = (0.5, -0.5, -0.85)
"""Default elbow direction: outwards, forwards, up."""


def hand(palm: Vector, fingers: Vector, normal: Vector, pole: Vector, curl: Triple = RELAXED) -> Floats:
    """Return a hand target: (15,) world-frame values.

    Args:
        palm: Palm centre, metres.
        fingers: Direction of the fingers.
        normal: Direction out of the palm.
        pole: Direction the elbow points in.
        curl: Degrees of index finger, other fingers and thumb; 0 is stretched.
    """
    return np.array([*palm, *fingers, *normal, *pole, *curl], float)


def blend_hands(a: Floats, b: Floats, w: float) -> Floats:
    """Return the blend of two hand targets (15,), ``w`` of ``b``, 0..1; hand and elbow take the shorter turn."""
    mixed = a * (1 - w) + b * w
    if w <= 0 or w >= 1:
        return mixed
    before, after = (frame(Vector(v[3:6]), Vector(v[6:9])).to_quaternion() for v in (a, b))
    turn = before.slerp(after if before.dot(after) >= 0 else -after, w).to_matrix()
    mixed[3:6], mixed[6:9] = turn.col[0], turn.col[1]
    pole, goal = Vector(a[9:12]).normalized(), Vector(b[9:12]).normalized()
    if pole.dot(goal) > -0.99:
        mixed[9:12] = pole.slerp(goal, w)
    return mixed


def hanging(who: Performer, side: str) -> TargetOf:
    """Return the target of an arm at the body's side: it swings with the gait and follows only the chest's yaw.

    Args:
        who: The person.
        side: ``L`` or ``R``.
    """

    def target(t: float) -> Floats:
        swing, phase, gait = who.gait_at(t)
        s, m = sign(side), who.measures
        rhythm = -s * math.cos(2 * math.pi * phase)
        if gait is not None and gait.running:
            upper = math.radians(-8 + 38 * rhythm * swing)
            lower = upper + math.radians(92)
            arm = Vector((s * 0.22, -math.sin(upper), -math.cos(upper))).normalized()
            forearm = Vector((-s * 0.30 * (0.5 + 0.5 * rhythm), -math.sin(lower), -math.cos(lower))).normalized()
            pole, curl = Vector((s * 0.3, 1, -0.3)), (55, 65, 10)
        else:
            upper = math.radians(1 + 22 * rhythm * swing)
            lower = upper + math.radians(13 + swing * (6 + 10 * (0.5 + 0.5 * math.sin(upper * 3))))
            arm = Vector((s * 0.17, -math.sin(upper), -math.cos(upper))).normalized()
            forearm = Vector((s * 0.04, -math.sin(lower), -math.cos(lower))).normalized()
            pole, curl = Vector((s * 0.15, 1, -0.1)), RELAXED
        turn = Matrix.Rotation(0.8 * chest_yaw(who), 3, "Z")
        fingers = (turn @ (forearm + Vector((0, -0.08, 0)))).normalized()
        normal = turn @ Vector((-s, 0.15, 0))
        wrist = who.bones.joint[f"upper_arm.{side}"] + turn @ (arm * m.upper_arm + forearm * m.forearm)
        palm = who.to_world(wrist + who.palm_offset(side, fingers, normal))
        return hand(palm, who.facing @ fingers, who.facing @ normal, who.facing @ (turn @ pole), curl)

    return target


def chest_yaw(who: Performer) -> float:
    """Return the yaw of a posed person's chest relative to their root, radians."""
    forward = who.bones.orient["upper_chest"] @ Vector((0, -1, 0))
    return facing_yaw(forward)


def shoulder_rest(who: Performer, side: str) -> Vector:
    """Return the shoulder joint of the posed body before the clavicle moves, metres in armature space.

    Args:
        who: The person.
        side: ``L`` or ``R``.
    """
    bones = who.bones
    return bones.point("upper_chest", bones.head[f"upper_arm.{side}"] - bones.head["upper_chest"])


def by_chest(
    who: Performer,
    side: str,
    at: Triple,
    fingers: Triple,
    normal: Triple,
    *,
    pole: Triple = ELBOW,
    curl: Triple = (18, 25, 0),
    upright: bool = False,
) -> TargetOf:
    """Return the target of a hand at a place relative to the shoulder, moving with the chest.

    Vectors are (outwards, forwards, up) for either side.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        at: Palm centre from the shoulder joint, in arm lengths.
        fingers: Direction of the fingers.
        normal: Direction out of the palm.
        pole: Direction the elbow points in.
        curl: Degrees of index finger, other fingers and thumb.
        upright: Follow only the chest's position and yaw, not its lean.
    """
    place, *directions = (_mirrored(side, each) for each in (at, fingers, normal, pole))

    def target(t: float) -> Floats:
        orient = Matrix.Rotation(chest_yaw(who), 3, "Z") if upright else who.bones.orient["upper_chest"]
        palm = shoulder_rest(who, side) + orient @ (place * who.measures.arm)
        along, out, elbow = [who.facing @ (orient @ each) for each in directions]
        return hand(who.to_world(palm), along, out, elbow, curl)

    return target


def by_head(
    who: Performer, side: str, at: Triple, fingers: Triple, normal: Triple, *, pole: Triple, curl: Triple
) -> TargetOf:
    """Return the target of a hand at a place relative to the eyes, moving with the head.

    Vectors are (outwards, forwards, up) for either side.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        at: Palm centre from the middle of the eyes, metres times the person's scale.
        fingers: Direction of the fingers.
        normal: Direction out of the palm.
        pole: Direction the elbow points in, in the person's frame.
        curl: Degrees of index finger, other fingers and thumb.
    """
    place, along, out, elbow = (_mirrored(side, each) for each in (at, fingers, normal, pole))

    def target(t: float) -> Floats:
        bones = who.bones
        orient, palm = bones.orient["head"], bones.point("head", who.eye_offset + place * who.scale)
        directions = who.facing @ (orient @ along), who.facing @ (orient @ out), who.facing @ elbow
        return hand(who.to_world(palm), *directions, curl)

    return target


def _mirrored(side: str, vector: Triple) -> Vector:
    """Convert (outwards, forwards, up) of a hand to body axes: X to the person's left, Y back, Z up."""
    return Vector((sign(side) * vector[0], -vector[1], vector[2]))


def on_thigh(who: Performer, side: str) -> TargetOf:
    """Return the target of a palm on the person's own thigh, near the knee.

    Args:
        who: The person.
        side: ``L`` or ``R``.
    """

    def target(t: float) -> Floats:
        s, k = sign(side), who.scale
        knee, hip = who.bones.joint[f"shin.{side}"], who.bones.joint[f"thigh.{side}"]
        along = (knee - hip).normalized()
        palm = hip.lerp(knee, 0.70) + Vector((-s * 0.012 * k, 0, who.measures.lap + 0.030 * k))
        fingers = (along + Vector((-s * 0.35, 0, -0.12))).normalized()
        turn = who.facing
        return hand(
            who.to_world(palm), turn @ fingers, turn @ Vector((0, -0.1, -1)), turn @ Vector((s * 0.75, 0.7, -0.3)),
            (14, 18, 0),
        )  # fmt: skip

    return target


def on_knee(who: Performer, side: str) -> TargetOf:
    """Return the target of a palm on the person's own raised knee.

    Args:
        who: The person.
        side: ``L`` or ``R``.
    """

    def target(t: float) -> Floats:
        s, k, turn = sign(side), who.scale, who.facing
        palm = who.bones.joint[f"shin.{side}"] + Vector((0, 0.045, 0.085)) * k
        return hand(
            who.to_world(palm), turn @ Vector((-s * 0.3, -1, -0.25)), turn @ Vector((0, -0.2, -1)),
            turn @ Vector((s * 0.7, 0.6, -0.3)), (16, 22, 0),
        )  # fmt: skip

    return target


def beside_body(who: Performer, side: str, height: float) -> TargetOf:
    """Return the target of a palm beside a lying person's hip, on the surface they lie on.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        height: Of the surface, world metres.
    """

    def target(t: float) -> Floats:
        s, k = sign(side), who.scale
        hips = who.point("hips")
        foot = who.facing @ Vector((0, -1, 0))
        aside = who.facing @ Vector((s, 0, 0))
        palm = hips + aside * (0.27 * k) + foot * (0.06 * k)
        palm.z = height + 0.03 * k
        return hand(palm, foot, Vector((0, 0, -1)), aside + Vector((0, 0, 0.3)), (14, 18, 0))

    return target


def fixed_hand(palm: Vector, fingers: Vector, normal: Vector, pole: Vector, curl: Triple = FLAT) -> TargetOf:
    """Return a hand target that stays at one place in the world; arguments as in ``hand``."""
    values = hand(palm, fingers, normal, pole, curl)
    return lambda t: values
