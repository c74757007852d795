"""Props on strings: grips, who holds them when, and their world matrix at a moment."""

from __future__ import annotations

import math
from bisect import insort
from collections.abc import Callable
from dataclasses import dataclass, replace

from mathutils import Euler, Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp, smooth
from storyblender.blender.motion.hands import Triple, chest_yaw, fixed, hand, shoulder_rest
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageProp
from storyblender.blender.motion.skeleton import frame, sign
from storyblender.catalog.carrying import two_handed
from storyblender.memory.asset_sheet import Anchor

MatrixOf = Callable[[float], Matrix]
HANGING = 0.25
"""Metres; things taller than this with a grip near the top hang from a straight arm."""
STAFF, SLENDER, STAFF_GRIP = 0.7, 0.16, 1.0
"""Metres: how tall and how thin a staff is, and at most how high it is held."""
SHEET = 0.012
"""Metres; thinner things are papers, and are carried on edge in a low hand, not level like a plate."""
ON_TABLE, OVER_TABLE, CLEAR = 0.05, 0.12, 0.03
"""Metres: what is held at a table is so much farther in than an empty hand (times k), and so much above the top (times
k) where the palm that holds it would not be clear of it."""
SETTLE = 0.3
"""Seconds in which a prop comes to its place in a new hand, while both move."""


@dataclass(frozen=True)
class Grip:
    """How a hand holds a prop, in the prop's frame.

    Attributes:
        palm: Palm centre.
        fingers: Direction of the fingers.
        normal: Out of the palm into the prop.
        curl: Degrees of index, fingers and thumb.
    """

    palm: Vector
    fingers: Vector
    normal: Vector
    curl: Triple

    def mirrored(self) -> Grip:
        """The same grip for the other hand."""
        flip = Vector((-1, 1, 1))
        return Grip(self.palm * flip, self.fingers * flip, self.normal * flip, self.curl)

    def opposite(self) -> Grip:
        """The same grip for somebody who faces the holder."""
        flip = Vector((-1, -1, 1))
        return Grip(self.palm * flip, self.fingers * flip, self.normal * flip, self.curl)

    def hand(self, prop: Matrix, pole: Vector) -> Floats:
        """Return the hand target for the prop standing at ``prop``."""
        turn = prop.to_3x3()
        return hand(prop @ self.palm, turn @ self.fingers, turn @ self.normal, pole, self.curl)


