"""Brings a motion of any skeleton onto numbers that fit ours: orientations from a T-pose, places in legs."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Final

import numpy as np

from storyblender.errors import InputError
from storyblender.geometry.mocap import BONES, RATE, MocapPoses
from storyblender.geometry.rotations import (
    about_axis,
    blended,
    continuous,
    matrices_of,
    quaternions_of,
)
from storyblender.geometry.solids import Floats
from storyblender.library.mocap.contacts import find_stands
from storyblender.library.mocap.reference import AHEAD, UP, Reference, reference_of
from storyblender.library.mocap.roles import Roles, find_roles
from storyblender.library.mocap.source_motion import SourceMotion

SIDES: Final = ("L", "R")
STAYS: Final = 0.3
"""Legs on the floor below which a motion stays where it is."""
FACES: Final = np.radians(25.0)
"""Radians below which it keeps facing the same way."""
_SWAY: Final = 0.3
"""Seconds over which the path on the floor is smoothed; what is quicker is the hips' own."""
_STILL: Final = 0.06
"""Radians a second, in the mean of all bones, or legs a second of hips and hands, below which a clip is still."""
_LEFT_STILL: Final = 0.2
"""Seconds of stillness that are kept at either end."""
_JUMP: Final = np.radians(8.0)
"""Mean turn of the joints between the first two frames of a file that begins with its rest."""
RELAXED: Final = (16.0, 22.0, 0.0)
"""Degrees of the fingers of a skeleton that has none."""


def retarget(motion: SourceMotion) -> MocapPoses:
    """Return a motion of a file as poses of ours.

    Args:
        motion: As the file has it.

    Raises:
        InputError: It is not that of a person.
    """
    motion = motion.checked()
    roles = find_roles(motion)
    reference = reference_of(motion, roles)
    motion = _without_rest(motion).resampled()
    places = motion.places @ reference.upright.T
    leg = _leg_of(motion, roles)
    if not leg > 1e-6:
        raise InputError("its legs have no length")
    seen = _orientations(motion, roles, reference)
    turns = _turns(seen, roles, reference)
    middle = (places[:, roles.limbs["thigh.L"]] + places[:, roles.limbs["thigh.R"]]) / 2 / leg
    ankles = np.stack([places[:, roles.limbs[f"foot.{side}"]] for side in SIDES], axis=1) / leg
    toes = np.stack([places[:, _toe(motion, roles, side)] for side in SIDES], axis=1) / leg
    floor = float(np.percentile(ankles[..., 2].min(axis=1), 5))
    root = _root(turns[:, BONES.index("hips")], middle)
    back = about_axis(2, -root[:, 2])
    hips = np.einsum("nij,nj->ni", back, middle - np.c_[root[:, :2], np.zeros(len(root))])
    hips[:, 2] = middle[:, 2] - floor
    feet = np.stack([_foot(seen, roles, reference, side, back) for side in SIDES], axis=1)
    poses = MocapPoses(
        root=root,
        hips=hips,
        turns=continuous(quaternions_of(back[:, None] @ turns)),
        feet=feet,
        curls=np.stack([_curls(seen, roles, side) for side in SIDES], axis=1),
        apart=_apart(places, roles, turns) / leg,
        stands=find_stands(ankles, toes),
    )
    return _from_origin(trimmed(poses))


def _without_rest(motion: SourceMotion) -> SourceMotion:
    """Return a motion without a first frame that is only the rest."""
    if len(motion.places) < 6:
        return motion
    traces = np.trace(np.swapaxes(motion.turns[:5], -1, -2) @ motion.turns[1:6], axis1=-2, axis2=-1)
    steps = np.arccos(np.clip((traces - 1) / 2, -1, 1)).mean(axis=1)
    if steps[0] < _JUMP or steps[0] < 5 * np.median(steps[1:]):
        return motion
    return replace(motion, turns=motion.turns[1:], places=motion.places[1:])


