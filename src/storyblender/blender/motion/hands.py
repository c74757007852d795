"""Hand targets: where a palm is, where fingers point, where the palm looks, where the elbow goes, how fingers curl.

A target is 15 numbers in world frame. The palm's centre is aimed at, not the wrist, so grips, table tops and shoulders
need no arithmetic in the clips.
"""

from __future__ import annotations

import math

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import frame, sign

Triple = tuple[float, float, float]

RELAXED: Triple = (16, 22, 0)
FLAT: Triple = (6, 8, 0)
FIST: Triple = (75, 85, 30)
ELBOW: Triple = (0.5, -0.5, -0.85)
"""Default elbow direction: outwards, forwards, up."""


def hand(palm: Vector, fingers: Vector, normal: Vector, pole: Vector, curl: Triple = RELAXED) -> Floats:
    """Pack a hand target.

    Args:
        palm: Palm centre.
        fingers: Direction of the fingers.
        normal: Where the palm looks.
        pole: Where the elbow points.
        curl: Degrees of index, other fingers and thumb.
    """
    return np.array([*palm, *fingers, *normal, *pole, *curl], float)


def blend_hands(a: Floats, b: Floats, w: float) -> Floats:
    """Mix two hand targets: the palm moves straight, the hand turns the short way, the elbow swings around."""
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
    """Arms at the sides, swinging with the gait; upright in the world, they follow only the chest's yaw."""

    def target(t: float) -> Floats:
        swing, phase, gait = who.gait_at(t)
        s, m = sign(side), who.m
        beat = -s * math.cos(2 * math.pi * phase)
        if gait is not None and gait.running:
            upper = math.radians(-8 + 38 * beat * swing)
            lower = upper + math.radians(92)
            arm = Vector((s * 0.22, -math.sin(upper), -math.cos(upper))).normalized()
            forearm = Vector((-s * 0.30 * (0.5 + 0.5 * beat), -math.sin(lower), -math.cos(lower))).normalized()
            pole, curl = Vector((s * 0.3, 1, -0.3)), (55, 65, 10)
        else:
            upper = math.radians(1 + 22 * beat * swing)
            lower = upper + math.radians(13 + swing * (6 + 10 * (0.5 + 0.5 * math.sin(upper * 3))))
            arm = Vector((s * 0.17, -math.sin(upper), -math.cos(upper))).normalized()
            forearm = Vector((s * 0.04, -math.sin(lower), -math.cos(lower))).normalized()
            pole, curl = Vector((s * 0.15, 1, -0.1)), RELAXED
        turn = Matrix.Rotation(0.8 * chest_yaw(who), 3, "Z")
        fingers = (turn @ (forearm + Vector((0, -0.08, 0)))).normalized()
        normal = turn @ Vector((-s, 0.15, 0))
        wrist = who.bones.joint[f"upper_arm.{side}"] + turn @ (arm * m.upper_arm + forearm * m.forearm)
        palm = who.to_world(wrist + who.palm_offset(fingers, normal))
        return hand(palm, who.facing @ fingers, who.facing @ normal, who.facing @ (turn @ pole), curl)

    return target


def chest_yaw(who: Performer) -> float:
    """Return the chest's yaw in the person's own frame, radians."""
    forward = who.bones.orient["upper_chest"] @ Vector((0, -1, 0))
    return math.atan2(forward.x, -forward.y)


def shoulder_rest(who: Performer, side: str) -> Vector:
    """Return the shoulder joint as carried by the chest, before the clavicle moves (armature space)."""
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
) -> TargetOf:
    """A place in the chest's frame: outwards, forwards, up from the shoulder, in arm lengths; directions likewise."""

    def flip(v: Triple) -> Vector:
        return Vector((sign(side) * v[0], -v[1], v[2]))

    def target(t: float) -> Floats:
        orient = who.bones.orient["upper_chest"]
        place = shoulder_rest(who, side) + orient @ (flip(at) * who.m.arm)
        along, out, elbow = [who.facing @ (orient @ flip(v)) for v in (fingers, normal, pole)]
        return hand(who.to_world(place), along, out, elbow, curl)

    return target


