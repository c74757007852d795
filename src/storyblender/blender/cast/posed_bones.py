"""Our bones as they stand in a user's mesh, and how they stand at rest. No bpy."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.geometry.solids import Floats

ARM = ("upper_arm", "forearm", "hand", "thumb", "index1", "index2", "fingers1", "fingers2")
"""Bones that are brought to the template's pose."""


@dataclass(frozen=True, eq=False)
class PosedBones:
    """B bones in the pose of the file, metres.

    Attributes:
        heads: (B, 3).
        tails: (B, 3).
        turns: (B, 3, 3) from how the template has them.
    """

    heads: Floats
    tails: Floats
    turns: Floats

    def moved_to(self, places: Mapping[str, Floats]) -> PosedBones:
        """Return the bones with joints at the places that a file's own skeleton has for them.

        What hangs on a joint goes along; arms turn to where they then point.
        """
        heads, tails, turns = self.heads.copy(), self.tails.copy(), self.turns.copy()
        for index, bone in enumerate(SKELETON):
            parent = BONE_INDEX[bone.parent] if bone.parent else None
            moved = heads[parent] - self.heads[parent] if parent is not None else np.zeros(3)
            heads[index] = places.get(bone.name, self.heads[index] + moved)
            tails[index] = self.tails[index] + heads[index] - self.heads[index]
        for upper, lower in _CHAINS:
            tails[BONE_INDEX[upper]] = heads[BONE_INDEX[lower]]
        for index, bone in enumerate(SKELETON):
            if bone.name.split(".")[0] in ("upper_arm", "forearm"):
                before, now = self.tails[index] - self.heads[index], tails[index] - heads[index]
                turns[index] = _swing(before, now) @ turns[index]
        return PosedBones(heads, tails, turns)

    def at_rest(self) -> tuple[Floats, Floats, Floats]:
        """Return the turns (B, 3, 3) from rest to this pose, and the heads and tails (B, 3) at rest."""
        turns, heads, tails = np.tile(np.eye(3), (len(SKELETON), 1, 1)), self.heads.copy(), self.tails.copy()
        for index, bone in enumerate(SKELETON):
            stem, _, side = bone.name.partition(".")
            if stem in ARM:
                parent = BONE_INDEX[bone.parent]
                turns[index] = self.turns[index] @ self.turns[BONE_INDEX[f"shoulder.{side}"]].T
                heads[index] = heads[parent] + turns[parent].T @ (self.heads[index] - self.heads[parent])
                tails[index] = heads[index] + turns[index].T @ (self.tails[index] - self.heads[index])
        return turns, heads, tails


_CHAINS = tuple(
    (f"{upper}.{side}", f"{lower}.{side}")
    for upper, lower in (
        ("shoulder", "upper_arm"), ("upper_arm", "forearm"), ("forearm", "hand"), ("index1", "index2"),
        ("fingers1", "fingers2"), ("thigh", "shin"), ("shin", "foot"), ("foot", "toe"),
    )
    for side in "LR"
)  # fmt: skip
"""Bones that end where another begins."""


def _swing(start: Floats, end: Floats) -> Floats:
    """Return the shortest rotation (3, 3) from one direction to another."""
    a, b = start / np.linalg.norm(start), end / np.linalg.norm(end)
    cross, cosine = np.cross(a, b), float(a @ b)
    if cosine < -0.999:
        return np.eye(3)
    x, y, z = cross
    skew = np.array(((0, -z, y), (z, 0, -x), (-y, x, 0)))
    return np.eye(3) + skew + skew @ skew / (1 + cosine)
