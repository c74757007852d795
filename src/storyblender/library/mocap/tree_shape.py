"""The limbs of a skeleton without names, by its shape: the two pairs of chains that mirror each other."""

from __future__ import annotations

from itertools import combinations
from typing import Final

import numpy as np

from storyblender.geometry.solids import Floats
from storyblender.library.mocap.source_motion import SourceMotion

_ALIKE: Final = 0.03
"""Difference in length, as a share, of two limbs of one person."""
_LEG, _ARM = ("thigh", "shin", "foot", "toe"), ("upper_arm", "forearm", "hand")


def limbs_by_shape(motion: SourceMotion) -> dict[str, int] | None:
    """Return the joints of the limbs by bone of ours; None where the tree is not that of a person.

    Args:
        motion: At rest upright, so that arms are above legs.
    """
    pairs = [
        (joint, one, other)
        for joint in range(len(motion.names))
        for one, other in combinations(motion.children(joint), 2)
        if _is_pair(motion, one, other)
    ]
    pairs.sort(key=lambda each: (len(motion.chain(each[0])), -_reach(motion, each[1])))
    legs = next(iter(pairs), None)
    if legs is None:
        return None
    arms = next((pair for pair in pairs if pair[0] != legs[0] and legs[1] not in motion.chain(pair[0])), None)
    arms = arms or next((pair for pair in pairs[1:] if not {*pair[1:]} & {*legs[1:]}), None)
    if arms is None:
        return None
    up = motion.rest[arms[0]] - motion.rest[legs[0]]
    up = up if np.linalg.norm(up) > 0 else motion.rest[legs[0]] - motion.rest[_line(motion, legs[1])[2]]
    left = _left(motion, legs, up)
    found: dict[str, int] = {}
    for pair, bones in ((legs, _LEG), (arms, _ARM)):
        for root in pair[1:]:
            across = float((motion.rest[_line(motion, root)[1]] - motion.rest[pair[0]]) @ left)
            side = "L" if across > 0 else "R"
            line = _line(motion, root)
            if bones is _ARM and len(line) > len(_ARM):  # the first joint of a longer arm is the collar bone
                found[f"shoulder.{side}"], line = line[0], line[1:]
            found |= {f"{bone}.{side}": joint for bone, joint in zip(bones, line, strict=False)}
    needed = {f"{bone}.{side}" for bone in (*_LEG[:3], *_ARM) for side in "LR"}
    return found if needed <= {*found} else None


def _line(motion: SourceMotion, joint: int) -> list[int]:
    """Return the joints of a limb: from one down to where it ends or branches into fingers, without the end."""
    line = [joint]
    while len(below := motion.children(line[-1])) == 1 and motion.children(below[0]):
        line.append(below[0])
    if len(below) > 1:  # a hand with fingers, a foot with toes
        return line
    return [*line, below[0]] if len(line) < 3 and below else line


def _lengths(motion: SourceMotion, line: list[int]) -> Floats:
    return np.linalg.norm(np.diff(motion.rest[line], axis=0), axis=1)


def _is_pair(motion: SourceMotion, one: int, other: int) -> bool:
    first, second = _line(motion, one), _line(motion, other)
    if len(first) != len(second) or len(first) < 3:
        return False
    a, b = _lengths(motion, first), _lengths(motion, second)
    return bool(np.abs(a - b).max() <= _ALIKE * max(a.sum(), b.sum(), 1e-9) and a.sum() > 0)


def _reach(motion: SourceMotion, joint: int) -> float:
    return float(_lengths(motion, _line(motion, joint)).sum())


def _left(motion: SourceMotion, legs: tuple[int, int, int], up: Floats) -> Floats:
    """Return the direction to the person's left: feet point ahead of the ankles."""
    up = up / max(float(np.linalg.norm(up)), 1e-9)
    ahead = np.zeros(3)
    for root in legs[1:]:
        line = _line(motion, root)
        toe = line[3] if len(line) > 3 else next(iter(motion.children(line[2])), line[2])
        ahead += motion.rest[toe] - motion.rest[line[2]]
    return np.cross(up, ahead)
