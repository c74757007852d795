"""Props worn on the body: on the head, over the eyes, in the mouth, around the neck, under an arm, on the lap."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.hands import hand, shoulder_rest
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import rigid_matrix, sign
from storyblender.blender.motion.staged_props import MatrixOf, StagedProp
from storyblender.memory.vocabulary import BodyPlace

LYING = Matrix.Rotation(math.radians(90), 3, "X")
"""Turns the upper side of a flat prop to the front."""
OVER = Matrix.Rotation(math.radians(-62), 3, "X")
"""Leans a long prop back over the shoulder."""

HIP = math.radians(35)
"""Angle behind the side of the body at which things hang on the belt."""


def attach_to_body(who: Performer, prop: StagedProp, place: BodyPlace, t: float) -> None:
    """Let a prop follow a place on a body; an arm presses it to the side if it would fall.

    Args:
        who: The person.
        prop: What they wear.
        place: Where on the body.
        t: Second from which it follows.
    """
    prop.follow(t, _follower(who, prop.size, place), 0.0)
    if place == "under_arm":
        who.home["L"] = _clamped(who, "L")
        who.hands["L"].set(t, 0.1, who.home["L"])


def _follower(who: Performer, size: Vector, place: BodyPlace) -> MatrixOf:
    """Return the function from seconds to the matrix of a prop of this size at a place on a body."""
    match place:
        case "head" | "face" | "ears" | "mouth":
            return lambda t: _by_head(who, size, place)
        case "lap":
            return lambda t: _on_lap(who, size)
        case _:
            return lambda t: _by_trunk(who, size, place)


def _about(centre: Vector, turn: Matrix, size: Vector) -> Matrix:
    """Return the world matrix of a prop whose middle is at ``centre``."""
    return rigid_matrix(turn, centre - turn @ Vector((0, 0, size.z / 2)))


def _by_head(who: Performer, size: Vector, place: BodyPlace) -> Matrix:
    """Return the matrix of a prop on the head, the ears, the eyes or in the mouth."""
    bones, k = who.bones, who.scale
    turn = who.facing @ bones.orient["head"]
    middle = {
        "head": Vector((0, 0.088 * k, 0.042 * k + size.z / 2)),
        "ears": Vector((0, 0.092 * k, 0.12 * k - size.z / 2)),
        "face": Vector((0, size.y / 2 - 0.03 * k, 0.0)),
        "mouth": Vector((0, -0.022 * k - size.y / 2, -0.068 * k)),
    }[place]
    if place == "mouth" and size.z > size.y:  # a flower or a knife goes across
        turn = turn @ Matrix.Rotation(math.pi / 2, 3, "Y")
        middle.y = -0.022 * k
    return _about(who.point("head", who.eye_offset + middle), turn, size)


def _by_trunk(who: Performer, size: Vector, place: BodyPlace) -> Matrix:
    """Return the matrix of a prop at neck, chest, back, hip, under the arm or on the shoulder."""
    m, k, bones = who.measures, who.scale, who.bones
    low = place == "hip"
    turn = who.facing @ bones.orient["hips" if low else "upper_chest"]
    upright = turn @ (LYING if size.z < 0.25 * max(size.x, size.y) else Matrix.Identity(3))
    tall = size.y if size.z < 0.25 * max(size.x, size.y) else size.z
    thick = min(size)
    left, right = shoulder_rest(who, "L"), shoulder_rest(who, "R")
    shoulders = who.to_world((left + right) / 2)
    match place:
        case "neck":
            return _about(
                shoulders + turn @ Vector((0, -0.55 * m.chest_front - thick, 0.03 * k - tall / 2)), upright, size
            )
        case "chest":
            return _about(shoulders + turn @ Vector((0.09 * k, -m.chest_front - thick / 2, -0.12 * k)), upright, size)
        case "back":
            return _about(shoulders + turn @ Vector((0, m.chest_back + size.y / 2, -tall / 2)), turn, size)
        case "hip":
            out = Vector((math.cos(HIP), math.sin(HIP), 0.0))  # behind the arm that hangs there
            at = Vector((out.x * m.radius, out.y * m.buttocks_back, 0.0)) + out * (thick / 2)
            aside = who.point("hips") + turn @ (at + Vector((0, 0, 0.1 * k - tall / 2)))
            return _about(aside, turn @ Matrix.Rotation(HIP, 3, "Z") @ _edgewise(size), size)
        case "under_arm":
            aside = Vector((0.145 * k + thick / 2, -0.02, -0.17 * k))
            return _about(shoulders + turn @ aside, turn @ _edgewise(size, upright=False), size)
        case _:
            outer = who.to_world(right) + turn @ Vector((0.05 * k, 0.02, 0.05 * k + thick / 2))
            long = max(size)
            over = turn @ OVER if size.z == long else turn @ Matrix.Rotation(math.radians(28), 3, "X")
            return _about(outer, over if long > 0.5 else turn, size)


def _edgewise(size: Vector, upright: bool = True) -> Matrix:
    """Return the rotation that puts a prop's thinnest side along X and its longest upwards, or along Y."""
    axes = sorted(range(3), key=lambda axis: size[axis])
    wanted = (0, 1, 2) if upright else (0, 2, 1)
    turn = Matrix(((0, 0, 0), (0, 0, 0), (0, 0, 0)))
    for axis, way in zip(axes, wanted, strict=True):
        turn[way][axis] = 1.0
    if turn.determinant() < 0:
        turn[0] = -turn[0]
    return turn


def _on_lap(who: Performer, size: Vector) -> Matrix:
    """Return the matrix of a prop on a sitter's thighs, its front towards the sitter."""
    joints = [who.bones.joint[f"{bone}.{side}"] for bone in ("thigh", "shin") for side in "LR"]
    middle = sum(joints, Vector()) / 4
    base = who.to_world(middle) + Vector((0, 0, who.measures.lap + 0.015))
    turn = who.facing @ Matrix.Rotation(math.pi, 3, "Z")
    return _about(base + Vector((0, 0, size.z / 2)), turn, size)


def _clamped(who: Performer, side: str) -> TargetOf:
    """Return the target of a hand whose arm presses something to the side: elbow back, hand before the belly."""

    def target(t: float) -> Floats:
        s, m = sign(side), who.measures
        turn = who.facing @ who.bones.orient["upper_chest"]
        palm = who.to_world(shoulder_rest(who, side)) + turn @ Vector(
            (s * 0.02, -0.62 * m.forearm - 0.05, -0.86 * m.upper_arm)
        )
        fingers, normal = turn @ Vector((-s * 0.25, -1, 0.1)), turn @ Vector((-s, -0.2, 0.2))
        return hand(palm, fingers, normal, turn @ Vector((s * 0.5, 1, -0.4)), (30, 36, 10))

    return target
