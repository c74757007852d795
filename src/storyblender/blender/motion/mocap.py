"""Plays a recorded motion on a person: trunk and head over what they act, hands, hips and feet as targets.

The feet stand where they are put down: each contact is one place on the floor, and what lies between is bent so that it
leads from one to the next. So nothing slides on a person of any size, on a path of any length.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from mathutils import Matrix, Quaternion, Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp, smooth
from storyblender.blender.motion.hands import hand
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, sign
from storyblender.geometry.mocap import BONES, RATE, MocapPoses
from storyblender.geometry.rotations import about_axis, matrices_of

FADE: Final = 0.45
"""Seconds from what is acted into the recording, and back."""
FADE_SHARE: Final = 0.3
"""Most of a short recording that a fade takes."""
OVERLAID: Final = ("spine", "chest", "upper_chest", "neck", "head")
"""Bones that are laid over what is acted; the others follow targets."""
KEPT_FOOT, KEPT_YAW = 0.12, math.radians(25)
"""Metres, times the scale, and radians by which a foot may stand otherwise than recorded: then it stays."""
CLEARANCE: Final = 0.02
"""Metres, times the scale, that a foot in the air is over the floor in the middle of its way, at least."""
TOGETHER, APART = 0.15, 0.35
"""Legs between the wrists: nearer, the hands meet as recorded; farther, each arm is as recorded."""
_ELBOW: Final = 0.08
"""Share of the elbow direction that the upper arm's own roll has; it counts where the arm is almost straight."""
_AHEAD, _DOWN = np.array([0.0, -1, 0]), np.array([0.0, 0, -1])


class MocapLayer:
    """A recording on one person from ``start`` to ``end`` seconds.

    Args:
        who: The person.
        poses: The recording.
        start: Second of the shot.
        end: Second of the shot; a recording that is over before is in its last pose, or loops.
        pace: Seconds of the recording a second.
    """

    def __init__(self, who: Performer, poses: MocapPoses, start: float, end: float, pace: float = 1.0) -> None:
        self.who, self.poses, self.start, self.end, self.pace = who, poses, start, end, pace
        self.fade = min(FADE, FADE_SHARE * (end - start))
        self._turns = [[Quaternion(each) for each in row] for row in poses.turns.tolist()]

    def weight(self, t: float) -> float:
        """Return how much of the recording shows at ``t`` seconds, 0..1."""
        return smooth(clamp((t - self.start) / self.fade)) * smooth(clamp((self.end - t) / self.fade))

    def at(self, t: float) -> tuple[int, int, float]:
        """Return the poses before and after ``t`` seconds, and the share of the second."""
        last = len(self._turns) - 1
        row = max(0.0, (t - self.start) * self.pace * RATE)
        row = row % last if self.poses.loops and row > last else min(row, last)
        low = min(int(row), last - 1)
        return low, low + 1, row - low

    def orient(self, bone: str, t: float) -> Matrix:
        """Return the recorded 3x3 orientation of a bone at ``t`` seconds, in the frame of the root, from the T-pose."""
        low, high, share = self.at(t)
        index = BONES.index(bone)
        return self._turns[low][index].slerp(self._turns[high][index], share).to_matrix()

    def turn(self, bone: str, t: float) -> Matrix:
        """Return the recorded turn of a bone of the trunk in the frame of its parent."""
        parent = "hips" if bone == "spine" else OVERLAID[OVERLAID.index(bone) - 1]
        return self.orient(parent, t).transposed() @ self.orient(bone, t)

    def hand(self, side: str, *, joined: bool = True) -> TargetOf:
        """Return the target of a hand: the recorded arm, from the chest as it is posed.

        Args:
            side: ``L`` or ``R``.
            joined: Whether the other hand does as recorded, too: hands that meet then meet on any shoulders.
        """
        who, out = self.who, Vector((sign(side), 0, 0))

        def target(t: float) -> Floats:
            start, elbow, end, upper, wrist = self._arm(side, t)
            if joined:
                end = end + self._joining(side, t, end)
            pole = (elbow - start.lerp(end, 0.5)) / who.measures.arm + upper @ Vector((0, _ELBOW, 0))
            along, palm = wrist @ out, wrist @ Vector((0, 0, -1))
            low, high, share = self.at(t)
            curls = self.poses.curls[[low, high], SIDES.index(side)]
            values = hand(
                who.to_world(end + who.palm_offset(side, along, palm)),
                who.facing @ along,
                who.facing @ palm,
                who.facing @ pole,
            )
            values[12:15] = curls[0] * (1 - share) + curls[1] * share
            return values

        return target

    def _chest(self, t: float) -> Matrix:
        """Return the turn from the recorded chest to the one that is posed."""
        return self.who.bones.orient["upper_chest"] @ self.orient("upper_chest", t).transposed()

    def _arm(self, side: str, t: float) -> tuple[Vector, Vector, Vector, Matrix, Matrix]:
        """Return shoulder, elbow and wrist (armature space), and the orientations of upper arm and hand."""
        bones, m, out, chest = self.who.bones, self.who.measures, Vector((sign(side), 0, 0)), self._chest(t)
        shoulder, upper, fore, wrist = (
            chest @ self.orient(f"{bone}.{side}", t) for bone in ("shoulder", "upper_arm", "forearm", "hand")
        )
        start = bones.point("upper_chest", bones.head[f"shoulder.{side}"] - bones.head["upper_chest"])
        start = start + shoulder @ (bones.head[f"upper_arm.{side}"] - bones.head[f"shoulder.{side}"])
        elbow = start + upper @ out * m.upper_arm
        return start, elbow, elbow + fore @ out * m.forearm, upper, wrist

    def _joining(self, side: str, t: float, end: Vector) -> Vector:
        """Return by how much a wrist moves so that both hands are as near to each other as recorded."""
        low, high, share = self.at(t)
        apart = self.poses.apart[low] * (1 - share) + self.poses.apart[high] * share
        weight = 1 - smooth(clamp((float(np.linalg.norm(apart)) - TOGETHER) / (APART - TOGETHER)))
        if weight <= 0:
            return Vector((0, 0, 0))
        other_end = self._arm("R" if side == "L" else "L", t)[2]
        wanted = self.who.bones.orient["upper_chest"] @ Vector((apart * (self.who.measures.leg * sign(side))).tolist())
        return (wanted - (end - other_end)) * (0.5 * weight)


