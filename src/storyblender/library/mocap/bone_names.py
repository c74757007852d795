"""Which joint of a skeleton is which bone of ours: by the names that programs give them, else by the tree's shape.

Known are the names of Mixamo, of the CMU library and other BVH files, MotionBuilder, Rokoko, Xsens, Unreal, 3ds Max,
DAZ and Poser, VRM, and Blender's Rigify.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final

from storyblender.errors import InputError
from storyblender.library.mocap.source_motion import SourceMotion
from storyblender.library.mocap.tree_shape import limbs_by_shape

LIMBS: Final[dict[str, tuple[tuple[str, ...], tuple[str, ...]]]] = {
    "thigh": (("upleg", "upperleg", "thigh", "femur", "legupper"), ("hip",)),
    "shin": (("leg", "lowerleg", "lowleg", "shin", "calf", "tibia", "knee", "leglower"), ()),
    "foot": (("foot", "ankle"), ()),
    "toe": (("toe", "toes", "toebase", "ball", "toejoint"), ()),
    "shoulder": (("clavicle", "collar", "clav", "collarbone"), ("shoulder",)),
    "upper_arm": (("upperarm", "uparm", "arm", "humerus", "shldr", "armupper"), ("shoulder",)),
    "forearm": (("forearm", "lowerarm", "lowarm", "elbow", "radius", "armlower"), ("ulna",)),
    "hand": (("hand", "wrist", "palm"), ()),
}
"""Names of each bone of a limb, without side and number; the second ones count where none of the first is there."""
CHAINS: Final = (("thigh", "shin", "foot", "toe"), ("shoulder", "upper_arm", "forearm", "hand"))
FINGERS: Final = {
    "index": ("index", "handindex", "findex"), "thumb": ("thumb", "handthumb", "fthumb"),
    "fingers": ("middle", "handmiddle", "fmiddle", "mid", "ring", "handring", "fring"),
}  # fmt: skip
_LEFT, _RIGHT = frozenset(("left", "l", "lft")), frozenset(("right", "r", "rgt"))
_ODD: Final = frozenset(
    ("twist", "roll", "ik", "fk", "pole", "target", "ctrl", "control", "mch", "tweak", "helper", "effector",
     "adjust", "share", "corrective", "vis")
)  # fmt: skip
_PREFIXES: Final = re.compile(r"^(mixamorig\d*|bip\d*|valvebiped|def|org|jnt|joint|j|cc|b|rig|skel|sk|bone|c|base)$")
_PARTS: Final = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|\d+")


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


@dataclass(frozen=True)
class _Called:
    stem: str
    side: str
    number: int


def find_roles(motion: SourceMotion) -> Roles:
    """Return which joint is which bone.

    Args:
        motion: The skeleton.

    Raises:
        InputError: It is not that of a person.
    """
    called = [_called(name) for name in motion.names]
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
            if _called(motion.names[first]).stem in words and motion.children(first)
        )
        for side in "LR"
        for name, words in FINGERS.items()
    }
    return Roles(limbs, hips, spine, neck, head, {name: found for name, found in fingers.items() if found}, by_names)


def _called(name: str) -> _Called:
    """Return what a name says: ``mixamorig:LeftUpLeg`` is the left ``upleg``, ``index_01_l`` the left ``index``, 1."""
    last = re.split(r"[:|]", name)[-1]
    parts = [part.lower() for part in _PARTS.findall(last)]
    if any(part in _ODD for part in parts):
        return _Called("", "", 0)
    number = int(next((part for part in reversed(parts) if part.isdigit()), "0")[:4])
    words = [part for part in parts if not part.isdigit() and part != "bend"]
    while len(words) > 1 and _PREFIXES.match(words[0]):
        words = words[1:]
    side = "L" if _LEFT & {*words} else "R" if _RIGHT & {*words} else ""
    stem = "".join(word for word in words if word not in _LEFT | _RIGHT)
    if side:
        return _Called(stem, side, number)
    for start, letter in (("left", "L"), ("right", "R"), ("l", "L"), ("r", "R")):
        rest = stem.removeprefix(start)
        if rest != stem and rest in _KNOWN:
            return _Called(rest, letter, number)
    return _Called(stem, "", number)


_KNOWN: Final = frozenset(word for sets in LIMBS.values() for words in sets for word in words) | {"hipjoint"}


def _limbs_by_name(motion: SourceMotion, called: Sequence[_Called]) -> dict[str, int] | None:
    """Return the joints of the limbs by bone; None where names do not say them."""
    depth = [len(motion.chain(joint)) for joint in range(len(motion.names))]
    found: dict[str, int] = {}
    for side in "LR":
        for bone, choices in LIMBS.items():
            for words in choices:
                fitting = [
                    joint
                    for joint, each in enumerate(called)
                    if each.side == side and each.stem in words and joint not in found.values()
                ]
                if fitting:
                    found[f"{bone}.{side}"] = min(fitting, key=lambda joint: (depth[joint], joint))
                    break
        if f"upper_arm.{side}" not in found and f"shoulder.{side}" in found:  # a shoulder that is the arm's joint
            found[f"upper_arm.{side}"] = found.pop(f"shoulder.{side}")
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
    motion: SourceMotion, called: Sequence[_Called], chest: int, limbs: dict[str, int]
) -> tuple[int | None, tuple[int, ...]]:
    """Return the head, and the joints between it and the chest: by name, else the longest chain that is no arm."""
    below = [joint for joint in range(len(motion.names)) if chest in motion.chain(joint)[1:]]
    named = [joint for joint in below if called[joint].stem in ("head", "skull") and not called[joint].side]
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
