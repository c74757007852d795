"""Props during a shot: their grips, which hand holds them when, and their world matrix at a moment."""

from __future__ import annotations

import math
from bisect import insort
from collections.abc import Callable
from dataclasses import dataclass, replace

from mathutils import Euler, Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp, smooth
from storyblender.blender.motion.hands import Triple, chest_yaw, fixed_hand, hand, shoulder_rest
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageProp
from storyblender.blender.motion.skeleton import frame, rigid_matrix, sign
from storyblender.catalog.carrying import two_handed
from storyblender.memory.asset_sheet import Anchor

MatrixOf = Callable[[float], Matrix]
HANGING = 0.25
"""Metres; props taller than this with a grip near the top hang from a straight arm."""
STAFF, SLENDER, STAFF_GRIP = 0.7, 0.16, 1.0
"""Metres: least height of a staff, its largest thickness, and the largest height of the hand on it."""
SHEET = 0.012
"""Metres; thinner props are papers: carried on edge in a low hand, not level like a plate."""
ON_TABLE, OVER_TABLE, CLEAR = 0.05, 0.12, 0.03
"""Metres at a table, times the scale: a held prop is this much farther in than an empty hand; its palm is this much
above the top if its grip is lower than the last."""
SETTLE = 0.3
"""Seconds in which a prop settles into a new hand, while both move."""


@dataclass(frozen=True)
class Grip:
    """How a hand holds a prop, in the prop's frame (metres).

    Attributes:
        palm: Palm centre.
        fingers: Direction of the fingers.
        normal: Direction out of the palm, into the prop.
        curl: Degrees of index finger, other fingers and thumb.
    """

    palm: Vector
    fingers: Vector
    normal: Vector
    curl: Triple

    def mirrored(self) -> Grip:
        """Return the same grip for the other hand."""
        flip = Vector((-1, 1, 1))
        return Grip(self.palm * flip, self.fingers * flip, self.normal * flip, self.curl)

    def opposite(self) -> Grip:
        """Return the same grip for a person who faces the holder."""
        flip = Vector((-1, -1, 1))
        return Grip(self.palm * flip, self.fingers * flip, self.normal * flip, self.curl)

    def hand_target(self, prop: Matrix, pole: Vector) -> Floats:
        """Return the hand target for a prop at world matrix ``prop``; ``pole`` is the world direction of the elbow."""
        turn = prop.to_3x3()
        return hand(prop @ self.palm, turn @ self.fingers, turn @ self.normal, pole, self.curl)