def _leg_of(motion: SourceMotion, roles: Roles) -> float:
    """Return the length of a leg, in the file's units."""
    lengths = [
        np.linalg.norm(motion.places[0, roles.limbs[f"{low}.{side}"]] - motion.places[0, roles.limbs[f"{high}.{side}"]])
        for side in SIDES
        for high, low in (("thigh", "shin"), ("shin", "foot"))
    ]
    return float(sum(lengths)) / 2


def _toe(motion: SourceMotion, roles: Roles, side: str) -> int:
    """Return the joint of the toes; without one, what is below the foot, or the foot."""
    foot = roles.limbs[f"foot.{side}"]
    return roles.limbs.get(f"toe.{side}", next(iter(motion.children(foot)), foot))


def _orientations(motion: SourceMotion, roles: Roles, reference: Reference) -> Floats:
    """Return the orientations (N, J, 3, 3) of all joints in our axes, from the reference pose."""
    return reference.upright @ motion.turns @ reference.still


def _along(chain: list[Floats], share: float) -> Floats:
    """Return the orientation (N, 3, 3) at a share of a chain of joints, from its first to its last."""
    if len(chain) == 1:
        return chain[0]
    at = share * (len(chain) - 1)
    low = min(int(at), len(chain) - 2)
    one, two = quaternions_of(chain[low]), quaternions_of(chain[low + 1])
    return matrices_of(blended(one, two, np.full(len(one), at - low)))


def _turns(seen: Floats, roles: Roles, reference: Reference) -> Floats:
    """Return the orientations (N, B, 3, 3) of our bones, from the T-pose."""
    trunk = [seen[:, joint] for joint in (roles.hips, *roles.spine)]
    chest = trunk[-1]
    above = [
        chest,
        *(seen[:, joint] for joint in roles.neck),
        *([seen[:, roles.head]] if roles.head is not None else []),
    ]
    found = {"hips": trunk[0], "spine": _along(trunk, 1 / 3), "chest": _along(trunk, 2 / 3), "upper_chest": chest}
    found |= {"neck": _along(above, 0.5), "head": above[-1]}
    for name in BONES[len(found) :]:
        joint = roles.limbs.get(name)
        found[name] = chest if joint is None else seen[:, joint]
    return np.stack([found[name] for name in BONES], axis=1) @ reference.from_t


def _root(hips: Floats, middle: Floats) -> Floats:
    """Return the path (N, 3) of the root: x, y, yaw; it stays, and keeps facing the same way, where the person does.

    Args:
        hips: (N, 3, 3) orientations.
        middle: (N, 3) of the hip joints, in legs.
    """
    ahead, up = hips @ AHEAD, hips @ UP
    level = ahead[:, :2] - ahead[:, 2:] * up[:, :2]  # on the back or on the front they face as before they lay down
    yaw = np.unwrap(np.arctan2(level[:, 0], -level[:, 1]))
    path = middle[:, :2]
    span = np.linalg.norm(path - path[0], axis=1)
    path = np.tile(path.mean(axis=0), (len(path), 1)) if span[-1] < STAYS and span.max() < 2 * STAYS else _smooth(path)
    facing = np.full(len(yaw), yaw.mean()) if np.abs(yaw - yaw[0]).max() < FACES else _smooth(yaw[:, None])[:, 0]
    return np.c_[path, facing]


def _smooth(values: Floats) -> Floats:
    """Return values (N, C) smoothed over time, the ends held."""
    reach = int(2 * _SWAY * RATE)
    at = np.arange(-reach, reach + 1) / RATE
    weights = np.exp(-0.5 * (at / _SWAY) ** 2)
    padded = np.pad(values, ((reach, reach), (0, 0)), mode="reflect", reflect_type="odd")
    columns = [np.convolve(column, weights / weights.sum(), mode="valid") for column in padded.T]
    return np.stack(columns, axis=1)


