"""Sizes and pose of the template as one vector of numbers, and the body that they give. No bpy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from storyblender.blender.cast.template import Template
from storyblender.catalog.skeleton import SKELETON
from storyblender.geometry.solids import Floats

_HEAD = ("head", "jaw", "eye")
_TRUNK = ("hips", "spine", "chest", "upper_chest")
_HAND = ("hand", "thumb", "index1", "index2", "fingers1", "fingers2")
SIZES: tuple[str, ...] = (
    "whole", "head", "neck", "trunk_length", "trunk_width", "trunk_depth", "shoulders", "hips_width",
    "upper_arm", "forearm", "hand", "arm_girth", "thigh", "shin", "foot", "leg_girth",
)  # fmt: skip
"""Logarithms of how many times as large something is as the template's; both sides alike."""
TURNED: tuple[str, ...] = (
    "chest", "head",
    *(f"{bone}.{side}" for bone in ("upper_arm", "forearm", "hand", "thigh", "shin", "foot") for side in "LR"),
)  # fmt: skip
"""Bones that the pose turns, each by a rotation vector in radians, axes of the armature, in the parent's frame."""
PLACE = slice(0, 3)
SIZE_OF = {name: 3 + index for index, name in enumerate(SIZES)}
TURN_OF = {name: slice(3 + len(SIZES) + 3 * i, 6 + len(SIZES) + 3 * i) for i, name in enumerate(TURNED)}
COUNT = 3 + len(SIZES) + 3 * len(TURNED)


@dataclass(frozen=True, eq=False)
class Stance:
    """P bodies at once, B bones; x of the template's bone b becomes ``linear[b] x + shift[b]``.

    Attributes:
        heads: (P, B, 3) posed joints.
        turns: (P, B, 3, 3) rotation of each bone.
        linear: (P, B, 3, 3) rotation and scale.
        shift: (P, B, 3).
    """

    heads: Floats
    turns: Floats
    linear: Floats
    shift: Floats

    def points(self, rest: Floats, weights: Floats) -> Floats:
        """Return the (P, n, 3) places of points of the template (n, 3) with weights (n, B)."""
        count, bones = self.linear.shape[:2]
        places = (weights[:, :, None] * np.c_[rest, np.ones(len(rest))][:, None]).reshape(-1, 4 * bones)
        moves = np.concatenate([self.linear, self.shift[..., None]], 3)  # (P, B, 3, 4)
        moved = places @ moves.transpose(1, 3, 0, 2).reshape(4 * bones, 3 * count)
        return moved.reshape(-1, count, 3).transpose(1, 0, 2)


def stance_of(template: Template, values: Floats, *, posed: bool = True) -> Stance:
    """Return the bodies that rows of numbers (P, ``COUNT``) give.

    Args:
        template: The body they change.
        values: Place in metres, then ``SIZES``, then the turns of ``TURNED``.
        posed: Whether bones are turned; else the bodies stand as the template does.
    """
    count = len(values)
    scale = _scales(template, values)
    heads = np.zeros((count, len(SKELETON), 3))
    turns = np.zeros((count, len(SKELETON), 3, 3))
    for bone, entry in enumerate(SKELETON):
        parent = template.parents[bone]
        local = rotations(values[:, TURN_OF[entry.name]]) if posed and entry.name in TURN_OF else None
        if parent < 0:
            heads[:, bone] = template.heads[bone] * np.exp(values[:, SIZE_OF["whole"]])[:, None] + values[:, PLACE]
            turns[:, bone] = np.eye(3)
            continue
        offset = _offset(entry.name, template.heads[bone] - template.heads[parent], scale[:, parent], values)
        heads[:, bone] = heads[:, parent] + (turns[:, parent] @ offset[..., None])[..., 0]
        turns[:, bone] = turns[:, parent] if local is None else turns[:, parent] @ local
    linear = turns @ scale
    shift = heads - (linear @ template.heads[..., None])[..., 0]
    return Stance(heads, turns, linear, shift)


def _offset(name: str, rest: Floats, scale: Floats, values: Floats) -> Floats:
    """Return the (P, 3) vector from a parent's joint to a bone's, before the parent is turned."""
    offset = scale @ rest
    if name.startswith("thigh"):
        offset[:, 0] *= np.exp(values[:, SIZE_OF["hips_width"]])
    if name.startswith("upper_arm"):
        offset[:, 0] *= np.exp(values[:, SIZE_OF["shoulders"]])
    return offset


def _scales(template: Template, values: Floats) -> Floats:
    """Return the (P, B, 3, 3) scale of each bone in the frame of the template."""
    size: dict[str, Floats] = {name: np.exp(values[:, column]) for name, column in SIZE_OF.items()}
    whole = size["whole"]
    scale = np.zeros((len(values), len(SKELETON), 3, 3))
    for index, bone in enumerate(SKELETON):
        stem = bone.name.split(".")[0]
        if stem in _TRUNK or stem == "shoulder":
            sides = np.stack([size["trunk_width"], size["trunk_depth"], size["trunk_length"]], 1) * whole[:, None]
            scale[:, index] = sides[:, None] * np.eye(3)
        elif stem in _HEAD:
            scale[:, index] = (size["head"] * whole)[:, None, None] * np.eye(3)
        elif stem == "neck":
            girth: Floats = np.exp(values[:, SIZE_OF["head"]] / 2)
            scale[:, index] = _along(np.array((0, 0, 1.0)), size["neck"] * whole, girth * whole)
        elif stem in _HAND:
            scale[:, index] = (size["hand"] * whole)[:, None, None] * np.eye(3)
        elif stem in ("foot", "toe"):
            scale[:, index] = (size["foot"] * whole)[:, None, None] * np.eye(3)
        else:
            girth = size["arm_girth" if stem in ("upper_arm", "forearm") else "leg_girth"] * whole
            limb = template.tails[index] - template.heads[index]
            scale[:, index] = _along(limb / np.linalg.norm(limb), size[stem] * whole, girth)
    return scale


def _along(axis: Floats, length: Floats, girth: Floats) -> Floats:
    """Return the (P, 3, 3) scales by ``length`` along an axis and by ``girth`` across it."""
    return girth[:, None, None] * np.eye(3) + (length - girth)[:, None, None] * np.outer(axis, axis)


def rotations(vectors: Floats) -> Floats:
    """Return the (P, 3, 3) rotations of rotation vectors (P, 3) in radians."""
    angle = np.linalg.norm(vectors, axis=1)
    axis = vectors / np.maximum(angle, 1e-12)[:, None]
    cross = np.zeros((len(vectors), 3, 3))
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -axis[:, 2], axis[:, 1], -axis[:, 0]
    cross -= cross.transpose(0, 2, 1)
    sine, rest = np.sin(angle)[:, None, None], (1 - np.cos(angle))[:, None, None]
    return np.eye(3) + sine * cross + rest * (cross @ cross)