class StagedProp:
    """A movable prop during a shot.

    Args:
        asset_id: Asset of the prop.
        prop: Where it is at first, its size and its grips.
    """

    def __init__(self, asset_id: str, prop: StageProp) -> None:
        self.asset_id, self.node_id = asset_id, prop.node_id
        self.size = Vector(prop.dimensions)
        self.both = False
        """Whether the script wants both hands on it."""
        self.anchors = {a.name or a.kind: a for a in prop.anchors if a.kind in ("grip", "handle")}
        self.matrix = Matrix(prop.world.tolist())
        if prop.state is not None and prop.state.location is not None:
            turn = Euler([math.radians(angle) for angle in prop.state.rotation]).to_matrix().to_4x4()
            self.matrix = Matrix.Translation(prop.state.location) @ turn
        self._events: list[tuple[float, MatrixOf, float]] = [(-1e9, _still(self.matrix), 0.0)]
        self.holder: Performer | None = None
        """Its holder after everything planned so far."""
        self.flight: MatrixOf | None = None
        """Its last flight through the air."""

    @property
    def two_handed(self) -> bool:
        """Whether both hands carry it."""
        return self.both or two_handed(tuple(self.size), tuple(self.anchors.values()))

    @property
    def hangs(self) -> bool:
        """Whether it hangs from a straight arm, like a suitcase."""
        grip = self.grip("R")
        return self.size.z > HANGING and grip.palm.z > 0.75 * self.size.z and not self.two_handed

    @property
    def is_staff(self) -> bool:
        """Whether it is carried upright with one end on the floor: walking stick, spear, broom."""
        return self.size.z > STAFF and max(self.size.x, self.size.y) < SLENDER and not self.anchors

    @property
    def is_sheet(self) -> bool:
        """Whether it is carried on edge: letter, envelope, ticket, photograph."""
        return self.size.z < SHEET and not self.two_handed

    @property
    def centre(self) -> Vector:
        """World point in the middle of it, in the current pose."""
        return self.matrix @ Vector((0, 0, self.size.z / 2))

    def grip(self, side: str, name: str = "") -> Grip:
        """Return the grip of a hand, at an anchor or on the side of the bounding box; on a sheet the fingers lie flat.

        Args:
            side: ``L`` or ``R``.
            name: Anchor to hold it by; empty for the hand's own or the first, and for none on a two-handed prop.
        """
        grip = self._grip(side, name)
        flat = self.is_sheet and grip.normal.z > 0.7
        return replace(grip, curl=(1.0, 2.0, min(grip.curl[2], 0.0))) if flat else grip

    def _grip(self, side: str, name: str) -> Grip:
        """Return the grip at the named anchor, at the first anchor, or on the side of the bounding box."""
        if not self.two_handed or name:
            for key in (name, f"grip_{side.lower()}", f"{name}_{side.lower()}", f"handle_{side.lower()}"):
                if key and key in self.anchors:
                    return _from_anchor(self.anchors[key], side, named=key)
            first = next((a for key, a in self.anchors.items() if key != "support"), None)
            if first is not None:
                return _from_anchor(first, side, named=first.name)
        return self._side_grip(side)

    def _side_grip(self, side: str) -> Grip:
        """Return a grip on the side of the bounding box; the person's left is the prop's +X."""
        s = sign(side)
        if self.size.z < 0.06 and not self.two_handed:  # sheets and books: from below, thumb on top
            return Grip(Vector((0, 0.35 * self.size.y, -0.012)), Vector((0, -1, 0)), Vector((0, 0, 1)), (12, 14, -30))
        height = min(0.92 * self.size.z, STAFF_GRIP) if self.is_staff else 0.45 * self.size.z
        palm = Vector((s * (self.size.x / 2 + 0.006), 0.0, height))
        curl = (10, 12, 0) if self.two_handed or self.size.x > 0.12 else (48, 52, 28)
        return Grip(palm, Vector((-s * 0.25, -1, -0.1)), Vector((-s, -0.2, 0)), curl)

    def stand(self, t: float, matrix: Matrix) -> None:
        """Leave it at a world matrix from ``t`` seconds on."""
        self.holder = None
        insort(self._events, (t, _still(matrix), 0.12), key=lambda event: event[0])

    def follow(self, t: float, matrix: MatrixOf, settle: float = SETTLE) -> None:
        """Follow a movement given as its world matrix over time.

        Args:
            t: Second at which it begins to follow.
            matrix: Function from seconds to its world matrix.
            settle: Seconds of blending from its former movement.
        """
        insort(self._events, (t, matrix, settle), key=lambda event: event[0])

    def hold(self, t: float, who: Performer, side: str, grip: Grip, settle: float = SETTLE) -> None:
        """Follow the hand that holds it.

        Args:
            t: Second at which it begins to follow.
            who: Its holder from then on.
            side: ``L`` or ``R``.
            grip: How the hand holds it.
            settle: Seconds of blending from its former movement.
        """
        self.holder = who
        self.follow(t, lambda _: matrix_in_hand(who, side, grip), settle)

    def evaluate(self, t: float) -> Matrix:
        """Set and return its world matrix at ``t`` seconds; the hands must be posed."""
        last = max(i for i, (start, _, _) in enumerate(self._events) if start <= t)
        start, matrix, settle = self._events[last]
        here = matrix(t)
        share = clamp((t - start) / settle) if settle else 1.0
        if share < 1 and last:
            here = blend_matrices(self._events[last - 1][1](t), here, smooth(share))
        self.matrix = here
        return here


def matrix_in_hand(who: Performer, side: str, grip: Grip) -> Matrix:
    """Return the world matrix of a prop in a posed hand.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        grip: How the hand holds it.
    """
    axes, palm = who.hand_matrix(side)
    turn = axes @ frame(grip.fingers, grip.normal).transposed()
    return rigid_matrix(turn, palm - turn @ grip.palm)