def _foot(seen: Floats, roles: Roles, reference: Reference, side: str, back: Floats) -> Floats:
    """Return yaw (rad), pitch and pitch of the toes (degrees) of a foot (N, 3), in the frame of the root."""
    yaw = reference.toe_out[SIDES.index(side)]
    rest = np.array([np.sin(yaw), -np.cos(yaw), 0.0])
    along = np.einsum("nij,njk,k->ni", back, seen[:, roles.limbs[f"foot.{side}"]], rest)
    toe = roles.limbs.get(f"toe.{side}")
    tip = along if toe is None else np.einsum("nij,njk,k->ni", back, seen[:, toe], rest)
    pitch, tip_pitch = (np.degrees(np.arcsin(np.clip(each[:, 2], -1, 1))) for each in (along, tip))
    facing = np.unwrap(np.arctan2(along[:, 0], -along[:, 1]))
    facing -= 2 * np.pi * np.round(facing.mean() / (2 * np.pi))
    return np.stack([facing, pitch, np.clip(tip_pitch - pitch, -60, 60)], axis=1)


def _apart(places: Floats, roles: Roles, turns: Floats) -> Floats:
    """Return the way (N, 3) from the right wrist to the left one in the frame of the chest, in the file's units."""
    way = places[:, roles.limbs["hand.L"]] - places[:, roles.limbs["hand.R"]]
    return np.einsum("nji,nj->ni", turns[:, BONES.index("upper_chest")], way)


def _curls(seen: Floats, roles: Roles, side: str) -> Floats:
    """Return the degrees (N, 3) by which index finger, other fingers and thumb are bent."""
    hand = np.swapaxes(seen[:, roles.limbs[f"hand.{side}"]], -1, -2)
    columns: list[Floats] = []
    for name, relaxed in zip(("index", "fingers", "thumb"), RELAXED, strict=True):
        joints = roles.fingers.get(f"{name}.{side}", ())
        if not joints:
            columns.append(np.full(len(seen), relaxed))
            continue
        trace = [np.trace(hand @ seen[:, joint], axis1=1, axis2=2) for joint in joints]
        angles = np.degrees(np.arccos(np.clip((np.array(trace) - 1) / 2, -1, 1)))
        columns.append(np.clip(angles.mean(axis=0), 0, 95))
    return np.stack(columns, axis=1)


def trimmed(poses: MocapPoses) -> MocapPoses:
    """Return a motion without stillness at its ends.

    Args:
        poses: Of a whole file.
    """
    steps = 2 * np.arccos(np.clip(np.abs(np.sum(poses.turns[1:] * poses.turns[:-1], axis=-1)), 0, 1)).mean(axis=1)
    places = np.c_[poses.root[:, :2] + poses.hips[:, :2], poses.hips[:, 2]]
    speeds = np.maximum(steps, np.linalg.norm(np.diff(places, axis=0), axis=1)) * RATE
    moving = np.flatnonzero(_mean_of_3(speeds) > _STILL)
    if not len(moving):
        return poses
    kept = int(_LEFT_STILL * RATE)
    return _cut(poses, slice(max(0, int(moving[0]) - kept), int(moving[-1]) + 2 + kept))


def _mean_of_3(values: Floats) -> Floats:
    return np.convolve(np.pad(values, 1, mode="edge"), np.full(3, 1 / 3), mode="valid")


def _cut(poses: MocapPoses, part: slice) -> MocapPoses:
    arrays = {each.name: getattr(poses, each.name) for each in fields(poses)}
    return replace(poses, **{name: array[part] for name, array in arrays.items() if isinstance(array, np.ndarray)})


def _from_origin(poses: MocapPoses) -> MocapPoses:
    """Return a motion that begins at the origin, facing -Y."""
    turn = about_axis(2, -poses.root[0, 2])[:2, :2]
    path = (poses.root[:, :2] - poses.root[0, :2]) @ turn.T
    root = np.c_[path, poses.root[:, 2] - poses.root[0, 2]]
    return replace(poses, root=root)
