"""Motion clips made by the tests: BVH files of any convention from the joints of a person who moves."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from storyblender.geometry.rotations import about_axis, axes_along, shortest_arc
from storyblender.geometry.solids import Floats

PLAIN = {
    "hips": "Hips", "spine": "Spine", "chest": "Spine1", "upper_chest": "Spine2", "neck": "Neck", "head": "Head",
    "shoulder": "{}Shoulder", "upper_arm": "{}Arm", "forearm": "{}ForeArm", "hand": "{}Hand",
    "thigh": "{}UpLeg", "shin": "{}Leg", "foot": "{}Foot", "toe": "{}ToeBase",
    "index1": "{}HandIndex1", "fingers1": "{}HandMiddle1", "thumb": "{}HandThumb1",
}  # fmt: skip
"""As Mixamo, Rokoko and MotionBuilder call joints."""
CONVENTIONS: Mapping[str, Mapping[str, str]] = {
    "mixamo": {bone: f"mixamorig:{name}" for bone, name in PLAIN.items()},
    "classic": {
        "hips": "Hips", "spine": "Chest", "chest": "Chest2", "upper_chest": "Chest3", "neck": "Neck", "head": "Head",
        "shoulder": "{}Collar", "upper_arm": "{}Shoulder", "forearm": "{}Elbow", "hand": "{}Wrist",
        "thigh": "{}Hip", "shin": "{}Knee", "foot": "{}Ankle", "toe": "{}Toe",
    },
    "unreal": {
        "hips": "pelvis", "spine": "spine_01", "chest": "spine_02", "upper_chest": "spine_03", "neck": "neck_01",
        "head": "head", "shoulder": "clavicle_{}", "upper_arm": "upperarm_{}", "forearm": "lowerarm_{}",
        "hand": "hand_{}", "index1": "index_01_{}", "fingers1": "middle_01_{}", "thumb": "thumb_01_{}",
        "thigh": "thigh_{}", "shin": "calf_{}", "foot": "foot_{}", "toe": "ball_{}",
    },
    "rigify": {
        "hips": "DEF-spine", "spine": "DEF-spine.001", "chest": "DEF-spine.002", "upper_chest": "DEF-spine.003",
        "neck": "DEF-spine.004", "head": "DEF-spine.006",
        **{bone: f"DEF-{bone}.{{}}" for bone in ("shoulder", "upper_arm", "forearm", "hand", "thigh", "shin", "foot")},
        "toe": "DEF-toe.{}",
    },
    "vrm": {
        "hips": "J_Bip_C_Hips", "spine": "J_Bip_C_Spine", "chest": "J_Bip_C_Chest",
        "upper_chest": "J_Bip_C_UpperChest", "neck": "J_Bip_C_Neck", "head": "J_Bip_C_Head",
        "shoulder": "J_Bip_{}_Shoulder", "upper_arm": "J_Bip_{}_UpperArm", "forearm": "J_Bip_{}_LowerArm",
        "hand": "J_Bip_{}_Hand", "thigh": "J_Bip_{}_UpperLeg", "shin": "J_Bip_{}_LowerLeg", "foot": "J_Bip_{}_Foot",
        "toe": "J_Bip_{}_ToeBase",
    },
    "cmu": {
        "hips": "hip", "spine": "lowerback", "chest": "upperback", "upper_chest": "thorax", "neck": "lowerneck",
        "head": "head", "shoulder": "{}clavicle", "upper_arm": "{}humerus", "forearm": "{}radius", "hand": "{}wrist",
        "thigh": "{}femur", "shin": "{}tibia", "foot": "{}foot", "toe": "{}toes",
    },
    "xsens": {
        "hips": "Pelvis", "spine": "L5", "chest": "L3", "upper_chest": "T8", "neck": "Neck", "head": "Head",
        "shoulder": "{}Shoulder", "upper_arm": "{}UpperArm", "forearm": "{}ForeArm", "hand": "{}Hand",
        "thigh": "{}UpperLeg", "shin": "{}LowerLeg", "foot": "{}Foot", "toe": "{}Toe",
    },
    "biped": {
        "hips": "Bip01 Pelvis", "spine": "Bip01 Spine", "chest": "Bip01 Spine1", "upper_chest": "Bip01 Spine2",
        "neck": "Bip01 Neck", "head": "Bip01 Head", "shoulder": "Bip01 {} Clavicle", "upper_arm": "Bip01 {} UpperArm",
        "forearm": "Bip01 {} Forearm", "hand": "Bip01 {} Hand", "thigh": "Bip01 {} Thigh", "shin": "Bip01 {} Calf",
        "foot": "Bip01 {} Foot", "toe": "Bip01 {} Toe0",
    },
    "meshy": {**PLAIN, "spine": "Spine02", "chest": "Spine01", "upper_chest": "Spine", "neck": "neck"},
    "sketchfab": {bone: f"mixamorig:{name}_0{index:02}" for index, (bone, name) in enumerate(PLAIN.items())},
    "source": {
        bone: f"ValveBiped.Bip01_{name}" for bone, name in {
            "hips": "Pelvis", "spine": "Spine", "chest": "Spine1", "upper_chest": "Spine4", "neck": "Neck1",
            "head": "Head1", "shoulder": "{}_Clavicle", "upper_arm": "{}_UpperArm", "forearm": "{}_Forearm",
            "hand": "{}_Hand", "thumb": "{}_Finger0", "index1": "{}_Finger1", "fingers1": "{}_Finger2",
            "thigh": "{}_Thigh", "shin": "{}_Calf", "foot": "{}_Foot", "toe": "{}_Toe0",
        }.items()
    },
    "character_creator": {
        bone: f"CC_Base_{name}" for bone, name in {
            "hips": "Hip", "spine": "Waist", "chest": "Spine01", "upper_chest": "Spine02", "head": "Head",
            "neck": "Neck", "shoulder": "{}_Clavicle", "upper_arm": "{}_Upperarm", "forearm": "{}_Forearm",
            "hand": "{}_Hand", "thumb": "{}_Thumb1", "index1": "{}_Index1", "fingers1": "{}_Mid1",
            "thigh": "{}_Thigh", "shin": "{}_Calf", "foot": "{}_Foot", "toe": "{}_ToeBase",
        }.items()
    },
    "daz": {
        "hips": "hip", "spine": "abdomenLower", "chest": "chestLower", "upper_chest": "chestUpper",
        "neck": "neckLower", "head": "head", "shoulder": "{}Collar", "upper_arm": "{}ShldrBend",
        "forearm": "{}ForearmBend", "hand": "{}Hand", "thumb": "{}Thumb1", "index1": "{}Index1", "fingers1": "{}Mid1",
        "thigh": "{}ThighBend", "shin": "{}Shin", "foot": "{}Foot", "toe": "{}Toe",
    },
    "smpl": {
        "hips": "Pelvis", "spine": "Spine1", "chest": "Spine2", "upper_chest": "Spine3", "neck": "Neck",
        "head": "Head", "shoulder": "{}_Collar", "upper_arm": "{}_Shoulder", "forearm": "{}_Elbow",
        "hand": "{}_Wrist", "thigh": "{}_Hip", "shin": "{}_Knee", "foot": "{}_Ankle", "toe": "{}_Foot",
    },
    "makehuman": {
        "hips": "spine05", "spine": "spine04", "chest": "spine03", "upper_chest": "spine01", "neck": "neck01",
        "head": "head", "shoulder": "clavicle.{}", "upper_arm": "upperarm01.{}", "forearm": "lowerarm01.{}",
        "hand": "wrist.{}", "thumb": "finger1-1.{}", "index1": "finger2-1.{}", "fingers1": "finger3-1.{}",
        "thigh": "upperleg01.{}", "shin": "lowerleg01.{}", "foot": "foot.{}", "toe": "toe1-1.{}",
    },
    "nameless": {bone: f"node{index}_{{}}" for index, bone in enumerate(PLAIN)},
}  # fmt: skip
SIDE_WORDS = {
    "mixamo": ("Left", "Right"), "classic": ("Left", "Right"), "xsens": ("Left", "Right"), "unreal": ("l", "r"),
    "cmu": ("l", "r"), "meshy": ("Left", "Right"), "sketchfab": ("Left", "Right"), "daz": ("l", "r"),
    "nameless": ("a", "b"),
}  # fmt: skip
"""Words for the sides by convention; L and R where none are given."""
_ABOVE = {
    "shoulder": "upper_chest", "upper_arm": "shoulder", "forearm": "upper_arm", "hand": "forearm", "index1": "hand",
    "fingers1": "hand", "thumb": "hand", "thigh": "hips", "shin": "thigh", "foot": "shin", "toe": "foot",
}  # fmt: skip
PARENTS = {
    "spine": "hips", "chest": "spine", "upper_chest": "chest", "neck": "upper_chest", "head": "neck",
    **{f"{low}.{side}": high if high in ("upper_chest", "hips") else f"{high}.{side}"
       for side in "LR" for low, high in _ABOVE.items()},
}  # fmt: skip
DEPTH_FIRST = (
    "hips", "spine", "chest", "upper_chest", "neck", "head",
    *(f"{bone}.{side}" for side in "LR"
      for bone in ("shoulder", "upper_arm", "forearm", "hand", "index1", "fingers1", "thumb")),
    *(f"{bone}.{side}" for side in "LR" for bone in ("thigh", "shin", "foot", "toe")),
)  # fmt: skip


@dataclass(frozen=True)
class Walker:
    """A person who moves, in our axes: rest joints (m), and world orientations from rest (N, 3, 3) by bone.

    Attributes:
        rest: (3,) by bone of ``DEPTH_FIRST``.
        tips: (3,) ends of head, hands and toes.
        turns: (N, 3, 3) by bone.
        hips: (N, 3) places of the hips' joint.
        rate: Frames a second.
    """

    rest: Mapping[str, Floats]
    tips: Mapping[str, Floats]
    turns: Mapping[str, Floats]
    hips: Floats
    rate: float


@dataclass(frozen=True)
class Style:
    """How a file has it.

    Attributes:
        convention: Of names.
        unit: Units a metre.
        up: Axis of the file that is up: y or z.
        order: Of the channels of rotation.
        pose: ``as_is``, ``t`` (arms out), or ``along`` (all bones along X, no pose of a person).
        first_is_rest: Whether the first frame is the rest.
    """

    convention: str = "mixamo"
    unit: float = 100.0
    up: str = "y"
    order: str = "ZYX"
    pose: str = "t"
    first_is_rest: bool = False
    extra: Mapping[str, str] = field(default_factory=dict[str, str])


def write_bvh(walker: Walker, style: Style = Style()) -> str:
    """The text of a BVH file."""
    still = _still(walker, style.pose)
    rest, turns = _posed(walker, still)
    axes = np.eye(3) if style.up == "z" else np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    lines = ["HIERARCHY"]
    order: list[str] = []
    children: dict[str, list[str]] = {}
    for bone in bones_of(style.convention)[1:]:
        children.setdefault(PARENTS[bone], []).append(bone)

    def joint(bone: str, depth: int) -> None:
        pad = "\t" * depth
        parent = PARENTS.get(bone)
        offset = axes @ (rest[bone] - (rest[parent] if parent else np.zeros(3))) * style.unit
        order.append(bone)
        word = "JOINT" if parent else "ROOT"
        place = "6 Xposition Yposition Zposition" if parent is None else "3"
        lines.extend([f"{pad}{word} {name_of(bone, style.convention)}", f"{pad}{{"])
        lines.append(f"{pad}\tOFFSET " + " ".join(f"{value:.6f}" for value in offset))
        lines.append(f"{pad}\tCHANNELS {place} " + " ".join(f"{axis}rotation" for axis in style.order))
        for child in children.get(bone, ()):
            joint(child, depth + 1)
        if bone not in children:
            tip = axes @ (still[bone] @ (walker.tips[bone] - walker.rest[bone])) * style.unit
            values = " ".join(f"{value:.6f}" for value in tip)
            lines.extend([f"{pad}\tEnd Site", f"{pad}\t{{", f"{pad}\t\tOFFSET {values}", f"{pad}\t}}"])
        lines.append(f"{pad}}}")

    joint("hips", 0)
    count = len(walker.hips)
    columns: list[Floats] = [walker.hips @ axes.T * style.unit]
    for bone in order:
        parent = PARENTS.get(bone)
        local = turns[bone] if parent is None else np.swapaxes(turns[parent], -1, -2) @ turns[bone]
        columns.append(np.degrees(_eulers(axes @ local @ axes.T, style.order)))
    rows = np.concatenate(columns, axis=1)
    if style.first_is_rest:
        first = np.r_[axes @ walker.hips[0] * style.unit, np.zeros(rows.shape[1] - 3)]
        rows, count = np.concatenate([first[None], rows]), count + 1
    lines += ["MOTION", f"Frames: {count}", f"Frame Time: {1 / walker.rate:.8f}"]
    lines += [" ".join(f"{value:.5f}" for value in row) for row in rows]
    return "\n".join(lines) + "\n"


def bones_of(convention: str) -> list[str]:
    """Bones that a convention has, parents before children."""
    return [bone for bone in DEPTH_FIRST if bone.partition(".")[0] in CONVENTIONS[convention]]


def name_of(bone: str, convention: str) -> str:
    """What a convention calls a bone of ours."""
    stem, _, side = bone.partition(".")
    words = SIDE_WORDS.get(convention, ("L", "R"))
    return CONVENTIONS[convention][stem].format(words[side == "R"] if side else "")


def _still(walker: Walker, pose: str) -> dict[str, Floats]:
    """Turns of bones that bring the walker's rest to another one."""
    still: dict[str, Floats] = dict.fromkeys(DEPTH_FIRST, np.eye(3))
    ends = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot"}
    for bone in DEPTH_FIRST:
        stem, _, side = bone.partition(".")
        if pose == "t" and stem in (*ends, "hand", "index1", "fingers1", "thumb") and stem not in ("thigh", "shin"):
            out = np.array([1.0 if side == "L" else -1.0, 0, 0])
            above = stem if stem in ends else "forearm"
            way = walker.rest[f"{ends[above]}.{side}"] - walker.rest[f"{above}.{side}"]
            still[bone] = shortest_arc(way, out)
        if pose == "along" and (below := _below(bone)) is not None:
            still[bone] = (
                axes_along([1, 0, 0], [0, 0, 1]) @ axes_along(walker.rest[below] - walker.rest[bone], [0.1, -1, 0.2]).T
            )
    return still


