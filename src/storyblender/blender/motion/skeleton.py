"""Forward and inverse kinematics of one person in armature space, without Blender's depsgraph.

``turn[bone]`` is a rotation about the armature's axes in the parent's frame; ``orient[bone]`` accumulates all turns up
to the bone. With the rest matrix R, the pose bone's rotation is R^T turn R (notes: humans, section 3).
"""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import clamp
from storyblender.blender.people.body import RiggedBody

IDENTITY = Matrix.Identity(3)
FORWARD = Vector((0, -1, 0))
UP = Vector((0, 0, 1))
SIDES = ("L", "R")
STRAIGHTEST = 0.9995
"""Limbs stop short of full stretch, where knees and elbows would flip."""
TWIST = 0.45
"""Share of the exact hinge in an upper arm's roll; all of it wrings the shoulder (notes: humans, pitfall 1)."""


def about(axis: str | Vector, degrees: float) -> Matrix:
    """Return the 3x3 rotation by ``degrees`` about an axis: ``X``, ``Y``, ``Z`` or a direction."""
    return Matrix.Rotation(math.radians(degrees), 3, axis)


def swing(a: Vector, b: Vector) -> Matrix:
    """Return the shortest 3x3 rotation from direction ``a`` to direction ``b``."""
    return a.rotation_difference(b).to_matrix()


def frame(direction: Vector, normal: Vector) -> Matrix:
    """Return the orthonormal 3x3 matrix of columns ``direction``, ``normal`` made square to it, their cross product."""
    along = direction.normalized()
    square = (normal - along * normal.dot(along)).normalized()
    return Matrix((along, square, along.cross(square))).transposed()


def rigid_matrix(turn: Matrix, place: Vector) -> Matrix:
    """Return the 4x4 matrix of the 3x3 rotation ``turn`` followed by a translation to ``place``, metres."""
    matrix = turn.to_4x4()
    matrix.translation = place
    return matrix


def facing_yaw(direction: Vector) -> float:
    """Return the yaw that faces a direction, radians."""
    return math.atan2(direction.x, -direction.y)


def sign(side: str) -> int:
    """Return +1 for the left side, -1 for the right: X grows to the person's left."""
    return 1 if side == "L" else -1


def other(side: str) -> str:
    """Return the opposite side."""
    return "R" if side == "L" else "L"


