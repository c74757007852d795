"""How a skeleton stands when its bones are not turned: which way is up, which way it faces, how its limbs point.

A file's rest need not be a pose of a person, as where all bones point along one axis; then a frame of the motion is
taken in its place, or, if no frame is one of a person who stands straight, the way the joints bend says how they turn.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from storyblender.geometry.mocap import BONES
from storyblender.geometry.rotations import axes_along, shortest_arc, unit
from storyblender.geometry.solids import Floats
from storyblender.library.mocap.roles import Roles
from storyblender.library.mocap.source_motion import SourceMotion

UP, AHEAD, LEFT = np.array([0.0, 0, 1]), np.array([0.0, -1, 0]), np.array([1.0, 0, 0])
DOWN = -UP
STRAIGHT: Final = 0.8
"""Least cosine with straight down of thighs and shins, and least part of upright of a trunk, in a pose to go by."""
_FOLDED: Final = 0.6
"""Least cosine between upper arm and forearm in such a pose."""
_SAMPLES: Final = 60
"""Frames looked at for one."""


@dataclass(frozen=True)
class Reference:
    """The pose that orientations are counted from.

    Attributes:
        upright: (3, 3) from the file's axes to ours: Z up; of the rest facing -Y.
        still: (3, 3) that applied after a joint's orientation in the reference pose takes that away, by joint.
        from_t: (B, 3, 3) rotations from our T-pose to the reference pose, by bone of ``BONES``.
        toe_out: Yaw of each foot in it, radians; left, right.
    """

    upright: Floats
    still: Floats
    from_t: Floats
    toe_out: Floats


def reference_of(motion: SourceMotion, roles: Roles) -> Reference:
    """Return the pose that the orientations of a motion are counted from.

    Args:
        motion: Any skeleton of a person.
        roles: Its joints.
    """
    count = len(motion.names)
    upright = _axes_of(motion.rest, roles)
    if _is_straight(motion.rest @ upright.T, roles):
        return _reference(motion, upright, upright, motion.rest @ upright.T, np.tile(np.eye(3), (count, 1, 1)), roles)
    world = _world(motion, roles)
    for frame in np.unique(np.linspace(0, len(motion.places) - 1, _SAMPLES).astype(int)):
        own = _axes_of(motion.places[frame], roles, world)
        places = motion.places[frame] @ own.T
        if _is_straight(places, roles):
            return _reference(motion, world, own, places, np.swapaxes(motion.turns[frame], -1, -2), roles)
    own = _axes_of(motion.places[0], roles, world)
    back = np.swapaxes(motion.turns[0], -1, -2)
    return _reference(motion, world, own, motion.places[0] @ own.T, back, roles, bends=_bends(motion, roles, own))


def _world(motion: SourceMotion, roles: Roles) -> Floats:
    """Return the axes of the file's world, from how people mostly are in it: upright."""
    feet = (motion.places[:, roles.limbs["foot.L"]] + motion.places[:, roles.limbs["foot.R"]]) / 2
    top = motion.places[:, roles.spine[-1] if roles.spine else roles.hips]
    rise = unit(top - feet).mean(axis=0)
    axis = int(np.argmax(np.abs(rise)))
    return shortest_arc(np.eye(3)[axis] * np.sign(rise[axis]), UP)


def _axes_of(places: Floats, roles: Roles, world: Floats | None = None) -> Floats:
    """Return the rotation to our axes in which a pose faces -Y; up is an axis of the file, the one nearest to it."""
    limbs = roles.limbs
    if world is None:
        feet = (places[limbs["foot.L"]] + places[limbs["foot.R"]]) / 2
        rise = places[roles.hips] - feet
        axis = int(np.argmax(np.abs(rise)))
        up = np.eye(3)[axis] * (np.sign(rise[axis]) or 1.0)
    else:
        up = world.T @ UP
    left = places[limbs["thigh.L"]] - places[limbs["thigh.R"]]
    left = left - up * (left @ up)
    if np.linalg.norm(left) < 1e-6:
        left = np.eye(3)[(int(np.argmax(np.abs(up))) + 1) % 3]
    left = unit(left)
    return np.array([left, np.cross(up, left), up])


def _direction(places: Floats, start: int, end: int) -> Floats:
    return unit(places[end] - places[start])


def _is_straight(places: Floats, roles: Roles) -> bool:
    """Tell whether a person stands straight in a pose (J, 3), with arms that are not folded: T, A or at ease."""
    limbs = roles.limbs
    for side in "LR":
        hip, knee, ankle = (places[limbs[f"{bone}.{side}"]] for bone in ("thigh", "shin", "foot"))
        shoulder, elbow, hand = (places[limbs[f"{bone}.{side}"]] for bone in ("upper_arm", "forearm", "hand"))
        if min(unit(knee - hip) @ DOWN, unit(ankle - knee) @ DOWN) < STRAIGHT:
            return False
        upper, fore = unit(elbow - shoulder), unit(hand - elbow)
        outward = upper @ (LEFT if side == "L" else -LEFT)
        if upper @ fore < _FOLDED or max(outward, upper @ DOWN) < _FOLDED or outward < -0.2:
            return False
    chest = places[roles.spine[-1] if roles.spine else limbs["upper_arm.L"]]
    return bool(unit(chest - places[roles.hips]) @ UP > STRAIGHT) or not roles.spine


