"""A plain mannequin on the person's skeleton, used until the body data has been fetched: capsules, no face."""

from __future__ import annotations

import numpy as np

from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.sheet import Sheet, join, rigid_sheet
from storyblender.catalog.skeleton import SKELETON
from storyblender.geometry.solids import Floats, skin_faces

CLAY = (0.42, 0.38, 0.34)

JOINTS: dict[str, tuple[float, float, float]] = {
    "pelvis": (0, -0.008, 0.533), "spine-3": (0, 0.006, 0.619), "spine-2": (0, 0.006, 0.664),
    "spine-1": (0, 0.011, 0.749), "neck": (0, -0.005, 0.854), "head": (0, -0.027, 0.914), "head-2": (0, -0.026, 0.940),
    "mouth": (0, -0.036, 0.917), "jaw": (0, -0.08, 0.881),
    "l-eye": (0.017, -0.072, 0.936), "l-eye-target": (0.018, -0.095, 0.934),
    "l-clavicle": (0.014, -0.016, 0.811), "l-shoulder": (0.104, -0.013, 0.797), "l-elbow": (0.201, -0.015, 0.689),
    "l-hand": (0.274, -0.113, 0.616), "l-finger-1-1": (0.274, -0.139, 0.612), "l-finger-1-4": (0.251, -0.183, 0.588),
    "l-finger-2-1": (0.290, -0.169, 0.593), "l-finger-2-2": (0.292, -0.181, 0.584),
    "l-finger-2-4": (0.289, -0.202, 0.562), "l-finger-3-1": (0.300, -0.159, 0.586),
    "l-finger-4-1": (0.304, -0.148, 0.581), "l-finger-4-2": (0.310, -0.157, 0.567),
    "l-finger-4-4": (0.314, -0.171, 0.540), "l-upper-leg": (0.061, -0.003, 0.526), "l-knee": (0.085, -0.023, 0.288),
    "l-ankle": (0.108, -0.012, 0.042), "l-toe-3-1": (0.115, -0.09, 0.020), "l-toe-3-4": (0.116, -0.116, 0.018),
}  # fmt: skip
"""Joints of an average grown-up as shares of the stature; the right side mirrors the left."""

RADII: dict[str, float] = {
    "hips": 0.085, "spine": 0.080, "chest": 0.085, "upper_chest": 0.085, "neck": 0.034, "head": 0.060,
    "shoulder": 0.034, "upper_arm": 0.030, "forearm": 0.024, "hand": 0.020, "thumb": 0.008, "index1": 0.007,
    "index2": 0.006, "fingers1": 0.012, "fingers2": 0.010, "thigh": 0.048, "shin": 0.033, "foot": 0.022, "toe": 0.016,
}  # fmt: skip
"""Radius of each bone's capsule as a share of the stature; eyes and jaw have none."""

SEGMENTS = 10
CAP_TILTS = (-1.45, -0.9, -0.35, 0.35, 0.9, 1.45)


def mannequin_joints(stature: float) -> dict[str, Floats]:
    """Return the joints that the skeleton names, for a ``stature`` in metres."""
    joints: dict[str, Floats] = {}
    for name, place in JOINTS.items():
        joints[name] = np.array(place) * stature
        if name.startswith("l-"):
            joints["r" + name[1:]] = joints[name] * (-1, 1, 1)
    return joints


def build_mannequin(stature: float) -> Sheet:
    """Return the capsules of a person of ``stature`` metres, each fixed to its bone."""
    joints = mannequin_joints(stature)
    capsules = []
    for bone in SKELETON:
        radius = RADII.get(bone.name.split(".")[0])
        if radius is not None:
            capsules.append(_capsule(joints[bone.head], joints[bone.tail], radius * stature, bone_weights(bone.name)))
    sheet = join(capsules)
    points = sheet.points.copy()
    points[:, 2] = np.clip(points[:, 2], 0.0, stature)
    return sheet.moved(points)


def _capsule(head: Floats, tail: Floats, radius: float, weights: Floats) -> Sheet:
    """Return a capsule between two joints."""
    along = (tail - head) / np.linalg.norm(tail - head)
    across = np.cross(along, (1.0, 0.0, 0.0) if abs(along[0]) < 0.9 else (0.0, 1.0, 0.0))
    across /= np.linalg.norm(across)
    second = np.cross(along, across)
    turns = 2 * np.pi * np.arange(SEGMENTS) / SEGMENTS
    ring = np.outer(np.cos(turns), across) + np.outer(np.sin(turns), second)
    rows = []
    for tilt in CAP_TILTS:
        end = head if tilt < 0 else tail
        rows.append(end + radius * (np.cos(tilt) * ring + np.sin(tilt) * along))
    last = len(CAP_TILTS) - 1
    faces = skin_faces(last + 1, SEGMENTS, True)
    faces.append(tuple(range(SEGMENTS))[::-1])
    faces.append(tuple(range(last * SEGMENTS, (last + 1) * SEGMENTS)))
    return rigid_sheet(np.concatenate(rows), faces, weights)
