"""Recorded motion that lies over what a person acts, bone by bone."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from mathutils import Matrix

from storyblender.blender.motion.skeleton import Skeleton


class Overlay(Protocol):
    """A recorded motion of trunk, neck and head."""

    def weight(self, t: float) -> float:
        """Return how much of it shows at ``t`` seconds, 0..1."""
        ...

    def turn(self, bone: str, t: float) -> Matrix:
        """Return the 3x3 turn of a bone at ``t`` seconds, about the armature's axes in the frame of its parent."""
        ...


def lay_over(bones: Skeleton, overlays: Sequence[Overlay], names: Sequence[str], t: float) -> None:
    """Lay what is recorded of bones over their turns; joints are not computed anew.

    Args:
        bones: As they are acted; changed.
        overlays: Later ones lie over earlier ones.
        names: Of the bones.
        t: Second of the shot.
    """
    for overlay in overlays:
        if (weight := overlay.weight(t)) > 0:
            for name in names:
                acted, recorded = bones.turn[name].to_quaternion(), overlay.turn(name, t).to_quaternion()
                bones.turn[name] = acted.slerp(recorded if acted.dot(recorded) >= 0 else -recorded, weight).to_matrix()
