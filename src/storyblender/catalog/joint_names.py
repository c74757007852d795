"""What joints are called in other programs, as bones of ours.

Known are the names of Mixamo and Meshy, of the CMU library and other BVH and ASF files, MotionBuilder, Rokoko, Xsens,
Unreal, Source, 3ds Max's Biped, Character Creator, DAZ and Poser, VRM, SMPL, MakeHuman, and Blender's Rigify.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

SPINE: Final = "spine"
"""Stands for every bone of the trunk above the hips; where it is tells which it is."""
_LIMBS: Final[dict[str, tuple[tuple[str, ...], tuple[str, ...]]]] = {
    "thigh": (("upleg", "upperleg", "thigh", "femur", "legupper"), ("hip",)),
    "shin": (("leg", "lowerleg", "lowleg", "shin", "calf", "tibia", "knee", "leglower"), ()),
    "foot": (("foot", "ankle"), ()),
    "toe": (("toe", "toes", "toebase", "ball"), ()),
    "shoulder": (("clavicle", "collar", "clav", "collarbone"), ("shoulder",)),
    "upper_arm": (("upperarm", "uparm", "arm", "humerus", "shldr", "armupper"), ("shoulder",)),
    "forearm": (("forearm", "lowerarm", "lowarm", "elbow", "radius", "armlower"), ("ulna",)),
    "hand": (("hand", "wrist", "palm"), ()),
}
"""Names of each bone of a limb, without side and number; the second ones count where none of the first is there."""
_TRUNK: Final = {
    "hips": ("hips", "hip", "pelvis"),
    SPINE: ("spine", "chest", "upperchest", "torso", "thorax", "waist", "lowerback", "upperback", "abdomen",
            "abdomenlower", "abdomenupper", "chestlower", "chestupper"),
    "neck": ("neck", "necklower", "neckupper", "lowerneck", "upperneck"),
    "head": ("head", "skull"),
}  # fmt: skip
_VERTEBRAE: Final = frozenset(("l5", "l3", "t12", "t8"))
"""What Xsens calls the trunk: an L that is no side."""
_FINGER: Final = re.compile(
    "(?:hand|f)?(thumb|index|middle|mid|ring|pinky|little|finger)(?:finger)?(proximal|intermediate|distal)?"
)
_LEFT, _RIGHT = frozenset(("left", "l", "lft")), frozenset(("right", "r", "rgt"))
_ODD: Final = frozenset(
    ("twist", "roll", "ik", "fk", "pole", "target", "ctrl", "control", "mch", "tweak", "helper", "effector",
     "adjust", "share", "corrective", "vis", "end", "nub", "metacarpal")
)  # fmt: skip
_PREFIXES: Final = re.compile(
    r"mixamorig|bip|valve|biped|character|armature|def|org|jnt|joint|j|cc|b|rig|skel|sk|bone|c|base"
)
_SUFFIXES: Final = frozenset(("jnt", "joint", "bone"))
_SIDED: Final = frozenset(word for sets in _LIMBS.values() for words in sets for word in words)
_PARTS: Final = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|\d+")


@dataclass(frozen=True)
class JointName:
    """What the name of a joint says: ``mixamorig:LeftUpLeg`` is the left ``upleg``.

    Attributes:
        stem: In small letters, without prefix, side and numbers; empty for helpers, such as twists and ends.
        side: ``L``, ``R`` or nothing.
        numbers: As they are written.
    """

    stem: str
    side: str = ""
    numbers: tuple[str, ...] = ()

    @property
    def trunk(self) -> str:
        """``hips``, ``SPINE``, ``neck`` or ``head``; empty for others."""
        return "" if self.side else next((bone for bone, stems in _TRUNK.items() if self.stem in stems), "")

    @property
    def finger(self) -> str:
        """``thumb``, ``index`` or ``fingers``; empty for others."""
        kind = match[1] if (match := _FINGER.fullmatch(self.stem)) else ""
        if kind != "finger":
            return kind if kind in ("", "thumb", "index") else "fingers"
        if not self.numbers:
            return ""
        from_thumb = int(self.numbers[0][0]) - (len(self.numbers) > 1)  # Biped's Finger0, MakeHuman's finger1-1
        return ("thumb", "index")[from_thumb] if 0 <= from_thumb < 2 else "fingers"

    @property
    def finger_bone(self) -> str:
        """Our bone of a finger, such as ``index2.L``; empty for others."""
        kind = self.finger
        if not kind or not self.side or kind == "thumb":
            return kind and self.side and f"{kind}.{self.side}"
        if self.stem == "finger":  # Biped's Finger1 and Finger11, MakeHuman's finger2-1 and finger2-2
            first = len(self.numbers[0]) == 1 if len(self.numbers) == 1 else int(self.numbers[1]) < 2
        else:
            first = int((*self.numbers, "1")[0]) < 2 and not self.stem.endswith(("intermediate", "distal"))
        return f"{kind}{1 if first else 2}.{self.side}"


def read_joint_name(name: str) -> JointName:
    """Return what the name of a joint says."""
    parts = [part.lower() for part in _PARTS.findall(re.split(r"[:|]", name)[-1])]
    if "".join(parts) in _VERTEBRAE:
        return JointName(SPINE)
    while len(parts) > 1 and (parts[0].isdigit() or _PREFIXES.fullmatch(parts[0])):
        parts = parts[1:]
    while len(parts) > 1 and parts[-1] in _SUFFIXES:
        parts = parts[:-1]
    if _ODD & {*parts}:
        return JointName("")
    numbers = tuple(part for part in parts if part.isdigit())
    words = [part for part in parts if not part.isdigit() and part != "bend"]
    side = "L" if _LEFT & {*words} else "R" if _RIGHT & {*words} else ""
    stem = "".join(word for word in words if word not in _LEFT | _RIGHT)
    for start, letter in () if side else (("left", "L"), ("right", "R"), ("l", "L"), ("r", "R")):
        rest = stem.removeprefix(start)
        if rest != stem and (rest in _SIDED or _FINGER.fullmatch(rest)):
            return JointName(rest, letter, numbers)
    return JointName(stem, side, numbers)


def limbs_named(names: Sequence[JointName], parents: Sequence[int]) -> dict[str, int]:
    """Return the joints of the limbs by our bone, such as ``thigh.L``, as far as the names say them.

    Of several with one name, such as a bone and its twist, the highest in the tree counts.

    Args:
        names: Of the joints.
        parents: The joint above each, -1 for none.
    """
    depths = [_depth(joint, parents) for joint in range(len(names))]
    found: dict[str, int] = {}
    for side in "LR":
        for bone, choices in _LIMBS.items():
            for words in choices:
                fitting = [
                    joint
                    for joint, name in enumerate(names)
                    if name.side == side and name.stem in words and joint not in found.values()
                ]
                if fitting:
                    found[f"{bone}.{side}"] = min(fitting, key=lambda joint: (depths[joint], joint))
                    break
        if f"upper_arm.{side}" not in found and f"shoulder.{side}" in found:  # a shoulder that is the arm's joint
            found[f"upper_arm.{side}"] = found.pop(f"shoulder.{side}")
    return found


def bones_named(names: Sequence[str], parents: Sequence[int]) -> dict[int, str]:
    """Return our bone for each joint whose name says which it is; those of the trunk above the hips are ``SPINE``.

    Args:
        names: Of the joints.
        parents: The joint above each, -1 for none.
    """
    read = [read_joint_name(name) for name in names]
    found = {joint: bone for bone, joint in limbs_named(read, parents).items()}
    taken: set[str] = set()
    for joint in sorted(range(len(names)), key=lambda joint: (_depth(joint, parents), joint)):
        bone = read[joint].trunk or read[joint].finger_bone
        if bone and bone not in taken:
            found[joint] = bone
            taken |= {bone} - {SPINE}
    return found


def _depth(joint: int, parents: Sequence[int]) -> int:
    """Return how many joints are above one; a file whose joints go round in a ring has no more than all."""
    for depth in range(len(parents)):
        if (joint := parents[joint]) < 0:
            return depth
    return len(parents)