class PropPuppet:
    """A movable thing during the shot.

    Args:
        asset_id: Which asset.
        prop: Where it stands and how it is gripped.
    """

    def __init__(self, asset_id: str, prop: StageProp) -> None:
        self.asset_id, self.node_id = asset_id, prop.node_id
        self.size = Vector(prop.dimensions)
        self.both = False
        """Whether the script asks for both hands."""
        self.anchors = {a.name or a.kind: a for a in prop.anchors if a.kind in ("grip", "handle")}
        self.matrix = Matrix(prop.world.tolist())
        if prop.state is not None and prop.state.location is not None:
            turn = Euler([math.radians(angle) for angle in prop.state.rotation]).to_matrix().to_4x4()
            self.matrix = Matrix.Translation(prop.state.location) @ turn
        self._events: list[tuple[float, MatrixOf, float]] = [(-1e9, _still(self.matrix), 0.0)]
        self.holder: Performer | None = None
        """Who holds it after everything planned so far."""
        self.flight: MatrixOf | None = None
        """Its last way through the air."""

    @property
    def two_handed(self) -> bool:
        """Carried with both hands."""
        return self.both or two_handed(tuple(self.size), tuple(self.anchors.values()))

    @property
    def hangs(self) -> bool:
        """Carried with a straight arm, like a suitcase."""
        grip = self.grip("R")
        return self.size.z > HANGING and grip.palm.z > 0.75 * self.size.z and not self.two_handed

    @property
    def is_staff(self) -> bool:
        """Carried upright, one end on the floor: walking sticks, spears, brooms."""
        return self.size.z > STAFF and max(self.size.x, self.size.y) < SLENDER and not self.anchors

    @property
    def is_sheet(self) -> bool:
        """Carried on edge: letters, envelopes, tickets, photographs."""
        return self.size.z < SHEET and not self.two_handed

    @property
    def centre(self) -> Vector:
        """World point in the middle of it, at the moment being posed."""
        return self.matrix @ Vector((0, 0, self.size.z / 2))

    def grip(self, side: str, name: str = "") -> Grip:
        """Return how the hand of a side holds it; the mirror image where only the other side was declared.

        On a paper the fingers lie flat: curled they would come through it.
        """
        grip = self._grip(side, name)
        flat = self.is_sheet and grip.normal.z > 0.7
        return replace(grip, curl=(1.0, 2.0, min(grip.curl[2], 0.0))) if flat else grip

    def _grip(self, side: str, name: str) -> Grip:
        if not self.two_handed or name:
            for key in (name, f"grip_{side.lower()}", f"{name}_{side.lower()}", f"handle_{side.lower()}"):
                if key and key in self.anchors:
                    return _from_anchor(self.anchors[key], side, named=key)
            first = next((a for key, a in self.anchors.items() if key != "support"), None)
            if first is not None:
                return _from_anchor(first, side, named=first.name)
        return self._side_grip(side)

    def has(self, name: str) -> bool:
        """Tell whether the asset declares a grip of that name."""
        return name in self.anchors

    def _side_grip(self, side: str) -> Grip:
        """Palm flat on the side of the bounding box: the person's left is the prop's +x."""
        s = sign(side)
        if self.size.z < 0.06 and not self.two_handed:  # sheets and books: from below, thumb on top
            return Grip(Vector((0, 0.35 * self.size.y, -0.012)), Vector((0, -1, 0)), Vector((0, 0, 1)), (12, 14, -30))
        height = min(0.92 * self.size.z, STAFF_GRIP) if self.is_staff else 0.45 * self.size.z
        palm = Vector((s * (self.size.x / 2 + 0.006), 0.0, height))
        curl = (10, 12, 0) if self.two_handed or self.size.x > 0.12 else (48, 52, 28)
        return Grip(palm, Vector((-s * 0.25, -1, -0.1)), Vector((-s, -0.2, 0)), curl)

    def stand(self, t: float, matrix: Matrix) -> None:
        """Leave it at a world matrix from ``t`` on."""
        self.holder = None
        insort(self._events, (t, _still(matrix), 0.12), key=lambda event: event[0])

    def follow(self, t: float, matrix: MatrixOf, settle: float = SETTLE) -> None:
        """Let it follow a moving matrix from ``t`` on, settling into it in some seconds."""
        insort(self._events, (t, matrix, settle), key=lambda event: event[0])

    def hold(self, t: float, who: Performer, side: str, grip: Grip, settle: float = SETTLE) -> None:
        """Let it follow a hand from ``t`` on."""
        self.holder = who
        self.follow(t, lambda _: held_matrix(who, side, grip), settle)

    def evaluate(self, t: float) -> Matrix:
        """Compute and return its matrix at the moment being posed; the hands must be posed."""
        last = max(i for i, (start, _, _) in enumerate(self._events) if start <= t)
        start, matrix, settle = self._events[last]
        here = matrix(t)
        share = clamp((t - start) / settle) if settle else 1.0
        if share < 1 and last:
            here = blend(self._events[last - 1][1](t), here, smooth(share))
        self.matrix = here
        return here


def held_matrix(who: Performer, side: str, grip: Grip) -> Matrix:
    """Return the matrix of a prop held by a posed hand."""
    axes, palm = who.hand_matrix(side)
    turn = axes @ frame(grip.fingers, grip.normal).transposed()
    matrix = turn.to_4x4()
    matrix.translation = palm - turn @ grip.palm
    return matrix


