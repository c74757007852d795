"""The skeleton that a file has of its own, read as ours: better than what its shape lets one guess. No bpy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from storyblender.blender.models.plain import PlainRig
from storyblender.catalog.joint_names import SPINE, bones_named
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.geometry.solids import Floats

NEEDED = (
    "hips",
    "head",
    *(f"{bone}.{side}" for bone in ("upper_arm", "forearm", "thigh", "shin", "foot") for side in "LR"),
)
"""Bones that a rig must have to be used."""


@dataclass(frozen=True, eq=False)
class OwnRig:
    """A file's skeleton by our names.

    Attributes:
        heads: Where joints are, in the frame and unit of the points, by our bone.
        weights: (V, B) columns as in ``SKELETON``; rows of vertices that nothing moves are 0.
    """

    heads: dict[str, Floats]
    weights: Floats

    @property
    def faces_away(self) -> bool:
        """Whether its left is on the right, so that it faces +Y."""
        return float((self.heads["thigh.L"] - self.heads["thigh.R"])[0]) < 0


def own_rig(rig: PlainRig, rows: np.ndarray) -> OwnRig | None:
    """Return a file's skeleton by our names; None where too few of its bones are known by name.

    Args:
        rig: As it was read.
        rows: (V,) row of the rig for each vertex of the mesh.
    """
    named = _with_trunk(bones_named(rig.names, rig.parents), rig)
    heads = {bone: rig.heads[joint].astype(float) for joint, bone in reversed(named.items())}
    if any(bone not in heads for bone in NEEDED):
        return None
    bone_of = _bones_of_joints(rig, named)
    weights = np.zeros((len(rows), len(SKELETON)))
    joints, shares = rig.joints[rows], rig.weights[rows]
    for slot in range(joints.shape[1]):
        bones = np.where(joints[:, slot] >= 0, bone_of[joints[:, slot]], -1)
        known = np.flatnonzero(bones >= 0)
        np.add.at(weights, (known, bones[known]), shares[known, slot])
    total = weights.sum(1, keepdims=True)
    return OwnRig(heads, np.where(total > 0.2, weights / np.maximum(total, 1e-9), 0))


def _with_trunk(named: dict[int, str], rig: PlainRig) -> dict[int, str]:
    """Return the names with our bones for those of the trunk, from below: the first, those between and the last.

    A trunk that goes from the hips to the head, as Rigify's does, has those too.
    """
    trunk = [joint for joint, bone in named.items() if bone == SPINE]
    trunk.sort(key=lambda joint: float(rig.heads[joint][2]))
    ends: dict[int, str] = {}
    if len(trunk) > 3 and "hips" not in named.values():
        ends[trunk.pop(0)] = "hips"
    if len(trunk) > 3 and "head" not in named.values():
        ends[trunk.pop()] = "head"
        ends |= {} if "neck" in named.values() else {trunk.pop(): "neck"}
    for place, joint in enumerate(trunk):
        ends[joint] = "spine" if place == 0 else "upper_chest" if place == len(trunk) - 1 else "chest"
    return named | ends


def _bones_of_joints(rig: PlainRig, named: dict[int, str]) -> np.ndarray:
    """Return our bone (J,) for each joint: that of the nearest joint above it whose name is known, -1 for none."""
    result = np.full(len(rig.names), -1)
    for joint in range(len(rig.names)):
        at = joint
        for _ in rig.names:
            if at < 0 or at in named:
                break
            at = rig.parents[at]
        result[joint] = BONE_INDEX[named[at]] if at >= 0 and at in named else -1
    return result