def carrying_hand(who: Performer, side: str, prop: StagedProp) -> TargetOf:
    """Return the target of a hand that carries a prop.

    Upright before the body; bags from a straight arm; large props in both hands; a person who sits at a table has a cup
    stand on it, and holds a letter above it.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        prop: What the hand holds.
    """
    grip = prop.grip(side)
    s, m = sign(side), who.measures
    if side in who.table and not (prop.two_handed or prop.hangs or prop.is_staff):
        ahead = who.table[side].xy + who.forward * (ON_TABLE * m.scale)
        above = grip.palm.z if grip.palm.z > CLEAR else OVER_TABLE * m.scale
        turn = Matrix.Rotation(who.yaw, 3, "Z")
        return fixed_hand(
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
            ahead = who.measures.front + prop.size.y / 2 + 0.03
            base = who.to_world(middle) + turn @ Vector((0, -ahead, -0.62 * m.arm - grip.palm.z))
            return grip.hand_target(rigid_matrix(turn, base), turn @ Vector((s * 0.8, 0.6, -0.5)))
        chest = who.bones.orient["upper_chest"]
        if (chest @ Vector((0, -1, 0))).z > 0.5:  # lying on the back
            turn = who.facing @ chest
            place = who.to_world(shoulder_rest(who, side)) + turn @ (Vector((-s * 0.15, -0.40, -0.35)) * m.arm)
            return hand(place, turn @ grip.fingers, turn @ grip.normal, turn @ Vector((s * 0.9, 0, -0.5)), grip.curl)
        at = (0.03, 0.42, -0.58)
        if prop.hangs:
            at = (0.10 + 0.5 * min(prop.size.x, prop.size.y) / m.arm, 0.04, -0.97)
            if prop.size.x > prop.size.y:  # a case goes along the leg
                turn = turn @ Matrix.Rotation(s * math.pi / 2, 3, "Z")
        if prop.is_staff and not float(who.pinned(t)):
            foot = who.place + who.facing @ Vector((s * 0.26 * m.scale, -0.22 * m.scale, 0))
            return grip.hand_target(Matrix.Translation(foot) @ who.facing.to_4x4(), pole)
        beside = who.facing @ Matrix.Rotation(chest_yaw(who), 3, "Z")
        fingers, palm = turn @ grip.fingers, turn @ grip.normal
        if prop.is_sheet and not float(who.pinned(t)):
            at = (0.06, 0.32, -0.72)
            fingers, palm = beside @ Vector((-0.15 * s, -0.95, -0.3)), beside @ Vector((-s, 0.1, 0.25))
        place = who.to_world(shoulder_rest(who, side)) + beside @ (Vector((s * at[0], -at[1], at[2])) * m.arm)
        return hand(place, fingers, palm, pole, grip.curl)

    return target


def gripping_hand(
    who: Performer, side: str, prop: StagedProp, grip: Grip, opening: float = 1.0, lift: float = 0.0
) -> TargetOf:
    """Return the target of a hand on a moving prop.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        prop: Followed as it moves.
        grip: How the hand holds it.
        opening: Factor on the curl of the fingers; less is more open.
        lift: Metres of the palm above the grip.
    """

    def target(t: float) -> Floats:
        values = grip.hand_target(prop.matrix, who.facing @ Vector((sign(side) * 0.5, 0.4, -0.85)))
        values[2] += lift
        values[12:15] *= opening
        return values

    return target


def blend_matrices(a: Matrix, b: Matrix, w: float) -> Matrix:
    """Return the rigid motion between two world matrices; ``w`` is the share of ``b``, 0..1."""
    turn = a.to_quaternion().slerp(b.to_quaternion(), w)
    return rigid_matrix(turn.to_matrix(), a.translation.lerp(b.translation, w))


def upright_matrix(place: Vector, yaw: float) -> Matrix:
    """Return the world matrix of something upright at ``place`` (world metres) with ``yaw`` in radians."""
    return Matrix.Translation(place) @ Matrix.Rotation(yaw, 4, "Z")


def _still(matrix: Matrix) -> MatrixOf:
    """Return a function of seconds that always gives ``matrix``."""
    return lambda t: matrix


def _from_anchor(anchor: Anchor, side: str, named: str) -> Grip:
    """Return the grip of a hand at an anchor, mirrored if the anchor is ``named`` for the other hand."""
    index, fingers, thumb = anchor.curl
    curl = (85 * index, 85 * fingers, 45 * thumb)
    grip = Grip(Vector(anchor.location), Vector(anchor.direction), Vector(anchor.normal), curl)
    made_for_left = named.endswith(("_l", "_left"))
    return grip if (side == "L") == made_for_left else grip.mirrored()