def carried(who: Performer, side: str, prop: PropPuppet) -> TargetOf:
    """Where the hand carries a prop: upright, before the body; hanging for bags; both hands for large things.

    Who sits at a table has a cup stand on it, and a letter above it.
    """
    grip = prop.grip(side)
    s, m = sign(side), who.m
    if side in who.table and not (prop.two_handed or prop.hangs or prop.is_staff):
        ahead = who.table[side].xy + who.forward * (ON_TABLE * m.k)
        above = grip.palm.z if grip.palm.z > CLEAR else OVER_TABLE * m.k
        turn = Matrix.Rotation(who.yaw, 3, "Z")
        return fixed(
            Vector((*ahead, who.table[side].z + above)),
            turn @ grip.fingers,
            turn @ grip.normal,
            turn @ Vector((s * 0.5, 0.3, -0.85)),
            grip.curl,
        )

    def target(t: float) -> Floats:
        turn = who.facing @ Matrix.Rotation(chest_yaw(who), 3, "Z")
        pole = turn @ Vector((s * 0.5, 0.6, -0.85))
        if prop.two_handed:
            middle = (shoulder_rest(who, "L") + shoulder_rest(who, "R")) / 2
            ahead = who.m.front + prop.size.y / 2 + 0.03
            base = who.to_world(middle) + turn @ Vector((0, -ahead, -0.62 * m.arm - grip.palm.z))
            matrix = turn.to_4x4()
            matrix.translation = base
            return grip.hand(matrix, turn @ Vector((s * 0.8, 0.6, -0.5)))
        chest = who.bones.orient["upper_chest"]
        if (chest @ Vector((0, -1, 0))).z > 0.5:  # on one's back: on the chest
            turn = who.facing @ chest
            place = who.to_world(shoulder_rest(who, side)) + turn @ (Vector((-s * 0.15, -0.40, -0.35)) * m.arm)
            return hand(place, turn @ grip.fingers, turn @ grip.normal, turn @ Vector((s * 0.9, 0, -0.5)), grip.curl)
        at = (0.03, 0.42, -0.58)
        if prop.hangs:
            at = (0.10 + 0.5 * min(prop.size.x, prop.size.y) / m.arm, 0.04, -0.97)
            if prop.size.x > prop.size.y:  # a case goes along the leg
                turn = turn @ Matrix.Rotation(s * math.pi / 2, 3, "Z")
        if prop.is_staff and not float(who.pinned(t)):
            foot = who.place + who.facing @ Vector((s * 0.26 * m.k, -0.22 * m.k, 0))
            return grip.hand(Matrix.Translation(foot) @ who.facing.to_4x4(), pole)
        beside = who.facing @ Matrix.Rotation(chest_yaw(who), 3, "Z")
        fingers, palm = turn @ grip.fingers, turn @ grip.normal
        if prop.is_sheet and not float(who.pinned(t)):
            at = (0.06, 0.32, -0.72)
            fingers, palm = beside @ Vector((-0.15 * s, -0.95, -0.3)), beside @ Vector((-s, 0.1, 0.25))
        place = who.to_world(shoulder_rest(who, side)) + beside @ (Vector((s * at[0], -at[1], at[2])) * m.arm)
        return hand(place, fingers, palm, pole, grip.curl)

    return target


def gripping(
    who: Performer, side: str, prop: PropPuppet, grip: Grip, opening: float = 1.0, lift: float = 0.0
) -> TargetOf:
    """Where the hand holds a prop that moves by itself or in another hand; fingers opened, palm lifted by metres."""

    def target(t: float) -> Floats:
        values = grip.hand(prop.matrix, who.facing @ Vector((sign(side) * 0.5, 0.4, -0.85)))
        values[2] += lift
        values[12:15] *= opening
        return values

    return target


def blend(a: Matrix, b: Matrix, w: float) -> Matrix:
    """Return the rigid motion between two world matrices."""
    turn = a.to_quaternion().slerp(b.to_quaternion(), w)
    matrix = turn.to_matrix().to_4x4()
    matrix.translation = a.translation.lerp(b.translation, w)
    return matrix


def standing(place: Vector, yaw: float) -> Matrix:
    """Return the matrix of a thing that stands upright; yaw in radians."""
    return Matrix.Translation(place) @ Matrix.Rotation(yaw, 4, "Z")


def facing_yaw(direction: Vector) -> float:
    """Return the yaw that faces a direction."""
    return math.atan2(direction.x, -direction.y)


def _still(matrix: Matrix) -> MatrixOf:
    return lambda t: matrix


def _from_anchor(anchor: Anchor, side: str, named: str) -> Grip:
    index, fingers, thumb = anchor.curl
    curl = (85 * index, 85 * fingers, 45 * thumb)
    grip = Grip(Vector(anchor.location), Vector(anchor.direction), Vector(anchor.normal), curl)
    made_for_left = named.endswith(("_l", "_left"))
    return grip if (side == "L") == made_for_left else grip.mirrored()
