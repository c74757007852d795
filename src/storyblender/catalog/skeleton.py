"""The 35 bones of a person: names, hierarchy and which MakeHuman joints they span. Pure data.

The same names drive the body pack (which merges 163 MakeHuman bones into these), the rig and the motion solver.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Bone:
    """One bone of the reduced rig.

    Attributes:
        name: As in the armature; left and right end in ``.L`` and ``.R``.
        parent: Name of the parent bone, empty for the root.
        head: Joint of the body pack where it starts.
        tail: Joint where it ends.
        absorbs: MakeHuman bones merged into it, together with all their descendants that no other bone claims.
    """

    name: str
    parent: str
    head: str
    tail: str
    absorbs: tuple[str, ...]


def _limbs(side: str) -> tuple[Bone, ...]:
    """Return the bones of one side, ``L`` or ``R``: eye, arm with hand, leg with foot."""
    joint = side.lower()
    s = f".{side}"

    def bone(name: str, parent: str, head: str, tail: str, *absorbs: str) -> Bone:
        return Bone(name + s, parent, f"{joint}-{head}", f"{joint}-{tail}", tuple(old + s for old in absorbs))

    outer = (3, 4, 5)
    return (
        bone("eye", "head", "eye", "eye-target", "eye"),
        bone("shoulder", "upper_chest", "clavicle", "shoulder", "clavicle"),
        bone("upper_arm", "shoulder" + s, "shoulder", "elbow", "upperarm01"),
        bone("forearm", "upper_arm" + s, "elbow", "hand", "lowerarm01"),
        bone("hand", "forearm" + s, "hand", "finger-3-1", "wrist"),
        bone("thumb", "hand" + s, "finger-1-1", "finger-1-4", "finger1-1"),
        bone("index1", "hand" + s, "finger-2-1", "finger-2-2", "finger2-1"),
        bone("index2", "index1" + s, "finger-2-2", "finger-2-4", "finger2-2"),
        bone("fingers1", "hand" + s, "finger-4-1", "finger-4-2", *(f"finger{n}-1" for n in outer)),
        bone("fingers2", "fingers1" + s, "finger-4-2", "finger-4-4", *(f"finger{n}-2" for n in outer)),
        bone("thigh", "hips", "upper-leg", "knee", "upperleg01"),
        bone("shin", "thigh" + s, "knee", "ankle", "lowerleg01"),
        bone("foot", "shin" + s, "ankle", "toe-3-1", "foot"),
        bone("toe", "foot" + s, "toe-3-1", "toe-3-4", *(f"toe{n}-1" for n in range(1, 6))),
    )


SKELETON: tuple[Bone, ...] = (
    Bone("hips", "", "pelvis", "spine-3", ("root",)),
    Bone("spine", "hips", "spine-3", "spine-2", ("spine04",)),
    Bone("chest", "spine", "spine-2", "spine-1", ("spine03", "spine02")),
    Bone("upper_chest", "chest", "spine-1", "neck", ("spine01", "breast.L", "breast.R")),
    Bone("neck", "upper_chest", "neck", "head", ("neck01",)),
    Bone("head", "neck", "head", "head-2", ("head",)),
    Bone("jaw", "head", "mouth", "jaw", ("jaw",)),
    *_limbs("L"),
    *_limbs("R"),
)
"""Parents come before their children."""

BONE_INDEX: dict[str, int] = {bone.name: index for index, bone in enumerate(SKELETON)}
"""Column of each bone in the weights of the body pack."""


def columns(*stems: str, side: str = "LR") -> list[int]:
    """Return the weight columns of bones by name, a sided bone once for every letter of ``side``."""
    names = [name for stem in stems for name in ([stem] if stem in BONE_INDEX else [f"{stem}.{s}" for s in side])]
    return [BONE_INDEX[name] for name in names]