def _posed(walker: Walker, still: Mapping[str, Floats]) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Rest joints and orientations of the same motion, counted from another rest."""
    rest = {"hips": np.asarray(walker.rest["hips"], float)}
    for bone in DEPTH_FIRST[1:]:
        parent = PARENTS[bone]
        rest[bone] = rest[parent] + still[parent] @ (walker.rest[bone] - walker.rest[parent])
    return rest, {bone: walker.turns[bone] @ still[bone].T for bone in DEPTH_FIRST}


def _below(bone: str) -> str | None:
    found = {"hips": "spine", "upper_chest": "neck"}.get(bone)
    return found or next((low for low, high in PARENTS.items() if high == bone), None)


def _eulers(turns: Floats, order: str) -> Floats:
    """Angles (N, 3) of rotations in the order of channels: the first turns the others."""
    i, j, k = ("XYZ".index(axis) for axis in order)
    even = 1.0 if (i, j, k) in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else -1.0
    second = np.arcsin(np.clip(even * turns[:, i, k], -1, 1))
    first = np.arctan2(-even * turns[:, j, k], turns[:, k, k])
    third = np.arctan2(-even * turns[:, i, j], turns[:, i, i])
    whole = about_axis(i, first) @ about_axis(j, second) @ about_axis(k, third)
    assert np.abs(whole - turns).max() < 1e-4
    return np.stack([first, second, third], axis=1)


def a_person(
    rate: float = 24.0, seconds: float = 3.0, does: Callable[[float], Mapping[str, Floats]] | None = None
) -> Walker:
    """Somebody of 1.7 m in a T-pose that moves as a function says: own turns of bones by second."""
    rest = {
        "hips": (0, 0, 0.95), "spine": (0, 0, 1.05), "chest": (0, 0, 1.15), "upper_chest": (0, 0, 1.28),
        "neck": (0, 0, 1.45), "head": (0, 0, 1.53),
    }  # fmt: skip
    for side, s in (("L", 1), ("R", -1)):
        rest |= {
            f"shoulder.{side}": (0.03 * s, 0, 1.40), f"upper_arm.{side}": (0.17 * s, 0, 1.40),
            f"forearm.{side}": (0.45 * s, 0, 1.40), f"hand.{side}": (0.70 * s, 0, 1.40),
            f"index1.{side}": (0.79 * s, -0.02, 1.40), f"fingers1.{side}": (0.79 * s, 0.02, 1.40),
            f"thumb.{side}": (0.72 * s, -0.03, 1.39),
            f"thigh.{side}": (0.09 * s, 0, 0.90), f"shin.{side}": (0.09 * s, 0, 0.49),
            f"foot.{side}": (0.09 * s, 0, 0.08), f"toe.{side}": (0.09 * s, -0.14, 0.02),
        }  # fmt: skip
    joints = {bone: np.array(place, float) for bone, place in rest.items()}
    tips = {"head": np.array([0, 0, 1.7])}
    for side, s in (("L", 1), ("R", -1)):
        tips |= {f"{name}.{side}": np.array([0.88 * s, y, 1.4])
                 for name, y in (("hand", 0), ("index1", -0.02), ("fingers1", 0.02), ("thumb", -0.06))}  # fmt: skip
        tips |= {f"toe.{side}": np.array([0.09 * s, -0.2, 0.02])}
    times = np.arange(round(rate * seconds) + 1) / rate
    own = [does(float(t)) if does is not None else {} for t in times]
    turns: dict[str, Floats] = {}
    for bone in DEPTH_FIRST:
        local = np.array([each.get(bone, np.eye(3)) for each in own])
        turns[bone] = local if bone == "hips" else turns[PARENTS[bone]] @ local
    places = np.array([joints["hips"] + each.get("place", np.zeros(3)) for each in own])
    return Walker(joints, tips, turns, places, rate)


def bones_named(names: Sequence[str], convention: str) -> dict[str, str]:
    """Our bones by the names of a convention."""
    return {name_of(bone, convention): bone for bone in names}
