"""What the bones of other programs are called: Mixamo, Unreal, VRM, Rigify, 3ds Max's Biped, and names like theirs."""

from __future__ import annotations

import re
from collections.abc import Sequence

SPINE = "spine"
"""Stands for every bone of the trunk above the hips; where it is tells which it is."""
_STEMS: dict[str, tuple[str, ...]] = {
    "hips": ("hips", "hip", "pelvis"),
    SPINE: (
        "spine",
        "chest",
        "upperchest",
        "torso",
        "abdomen",
        "abdomenlower",
        "abdomenupper",
        "chestlower",
        "chestupper",
    ),
    "neck": ("neck", "necklower", "neckupper"),
    "head": ("head",),
    "shoulder": ("shoulder", "clavicle", "collar"),
    "upper_arm": ("upperarm", "arm", "uparm", "shldr", "shldrbend"),
    "forearm": ("forearm", "lowerarm", "lowarm", "forearmbend", "elbow"),
    "hand": ("hand", "wrist"),
    "thigh": ("thigh", "upleg", "upperleg", "thighbend"),
    "shin": ("shin", "leg", "lowerleg", "calf", "knee", "lowleg"),
    "foot": ("foot", "ankle"),
    "toe": ("toe", "toebase", "ball", "toes"),
}
_SIDED = ("shoulder", "upper_arm", "forearm", "hand", "thigh", "shin", "foot", "toe")
_FINGER = re.compile("(thumb|index|middle|mid|ring|pinky|little)")

_PREFIX = re.compile(
    r"^(mixamorig\d*[:_]?|bip0*\d*[ _.-]?|valvebiped[._]?|def[-_ ]|org[-_ ]|cc_base_|j_bip_|b_|rig[:_]|armature[|_])",
    re.I,
)
_SIDE = re.compile(
    r"(?:^|[ ._:-])([Ll]eft|[Rr]ight|[LlRr])(?=[ ._:-]|$)"  # hand_l, L_Hand, Bip01 L Hand
    r"|([Ll]eft|[Rr]ight|LEFT|RIGHT)|^([lr])(?=[A-Z])|(?<=[a-z0-9])([LR])$"  # LeftHand, lHand, HandL
)
_COUNT = re.compile(r"[ ._-]*(\d+)(?:[ ._-]*(?:jnt|joint|bone))?$", re.I)
_ENDINGS = ("end", "nub", "twist", "roll", "ik", "pole", "target", "share", "helper")


def bones_named(names: Sequence[str]) -> dict[int, str]:
    """Return our bone for each joint whose name says which it is; those of the trunk above the hips are ``SPINE``.

    Of several with one name, such as a bone and its twist, the first counts.

    Args:
        names: Of the joints, parents before children or in any order.
    """
    found: dict[int, str] = {}
    taken: set[str] = set()
    for index, name in enumerate(names):
        bone = bone_named(name)
        if bone and (bone == SPINE or bone not in taken):
            found[index] = bone
            taken.add(bone)
    return found


def bone_named(name: str) -> str:
    """Return what a joint is called here, such as ``upper_arm.L``; empty where its name does not tell."""
    plain = name.strip()
    while (shorter := _PREFIX.sub("", plain)) != plain:
        plain = shorter
    plain = re.sub(r"^[cC]_", "", plain)
    side, plain = _side_of(plain)
    stem = _COUNT.sub("", plain)
    stem = re.sub(r"[ ._:-]", "", stem).lower()
    if any(stem.endswith(ending) for ending in _ENDINGS) and stem not in ("spine",):
        return ""
    digits = re.sub(r"[ ._:-]", "", plain).lower()
    if side and (finger := _FINGER.search(digits)) is not None:
        return _finger(finger.group(1), digits, side)
    for bone, stems in _STEMS.items():
        if stem in stems and (bone in _SIDED) == bool(side):
            return f"{bone}.{side}" if side else bone
    return ""


def _side_of(name: str) -> tuple[str, str]:
    """Return ``L``, ``R`` or nothing, and the name without it."""
    match = _SIDE.search(name)
    if match is None:
        return "", name
    said = next(group for group in match.groups() if group)
    return said[0].upper(), name[: match.start()] + name[match.end() :]


def _finger(kind: str, digits: str, side: str) -> str:
    """Return which part of a finger a joint is."""
    if kind == "thumb":
        return f"thumb.{side}"
    first = "proximal" in digits or (digits.rstrip("0123456789") != digits and digits[-1] in "01")
    first = first or not any(each in digits for each in ("intermediate", "distal", "2", "3"))
    if "metacarpal" in digits:
        return ""
    return f"{'index' if kind == 'index' else 'fingers'}{1 if first else 2}.{side}"
