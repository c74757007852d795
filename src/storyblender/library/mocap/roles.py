"""Which joint of a motion clip is which bone of ours: by the names that programs give, else by the tree's shape."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final

from storyblender.catalog.joint_names import JointName, limbs_named, read_joint_name
from storyblender.errors import InputError
from storyblender.library.mocap.source_motion import SourceMotion
from storyblender.library.mocap.tree_shape import limbs_by_shape

CHAINS: Final = (("thigh", "shin", "foot", "toe"), ("shoulder", "upper_arm", "forearm", "hand"))
_FINGERS: Final = ("index", "thumb", "fingers")


@dataclass(frozen=True)
class Roles:
    """Joints of a skeleton by what they are, as indices.

    Attributes:
        limbs: By bone of ours, such as ``thigh.L``; all of ``needed`` are there.
        hips: The joint that carries legs and trunk.
        spine: Joints from above the hips to the one that carries the arms.
        neck: Joints between that and the head.
        head: None where there is none.
        fingers: First joints of fingers by bone of ours, such as ``index.L``.
        by_names: Whether names said so, and not the shape.
    """

    limbs: dict[str, int]
    hips: int
    spine: tuple[int, ...]
    neck: tuple[int, ...]
    head: int | None
    fingers: dict[str, tuple[int, ...]] = field(default_factory=dict)
    by_names: bool = True


def find_roles(motion: SourceMotion) -> Roles:
    """Return which joint is which bone.

    Args:
        motion: The skeleton.

    Raises:
        InputError: It is not that of a person.
    """
    called = [read_joint_name(name) for name in motion.names]
    limbs = _limbs_by_name(motion, called)
    by_names = limbs is not None
    if limbs is None:
        limbs = limbs_by_shape(motion)
    if limbs is None:
        raise InputError("it has no skeleton of a person with two arms and two legs")
    legs = [motion.chain(limbs[f"thigh.{side}"])[1:] for side in "LR"]
    arms = [motion.chain(limbs.get(f"shoulder.{side}", limbs[f"upper_arm.{side}"]))[1:] for side in "LR"]
    hips, chest = _shared(legs), _shared(arms)
    if hips is None or chest is None:
        raise InputError("its legs, or its arms, are not on one body")
    up = motion.chain(chest)
    base = next((joint for joint in up if joint in motion.chain(hips)), hips)
    spine = tuple(reversed([joint for joint in up[: up.index(base)] if joint != hips] if base in up else []))
    head, neck = _head_and_neck(motion, called, chest, limbs)
    fingers = {
        f"{name}.{side}": tuple(
            first
            for first in motion.children(limbs[f"hand.{side}"])
            if called[first].finger == name and motion.children(first)
        )
        for side in "LR"
        for name in _FINGERS
    }
    return Roles(limbs, hips, spine, neck, head, {name: found for name, found in fingers.items() if found}, by_names)


def _limbs_by_name(motion: SourceMotion, called: Sequence[JointName]) -> dict[str, int] | None:
    """Return the joints of the limbs by bone; None where names do not say them."""
    found = limbs_named(called, motion.parents)
    return found if all(_is_chain(motion, found, side) for side in "LR") else None


def _is_chain(motion: SourceMotion, found: dict[str, int], side: str) -> bool:
    """Return whether the joints of the limbs of a side are there, each below the one before."""
    for chain in CHAINS:
        names = [f"{bone}.{side}" for bone in chain]
        there = [found[name] for name in names if name in found]
        if any(name not in found for name in names if not name.startswith(("toe", "shoulder"))):
            return False
        if any(above not in motion.chain(below)[1:] for above, below in pairwise(there)):
            return False
    return True


def _shared(chains: Sequence[list[int]]) -> int | None:
    """Return the lowest joint that two chains share."""
    return next((joint for joint in chains[0] if joint in chains[1]), None)


def _head_and_neck(
    motion: SourceMotion, called: Sequence[JointName], chest: int, limbs: dict[str, int]
) -> tuple[int | None, tuple[int, ...]]:
    """Return the head, and the joints between it and the chest: by name, else the longest chain that is no arm."""
    below = [joint for joint in range(len(motion.names)) if chest in motion.chain(joint)[1:]]
    named = [joint for joint in below if called[joint].trunk == "head"]
    if named:
        head = min(named, key=lambda joint: len(motion.chain(joint)))
    else:
        arms = {*limbs.values()}
        free = [joint for joint in below if not arms & {*motion.chain(joint), *_under(motion, joint)}]
        ends = [joint for joint in free if motion.children(joint)] or free
        if not ends:
            return None, ()
        head = max(ends, key=lambda joint: len(motion.chain(joint)))
    up = motion.chain(head)
    return head, tuple(reversed(up[1 : up.index(chest)]))


def _under(motion: SourceMotion, joint: int) -> Iterator[int]:
    """Yield all joints below one."""
    return (each for each in range(len(motion.names)) if joint in motion.chain(each)[1:])