@dataclass(frozen=True)
class MocapWay:
    """A recording on the floor of the set, K samples of ``RATE`` a second of the shot.

    Attributes:
        root: (K, 3) x, y (m), yaw (rad).
        hips: (K, 6) as the channel has them.
        feet: (2, K, 9) as the channels have them.
        down: (2,) whether each foot stands at the end.
    """

    root: Floats
    hips: Floats
    feet: Floats
    down: tuple[bool, bool]


def way_of(layer: MocapLayer, goal: Vector | None, *, turned: bool = True) -> MocapWay:
    """Return how a person goes through a recording from where they stand.

    Args:
        layer: The recording on that person, who is planned to stand as it begins.
        goal: Where they arrive, x and y in metres; None: they stay on the spot.
        turned: Whether they may end facing elsewhere; else the turn is taken back bit by bit.
    """
    who, poses, m = layer.who, layer.poses, layer.who.measures
    rows, shares, rounds = _samples(layer)
    root = _root(layer, rows, shares, rounds, goal)
    if not turned:
        root[:, 2] -= (root[-1, 2] - root[0, 2]) * np.linspace(0, 1, len(root))
    spin = about_axis(2, root[:, 2])
    turns = matrices_of(_mixed_turns(poses.turns, rows, shares))
    hips = _mixed(poses.hips, rows, shares) * m.leg
    bones = who.bones
    middle = np.array((bones.head["thigh.L"] + bones.head["thigh.R"]) / 2)
    centre = np.c_[hips[:, 0], middle[1] + hips[:, 1], m.ankle + hips[:, 2]]
    pelvis = turns[:, BONES.index("hips")]
    feet = np.zeros((2, len(rows), 9))
    stands = poses.stands[rows]
    for index, side in enumerate(SIDES):
        thigh, shin = (turns[:, BONES.index(f"{bone}.{side}")] for bone in ("thigh", "shin"))
        joint = centre + pelvis @ (np.array(bones.head[f"thigh.{side}"]) - middle)
        ankle = joint + thigh @ _DOWN * m.thigh + shin @ _DOWN * m.shin
        feet[index, :, :3] = np.einsum("nij,nj->ni", spin, ankle) + np.c_[root[:, :2], np.zeros(len(rows))]
        angles = _mixed(poses.feet[:, index], rows, shares)
        feet[index, :, 3] = root[:, 2] + angles[:, 0]
        feet[index, :, 4:6] = angles[:, 1:]
        feet[index, :, 6:9] = np.einsum("nij,nj->ni", spin, thigh @ _AHEAD)
        feet[index] = _planted(who, side, feet[index], stands[:, index], who.feet[side](layer.start))
    euler = _eulers(pelvis)
    channel = np.c_[hips[:, :2], centre[:, 2], euler]
    return MocapWay(root, channel, feet, (bool(stands[-1, 0]), bool(stands[-1, 1])))