def _bends(motion: SourceMotion, roles: Roles, own: Floats) -> dict[str, Floats]:
    """Return the axis of each knee and elbow in the first frame, by the bone above: as where it bends most."""
    found: dict[str, Floats] = {}
    for upper, lower, end in (("thigh", "shin", "foot"), ("upper_arm", "forearm", "hand")):
        for side in "LR":
            a, b, c = (motion.places[:, roles.limbs[f"{bone}.{side}"]] for bone in (upper, lower, end))
            hinge = np.cross(b - a, c - b)
            most = int(np.argmax(np.linalg.norm(hinge, axis=1)))
            joint = roles.limbs[f"{upper}.{side}"]
            back = motion.turns[0, joint] @ motion.turns[most, joint].T
            if np.linalg.norm(hinge[most]) > 1e-6 * max(1.0, float(np.abs(motion.places).max())):
                found[f"{upper}.{side}"] = unit(own @ back @ hinge[most])
    return found


def _reference(
    motion: SourceMotion,
    upright: Floats,
    own: Floats,
    places: Floats,
    still: Floats,
    roles: Roles,
    bends: dict[str, Floats] | None = None,
) -> Reference:
    """Return a reference pose.

    Args:
        motion: The skeleton.
        upright: To our axes, of the motion.
        own: To our axes in which the reference pose faces -Y.
        places: (J, 3) the reference pose, in those.
        still: (J, 3, 3) that take away the orientations that joints have in it.
        roles: The joints.
        bends: Axes of knees and elbows in it, where its limbs are not straight.
    """
    limbs, from_t = roles.limbs, np.tile(np.eye(3), (len(BONES), 1, 1))
    for side, out in (("L", LEFT), ("R", -LEFT)):
        for upper, lower, end, plain, hinge in (
            ("thigh", "shin", "foot", DOWN, LEFT),
            ("upper_arm", "forearm", "hand", out, UP * (-1 if side == "L" else 1)),
        ):
            for bone, start, stop in ((upper, upper, lower), (lower, lower, end)):
                there = _direction(places, limbs[f"{start}.{side}"], limbs[f"{stop}.{side}"])
                turn = shortest_arc(plain, there)
                axis = (bends or {}).get(f"{upper}.{side}")
                if axis is not None:
                    turn = axes_along(there, axis) @ axes_along(plain, hinge).T
                from_t[BONES.index(f"{bone}.{side}")] = turn
        fore = from_t[BONES.index(f"forearm.{side}")]
        from_t[BONES.index(f"hand.{side}")] = _hand(motion, places, roles, side, fore)
    toe_out = [_toe_out(places, roles, side) for side in "LR"]
    # from the file's axes of the reference pose to those in which it faces -Y, and from there to our T-pose
    return Reference(upright, still @ own.T, from_t, np.array(toe_out))


def _hand(motion: SourceMotion, places: Floats, roles: Roles, side: str, fore: Floats) -> Floats:
    """Return the rotation of a hand from our T-pose to the reference pose; its fingers say it, else the forearm.

    Args:
        motion: For what is below the hand.
        places: (J, 3) the reference pose.
        roles: The joints.
        side: ``L`` or ``R``.
        fore: (3, 3) the rotation of the forearm.
    """
    hand, out = roles.limbs[f"hand.{side}"], LEFT if side == "L" else -LEFT
    index, others, thumb = (list(roles.fingers.get(f"{name}.{side}", ())) for name in ("index", "fingers", "thumb"))
    below = [joint for joint in motion.children(hand) if joint not in thumb]
    tips = [*index, *others] or sorted(below, key=lambda joint: -unit(places[joint] - places[hand]) @ (fore @ out))[:1]
    along = places[tips].mean(axis=0) - places[hand] if tips else np.zeros(3)
    if np.linalg.norm(along) < 1e-6 or unit(along) @ (fore @ out) < STRAIGHT:
        return fore
    if index and others:
        across = places[index].mean(axis=0) - places[others].mean(axis=0)
    elif thumb:
        across = places[thumb].mean(axis=0) - places[hand]
    else:
        return shortest_arc(fore @ out, along) @ fore
    across = across - unit(along) * (across @ unit(along))
    if np.linalg.norm(across) < 1e-6:
        return shortest_arc(fore @ out, along) @ fore
    return axes_along(along, across) @ axes_along(out, AHEAD).T


def _toe_out(places: Floats, roles: Roles, side: str) -> float:
    """Return the yaw of a foot of a pose that faces -Y, radians; 0 where no toes say it."""
    toe = roles.limbs.get(f"toe.{side}")
    if toe is None:
        return 0.0
    along = places[toe] - places[roles.limbs[f"foot.{side}"]]
    ahead = float(along @ AHEAD)
    return float(np.clip(np.arctan2(along[0], ahead), -0.6, 0.6)) if ahead > 1e-6 else 0.0
