"""Measures of a person for the motion solver: limbs, extents, contact heights of sitting (notes: motion, 3)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.motion.skeleton import SIDES, Skeleton, about, facing_yaw, sign
from storyblender.blender.people.body import RiggedBody
from storyblender.geometry.solids import Floats

CLOTH = 0.008
"""Metres of cloth between a sitter and the seat: trousers."""
JACKET = 0.034
"""Metres of cloth between a back and the chair, times the scale; less lets a jacket sink into the chair."""

PALM, THICKEST_PALM = 0.022, 0.06
"""Metres, times the scale, that the skin of a palm is at least, and at most, from the axis of the hand; what somebody's
model holds counts as its hand."""
SEATED = 0.1
"""Metres from the hip joint to the skin below and behind it, times the scale, of a body with no skin there."""

TUCKED = (-62.0, 58.0)
"""Degrees a foot behind a knee on the floor is pitched, and its toes, on which it stands."""
STEEPEST = 0.8
"""Sine of the most that a shin rises from a knee on the floor to the ankle."""


@dataclass(frozen=True)
class Measures:
    """Lengths in metres of one person, standing at the origin facing -Y.

    Attributes:
        scale: Stature over 1.7 m; multiplies every length authored for an average adult (local variable ``k``).
        thigh: Hip joint to knee.
        shin: Knee to ankle.
        ankle: Height of the ankle joint.
        hip_height: Height of the hip joints.
        hip_y: Their y.
        upper_arm: Shoulder to elbow.
        forearm: Elbow to wrist.
        hand: Wrist to middle knuckle.
        shoulder_height: Of the upper arm's joint.
        eye_height: Of the eyes.
        foot_y: y of the ankles.
        toe_out: Yaw of each resting foot, radians.
        chest_front: Extent of the chest towards -Y.
        chest_back: Extent of the chest towards +Y.
        belly_front: Extent of the belly towards -Y.
        buttocks_back: Extent towards +Y.
        radius: Half the width at the hips: the disc that walks through a set.
        seat_drop: Hip joint above the seat.
        seat_back: Hip joint in front of the backrest.
        lap: Top of a seated thigh above its axis.
        palm: By side, how far the skin of the palm is from the axis of the hand.
        tucked: Height of the ankle of a foot that stands on its bent toes, behind a knee on the floor.
    """

    scale: float
    thigh: float
    shin: float
    ankle: float
    hip_height: float
    hip_y: float
    upper_arm: float
    forearm: float
    hand: float
    shoulder_height: float
    eye_height: float
    foot_y: float
    toe_out: dict[str, float]
    chest_front: float
    chest_back: float
    belly_front: float
    buttocks_back: float
    radius: float
    seat_drop: float
    seat_back: float
    lap: float
    palm: dict[str, float]
    tucked: float

    @property
    def leg(self) -> float:
        """Hip joint to ankle, stretched."""
        return self.thigh + self.shin

    @property
    def arm(self) -> float:
        """Shoulder to wrist, stretched."""
        return self.upper_arm + self.forearm

    @property
    def stance(self) -> float:
        """Half the distance of the feet while standing."""
        return 0.088 * self.scale

    @property
    def knee(self) -> float:
        """Height of the joint of a knee that is on the floor."""
        return 0.075 * self.scale

    @property
    def kneeling_shin(self) -> float:
        """Distance of a knee on the floor from the ankle behind it, on the floor plan."""
        return math.sqrt(self.shin**2 - (self.tucked - self.knee) ** 2)

    @property
    def front(self) -> float:
        """How far the body reaches forward."""
        return max(self.chest_front, self.belly_front)


def measure(body: RiggedBody) -> Measures:
    """Return the measures of a body."""
    bones = Skeleton(body)
    head, k = bones.head, body.stature / 1.7
    skin = body.vertices
    torso = skin[np.abs(skin[:, 0]) < 0.10 * k]
    hip = head["thigh.L"]

    def span(low: float, high: float) -> tuple[float, float]:
        y = torso[(torso[:, 2] > low) & (torso[:, 2] < high)][:, 1]
        return (-float(y.min()), float(y.max())) if len(y) else (0.12 * k, 0.12 * k)

    chest_front, chest_back = span(head["chest"].z, head["neck"].z - 0.08 * k)
    belly_front, _ = span(head["hips"].z, head["chest"].z)
    _, buttocks_back = span(hip.z - 0.08 * k, hip.z + 0.12 * k)
    waist = skin[(np.abs(skin[:, 2] - hip.z - 0.05) < 0.10) & (np.abs(skin[:, 0]) < 0.3 * k)]
    drop, back, lap = _sit_down(body, bones)
    shin = (head["foot.L"] - head["shin.L"]).length
    return Measures(
        scale=k,
        thigh=(head["shin.L"] - hip).length,
        shin=shin,
        ankle=head["foot.L"].z,
        hip_height=hip.z,
        hip_y=hip.y,
        upper_arm=(head["forearm.L"] - head["upper_arm.L"]).length,
        forearm=(head["hand.L"] - head["forearm.L"]).length,
        hand=(bones.tail["hand.L"] - head["hand.L"]).length,
        shoulder_height=head["upper_arm.L"].z,
        eye_height=head["eye.L"].z,
        foot_y=head["foot.L"].y,
        toe_out={side: _toe_out(bones, side) for side in SIDES},
        chest_front=chest_front,
        chest_back=chest_back,
        belly_front=belly_front,
        buttocks_back=buttocks_back,
        radius=max(0.19 * k, float(np.percentile(np.abs(waist[:, 0]), 99)) if len(waist) else 0.0),
        seat_drop=drop,
        seat_back=back,
        lap=lap,
        palm={side: _palm_depth(body, bones, side) for side in SIDES},
        tucked=min(_over_tucked_toes(body, bones), 0.075 * k + STEEPEST * shin),
    )


def _palm_depth(body: RiggedBody, bones: Skeleton, side: str) -> float:
    """Return how far the skin of a palm is from the axis of the hand: more for gloves, paws and boxes."""
    bone = f"hand.{side}"
    _, palm = bones.hand_axes(side)
    skin = body.vertices[body.weights[:, bones.names.index(bone)] > 0.7]
    out = (skin - np.array(bones.head[bone])) @ np.array(palm.normalized())
    measured = float(np.median(out[out > 0])) if (out > 0).any() else 0.0
    return min(max(PALM, measured / bones.scale), THICKEST_PALM) * bones.scale


def _over_tucked_toes(body: RiggedBody, bones: Skeleton) -> float:
    """Return how high an ankle is above the lowest of the skin of a foot that stands on its bent toes."""
    pitch, toes = TUCKED
    bones.set_orient("foot.L", bones.pitch("L", pitch))
    bones.turn["toe.L"] = bones.pitch("L", toes)
    bones.update("toe.L")
    columns = [bones.names.index(name) for name in ("foot.L", "toe.L")]
    rows = np.flatnonzero(body.weights[:, columns].sum(1) > 0.5)
    lowest = float(skin_of(body, bones, rows)[:, 2].min()) if len(rows) else bones.joint["toe.L"].z
    height = bones.joint["foot.L"].z - lowest
    bones.reset()
    return height


def skin_of(body: RiggedBody, bones: Skeleton, rows: NDArray[np.intp] | slice = slice(None)) -> Floats:
    """Return the skin in the skeleton's pose, (V, 3) metres in armature space, linearly blended.

    Args:
        body: Resting skin and its weights.
        bones: Skeleton of this body, in the wanted pose.
        rows: Which vertices; all if not given.
    """
    move = np.zeros((len(bones.names), 3, 4))
    for index, name in enumerate(bones.names):
        orient = bones.orient[name]
        move[index, :, :3] = np.array(orient)
        move[index, :, 3] = bones.joint[name] - orient @ bones.head[name]
    blended = (body.weights[rows] @ move.reshape(len(move), 12)).reshape(-1, 3, 4)
    return (blended[:, :, :3] @ body.vertices[rows][:, :, None])[:, :, 0] + blended[:, :, 3]


def _toe_out(bones: Skeleton, side: str) -> float:
    """Return the yaw of a resting foot, radians."""
    along = bones.head[f"toe.{side}"] - bones.head[f"foot.{side}"]
    return facing_yaw(along)


def _sit_down(body: RiggedBody, bones: Skeleton) -> tuple[float, float, float]:
    """Return ``seat_drop``, ``seat_back`` and ``lap``, read from the skin with the legs posed as on a chair."""
    hip, k = bones.head["thigh.L"], bones.scale
    thigh = (bones.head["shin.L"] - hip).length
    shin = (bones.head["foot.L"] - bones.head["shin.L"]).length
    middle = (bones.head["thigh.L"] + bones.head["thigh.R"]) / 2
    bones.turn["hips"] = about("X", -8)
    bones.offset = middle + bones.turn["hips"] @ (bones.head["hips"] - middle) - bones.head["hips"]
    bones.update_all()
    for side in SIDES:
        ankle = Vector((sign(side) * 0.088 * k, hip.y - 0.98 * thigh, hip.z - shin))
        bones.reach(f"thigh.{side}", f"shin.{side}", f"foot.{side}", ankle, Vector((0, -1, 0)))
    bones.update_all()
    column = {name: index for index, name in enumerate(bones.names)}
    lower = np.flatnonzero(body.weights[:, [column[n] for n in ("hips", "thigh.L", "thigh.R", "shin.L")]].sum(1) > 0.5)
    skin, weights = skin_of(body, bones, lower), body.weights[lower]
    weight = weights[:, [column["hips"], column["thigh.L"], column["thigh.R"]]].sum(1)
    on_seat = (weight > 0.7) & (skin[:, 1] < hip.y + 0.12 * k) & (skin[:, 1] > hip.y - 0.7 * thigh)
    low = float(np.percentile(skin[on_seat][:, 2], 1)) if on_seat.any() else hip.z - SEATED * k
    behind = on_seat | (weight > 0.9)
    drop, back = hip.z - low + CLOTH, JACKET * k
    back += float(skin[behind][:, 1].max()) - hip.y if behind.any() else SEATED * k
    start, along = np.array(bones.joint["thigh.L"]), np.array(bones.joint["shin.L"] - bones.joint["thigh.L"])
    share = (skin - start) @ along / (along @ along)
    leg = weights[:, [column["thigh.L"], column["shin.L"]]].sum(1) > 0.6
    top = leg & (share > 0.5) & (share < 0.9)
    axis = start[2] + share[top] * along[2]
    lap = float((skin[top][:, 2] - axis).max()) if top.any() else 0.075 * k
    bones.reset()
    return drop, back, lap