def _samples(layer: MocapLayer) -> tuple[np.ndarray, Floats, np.ndarray]:
    """Return for each sample the pose before it, the share of the one after, and how often it began again."""
    last = len(layer.poses.root) - 1
    count = max(2, math.ceil((layer.end - layer.start) * RATE) + 1)
    at = np.arange(count) * layer.pace
    rounds = (at // last).astype(int) if layer.poses.loops else np.zeros(count, int)
    at = np.minimum(at - rounds * last, last)
    rows = np.minimum(at.astype(int), last - 1)
    return rows, at - rows, rounds


def _mixed(values: Floats, rows: np.ndarray, shares: Floats) -> Floats:
    return values[rows] * (1 - shares)[:, None] + values[rows + 1] * shares[:, None]


def _mixed_turns(turns: Floats, rows: np.ndarray, shares: Floats) -> Floats:
    mixed = turns[rows] * (1 - shares)[:, None, None] + turns[rows + 1] * shares[:, None, None]
    return mixed / np.linalg.norm(mixed, axis=-1, keepdims=True)


def _root(layer: MocapLayer, rows: np.ndarray, shares: Floats, rounds: np.ndarray, goal: Vector | None) -> Floats:
    """Return the path (K, 3) on the floor: as recorded from where the person stands, and then to the goal."""
    who, whole = layer.who, layer.poses.root
    path = _mixed(whole, rows, shares)
    for again in range(1, int(rounds[-1]) + 1):  # each round goes on from where the one before has led
        later = rounds >= again
        turn = about_axis(2, whole[-1, 2])[:2, :2]
        path[later, :2] = whole[-1, :2] + path[later, :2] @ turn.T
        path[later, 2] += whole[-1, 2]
    led = path[-1, :2] * who.measures.leg
    start = np.array(who.position)
    turn = about_axis(2, who.yaw)[:2, :2]
    if goal is None:
        moved = np.zeros((len(path), 2))
    else:
        moved = path[:, :2] * who.measures.leg @ turn.T
        moved = moved @ _onto(turn @ led, np.array(goal) - start).T
    return np.c_[start + moved, who.yaw + path[:, 2]]


def _onto(led: Floats, wanted: Floats) -> Floats:
    """Return the (2, 2) turn and stretch that brings one way on the floor onto another."""
    length = float(led @ led)
    if length < 1e-6:
        return np.eye(2)
    along, across = float(led @ wanted) / length, float(led[0] * wanted[1] - led[1] * wanted[0]) / length
    return np.array([[along, -across], [across, along]])


def _eulers(turns: Floats) -> Floats:
    """Return rotations (K, 3, 3) as degrees about x, y and z, without jumps."""
    found, before = list[tuple[float, ...]](), Matrix.Identity(3).to_euler("XYZ")
    for turn in turns.tolist():
        before = Matrix(turn).to_euler("XYZ", before)
        found.append(tuple(math.degrees(each) for each in before))
    return np.array(found)


def _planted(who: Performer, side: str, foot: Floats, stands: np.ndarray, now: Floats) -> Floats:
    """Return the targets of a foot (K, 9) so that it stands still where it stands, and nowhere goes below the floor.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        foot: As recorded.
        stands: (K,) whether it carries weight.
        now: Target of that foot as the recording begins.
    """
    foot, count = foot.copy(), len(foot)
    rolls = np.array([_roll(who, side, row) for row in foot])
    flat = foot[:, :3] - rolls
    at: list[int] = []
    moves: list[Floats] = []
    for begin, end in _runs(stands):
        place, yaw = flat[begin:end].mean(axis=0), float(foot[begin:end, 3].mean())
        kept = begin == 0 and math.dist(place[:2], now[:2]) < KEPT_FOOT * who.scale
        turned = (now[3] - yaw + math.pi) % (2 * math.pi) - math.pi
        if kept and abs(turned) < KEPT_YAW:
            place, yaw = now[:3].copy(), yaw + turned
        place[2] = who.measures.ankle
        for row in (begin, end - 1):
            at.append(int(row))
            moves.append(np.r_[place - flat[row], yaw - foot[row, 3]])
        foot[begin:end, 3] = yaw
        foot[begin:end, 5] = np.where(foot[begin:end, 4] < 0, -foot[begin:end, 4], foot[begin:end, 5])
        foot[begin:end, :3] = place + [_roll(who, side, row) for row in foot[begin:end]]
    if not at:
        return foot
    times, table = np.arange(count), np.array(moves)
    free = ~stands
    bent = np.stack([np.interp(times, at, column) for column in table.T], axis=1)
    foot[free, :4] += bent[free]
    for begin, end in _runs(free):
        for row in range(begin, end):
            lift = CLEARANCE * who.scale * math.sin(math.pi * (row - begin + 1) / (end - begin + 1))
            foot[row, 2] = max(foot[row, 2], who.measures.ankle + _roll(who, side, foot[row])[2] + lift)
    return foot


def _runs(flags: np.ndarray) -> list[tuple[int, int]]:
    """Return the first and the one-past-last index of each run of true flags."""
    edges = np.flatnonzero(np.diff(np.r_[0, flags.astype(int), 0]))
    return [(int(begin), int(end)) for begin, end in zip(edges[::2], edges[1::2], strict=True)]


def _roll(who: Performer, side: str, foot: Floats) -> Floats:
    """Return how far the ankle of a foot target is from where it would be if the foot stood flat, metres."""
    ankle = np.zeros(3)
    return np.array(who.rolled_ankle(side, ankle, float(foot[3]), float(foot[4])))