def upright(
    who: Performer,
    side: str,
    at: Triple,
    fingers: Triple,
    normal: Triple,
    *,
    pole: Triple = ELBOW,
    curl: Triple = (18, 25, 0),
) -> TargetOf:
    """Like ``by_chest``, but upright: it follows the chest's place and yaw only."""

    def flip(v: Triple) -> Vector:
        return Vector((sign(side) * v[0], -v[1], v[2]))

    def target(t: float) -> Floats:
        turn = Matrix.Rotation(chest_yaw(who), 3, "Z")
        place = shoulder_rest(who, side) + turn @ (flip(at) * who.m.arm)
        along, out, elbow = [who.facing @ (turn @ flip(v)) for v in (fingers, normal, pole)]
        return hand(who.to_world(place), along, out, elbow, curl)

    return target


def by_head(
    who: Performer, side: str, at: Triple, fingers: Triple, normal: Triple, *, pole: Triple, curl: Triple
) -> TargetOf:
    """A place rigid to the head: outwards, forwards, up from the eyes, metres times k; elbow in the person's frame."""

    def flip(v: Triple) -> Vector:
        return Vector((sign(side) * v[0], -v[1], v[2]))

    def target(t: float) -> Floats:
        bones = who.bones
        eyes = (bones.head["eye.L"] + bones.head["eye.R"]) / 2 - bones.head["head"]
        orient = bones.orient["head"]
        place = bones.point("head", eyes + flip(at) * who.m.k)
        return hand(
            who.to_world(place),
            who.facing @ (orient @ flip(fingers)),
            who.facing @ (orient @ flip(normal)),
            who.facing @ flip(pole),
            curl,
        )

    return target


def on_thigh(who: Performer, side: str) -> TargetOf:
    """Palm on one's own lap."""

    def target(t: float) -> Floats:
        s, k = sign(side), who.m.k
        knee, hip = who.bones.joint[f"shin.{side}"], who.bones.joint[f"thigh.{side}"]
        along = (knee - hip).normalized()
        palm = hip.lerp(knee, 0.70) + Vector((-s * 0.012 * k, 0, who.m.lap + 0.030 * k))
        fingers = (along + Vector((-s * 0.35, 0, -0.12))).normalized()
        turn = who.facing
        return hand(
            who.to_world(palm), turn @ fingers, turn @ Vector((0, -0.1, -1)), turn @ Vector((s * 0.75, 0.7, -0.3)),
            (14, 18, 0),
        )  # fmt: skip

    return target


def on_knee(who: Performer, side: str) -> TargetOf:
    """Palm on one's own raised knee."""

    def target(t: float) -> Floats:
        s, k, turn = sign(side), who.m.k, who.facing
        palm = who.bones.joint[f"shin.{side}"] + Vector((0, 0.045, 0.085)) * k
        return hand(
            who.to_world(palm), turn @ Vector((-s * 0.3, -1, -0.25)), turn @ Vector((0, -0.2, -1)),
            turn @ Vector((s * 0.7, 0.6, -0.3)), (16, 22, 0),
        )  # fmt: skip

    return target


def beside_body(who: Performer, side: str, height: float) -> TargetOf:
    """Palm on the bed or the floor at ``height`` beside a lying body's hip."""

    def target(t: float) -> Floats:
        s, k = sign(side), who.m.k
        hips = who.point("hips")
        foot = who.facing @ Vector((0, -1, 0))
        aside = who.facing @ Vector((s, 0, 0))
        palm = hips + aside * (0.27 * k) + foot * (0.06 * k)
        palm.z = height + 0.03 * k
        return hand(palm, foot, Vector((0, 0, -1)), aside + Vector((0, 0, 0.3)), (14, 18, 0))

    return target


def fixed(palm: Vector, fingers: Vector, normal: Vector, pole: Vector, curl: Triple = FLAT) -> TargetOf:
    """A place in the world."""
    values = hand(palm, fingers, normal, pole, curl)
    return lambda t: values


def offset(target: TargetOf, by: Vector, opening: float = 1.0) -> TargetOf:
    """Move a target by a world vector and open its fingers: 1 leaves the curl, 0 stretches it."""

    def moved(t: float) -> Floats:
        values = np.array(target(t), float)
        values[:3] += by
        values[12:15] *= opening
        return values

    return moved