class Skeleton:
    """The pose of one person: ``turn``, ``orient`` and ``joint`` (armature space, metres) by bone name.

    Args:
        body: Rest joints and hierarchy.
    """

    def __init__(self, body: RiggedBody) -> None:
        names = body.bone_names
        self.names = names
        self.head = {name: Vector(point) for name, point in zip(names, body.heads.tolist(), strict=True)}
        self.tail = {name: Vector(point) for name, point in zip(names, body.tails.tolist(), strict=True)}
        self.rest = {n: Matrix(m).to_3x3() for n, m in zip(names, body.rest.tolist(), strict=True)}
        self.parent = {n: names[p] if p >= 0 else None for n, p in zip(names, body.parents, strict=True)}
        self.from_parent = {n: self.head[n] - self.head[p] for n, p in self.parent.items() if p is not None}
        self.scale = body.stature / 1.7
        self.order = _parents_first(self.parent)
        self._resting_hands = {side: self._hand_at_rest(side) for side in SIDES}
        self._feet_across = {side: self._foot_across(side) for side in SIDES}
        self.offset = Vector((0, 0, 0))
        """Move of the hips from rest."""
        self.reset()

    def reset(self) -> None:
        """Return to the rest pose."""
        self.turn = dict.fromkeys(self.names, IDENTITY)
        self.orient: dict[str, Matrix] = {}
        self.joint: dict[str, Vector] = {}
        self.offset = Vector((0, 0, 0))
        self.update(*self.order)

    def update(self, *bones: str) -> None:
        """Recompute orientation and joint of ``bones``, in the order given (parents before children)."""
        orient, joint = self.orient, self.joint
        for bone in bones:
            parent = self.parent[bone]
            if parent is None:
                orient[bone] = self.turn[bone]
                joint[bone] = self.head[bone] + self.offset
            else:
                carried = orient[parent]
                orient[bone] = carried @ self.turn[bone]
                joint[bone] = joint[parent] + carried @ self.from_parent[bone]

    def update_all(self) -> None:
        """Recompute every bone."""
        self.update(*self.order)

    def update_upper(self) -> None:
        """Recompute trunk, head and shoulders."""
        self.update("spine", "chest", "upper_chest", "neck", "head", "jaw", "shoulder.L", "shoulder.R")
        self.update("upper_arm.L", "upper_arm.R", "eye.L", "eye.R")

    def rotate(self, bone: str, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        """Turn a bone further by ``x``, ``y``, ``z`` degrees about the armature's axes, in this order."""
        self.turn[bone] = about("Z", z) @ about("Y", y) @ about("X", x) @ self.turn[bone]

    def set_orient(self, bone: str, orient: Matrix) -> None:
        """Set the orientation of a bone, a 3x3 rotation in armature space."""
        parent = self.parent[bone]
        self.turn[bone] = self.orient[parent].transposed() @ orient if parent else orient
        self.update(bone)

    def point(self, bone: str, offset: Vector) -> Vector:
        """Return the point (armature space) ``offset`` metres from a bone's joint (rest axes), moving with the bone."""
        return self.joint[bone] + self.orient[bone] @ offset

    def reach(self, upper: str, lower: str, end: str, target: Vector, pole: Vector) -> float:
        """Bend a two-bone limb so that its end reaches a target; return by how many metres it falls short (0 or less:
        reached).

        Args:
            upper: Thigh or upper arm.
            lower: Shin or forearm.
            end: Foot or hand.
            target: Armature space, metres.
            pole: Direction the knee or elbow points in.
        """
        self.update(upper)
        start = self.joint[upper]
        rest_upper, rest_lower = self.head[lower] - self.head[upper], self.head[end] - self.head[lower]
        a, b = rest_upper.length, rest_lower.length
        distance = (target - start).length
        held = clamp(distance, abs(a - b) + 0.02 * self.scale, (a + b) * STRAIGHTEST)
        along = (target - start).normalized() if distance > 1e-6 else Vector((0, 0, -1))
        aside = (pole - along * pole.dot(along)).normalized()
        cosine = clamp((a * a + held * held - b * b) / (2 * a * held), -1, 1)
        middle = start + along * (a * cosine) + aside * (a * math.sqrt(max(0.0, 1 - cosine * cosine)))
        hinge = along.cross(aside)
        leg = upper.startswith("thigh")
        for bone, begin, stop, rest in (
            (upper, start, middle, rest_upper),
            (lower, middle, start + along * held, rest_lower),
        ):
            direction = (stop - begin).normalized()
            rest_hinge = rest.normalized().cross(FORWARD) if leg else rest_lower.cross(rest_upper)
            square = hinge - direction * hinge.dot(direction)
            exact = frame(direction, square if square.length > 1e-5 else hinge)
            orient = exact @ frame(rest, rest_hinge).transposed()
            if not leg:
                orient = self._untwisted(bone, rest, direction, orient)
            self.set_orient(bone, orient)
        self.update(end)
        return distance - (a + b) * STRAIGHTEST

    def _untwisted(self, bone: str, rest: Vector, direction: Vector, exact: Matrix) -> Matrix:
        """Return a blend of the exact hinge orientation and the plain swing from the parent, by ``TWIST``."""
        parent = self.orient[self.parent[bone] or "hips"]
        plain, full = (swing(parent @ rest, direction) @ parent).to_quaternion(), exact.to_quaternion()
        if plain.dot(full) < 0:
            full = -full
        orient = plain.slerp(full, TWIST).to_matrix()
        return swing(orient @ rest, direction) @ orient

    def hand_axes(self, side: str) -> tuple[Vector, Vector]:
        """Return the resting hand's finger direction and palm normal."""
        return self._resting_hands[side]

    def _hand_at_rest(self, side: str) -> tuple[Vector, Vector]:
        """Return finger direction and palm normal of the rest pose."""
        bone = f"hand.{side}"
        fingers = (self.tail[bone] - self.head[bone]).normalized()
        across = self.head[f"fingers1.{side}"] - self.head[f"index1.{side}"]
        return fingers, fingers.cross(across) if side == "R" else across.cross(fingers)

    def set_hand(self, side: str, fingers: Vector, palm: Vector) -> None:
        """Turn a hand so that its fingers point along ``fingers`` and its palm faces ``palm`` (armature space)."""
        rest_fingers, rest_palm = self.hand_axes(side)
        self.set_orient(f"hand.{side}", frame(fingers, palm) @ frame(rest_fingers, rest_palm).transposed())

    def curl(self, side: str, index: float, fingers: float, thumb: float) -> None:
        """Close the fingers of a hand; at 0 degrees they are stretched.

        Args:
            side: ``L`` or ``R``.
            index: Degrees of the first joint of the index finger; the second takes 1.2 times as many.
            fingers: The same for the other fingers.
            thumb: Degrees of the thumb.
        """
        across = (self.head[f"fingers1.{side}"] - self.head[f"index1.{side}"]).normalized() * sign(side)
        for bone, degrees in (("index", index), ("fingers", fingers)):
            self.turn[f"{bone}1.{side}"] = about(across, degrees)
            self.turn[f"{bone}2.{side}"] = about(across, degrees * 1.2)
        along, _ = self.hand_axes(side)
        self.turn[f"thumb.{side}"] = about(along * sign(side), thumb)
        self.update(*(f"{bone}.{side}" for bone in ("thumb", "index1", "index2", "fingers1", "fingers2")))

    def pitch(self, side: str, degrees: float) -> Matrix:
        """Return the 3x3 rotation of the foot ``side`` about its lateral axis by ``degrees``, toes up."""
        return about(self._feet_across[side], -degrees)

    def _foot_across(self, side: str) -> Vector:
        """Return the lateral axis of the resting foot."""
        along = self.head[f"toe.{side}"] - self.head[f"foot.{side}"]
        return Vector((-along.y, along.x, 0)).normalized()


def _parents_first(parent: dict[str, str | None]) -> tuple[str, ...]:
    """Return the bones ordered so that parents come before children."""

    def depth(bone: str) -> int:
        above = parent[bone]
        return 0 if above is None else 1 + depth(above)

    return tuple(sorted(parent, key=depth))
