"""Figures of stiff parts, such as robots and puppets: each part moves with one bone, and joints are between parts."""

from __future__ import annotations

import numpy as np

from storyblender.blender.cast.shells import Ints
from storyblender.catalog.skeleton import BONE_INDEX
from storyblender.geometry.solids import Floats

PARTS, LONGEST = 10, 0.4
"""Least number of parts of such a figure, and the longest that one may be, as a share of the stature."""
JOINTED = tuple(
    (f"{upper}.{side}", f"{lower}.{side}")
    for upper, lower in (("upper_arm", "forearm"), ("forearm", "hand"), ("thigh", "shin"), ("shin", "foot"))
    for side in "LR"
)
_LIMBS = ("head", *dict.fromkeys(bone for pair in JOINTED for bone in pair))
"""Bones that must have a part."""
_CHAINS = [
    [BONE_INDEX[f"{bone}.{side}"] for bone in chain]
    for chain in (("upper_arm", "forearm", "hand"), ("thigh", "shin", "foot"))
    for side in "LR"
]
_MOVED = np.array([BONE_INDEX[bone] for bone in ("hips", "chest", "neck", *_LIMBS)])


def bones_of_parts(points: Floats, pieces: Ints, heads: Floats, tails: Floats, stature: float) -> Ints | None:
    """Return the bone (V,) that moves each vertex of a figure of stiff parts; None where skin bends between limbs.

    Args:
        points: (V, 3) metres.
        pieces: (V,) number of the connected piece of each vertex.
        heads: (B, 3) joints of the fitted body.
        tails: (B, 3).
        stature: Metres.
    """
    count = int(pieces.max()) + 1
    if count < PARTS:
        return None
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, pieces, points)
    np.maximum.at(high, pieces, points)
    if (high - low).max() > LONGEST * stature:
        return None
    places = (heads + tails) / 2
    for hand in (BONE_INDEX["hand.L"], BONE_INDEX["hand.R"]):
        places[hand] = tails[hand]  # of hand and fingers, the knuckles are the middle
    middles = places[_MOVED]
    apart = np.linalg.norm(((low + high) / 2)[:, None] - middles[None], axis=2)
    bones = _MOVED[apart.argmin(1)].astype(np.int64)
    for chain in _CHAINS:
        own = np.flatnonzero(np.isin(bones, chain))
        if len(own) == len(chain):  # one part a bone: the nearer ones are above
            away = np.linalg.norm(((low + high) / 2)[own] - heads[chain[0]], axis=1)
            bones[own[np.argsort(away)]] = chain
    return bones[pieces] if {BONE_INDEX[bone] for bone in _LIMBS} <= {*bones.tolist()} else None


def joints_between(points: Floats, bones: Ints) -> dict[str, Floats]:
    """Return where elbows, wrists, knees and ankles are: halfway between the ends of the parts of two bones."""
    places: dict[str, Floats] = {}
    for upper, lower in JOINTED:
        above, below = points[bones == BONE_INDEX[upper]], points[bones == BONE_INDEX[lower]]
        if not len(above) or not len(below):
            continue
        start = (above.min(0) + above.max(0)) / 2
        way = (below.min(0) + below.max(0)) / 2 - start
        length = float(np.linalg.norm(way))
        if lower.startswith("foot"):
            way, length = np.array((0.0, 0.0, -1.0)), 1.0
        ends = float(((above - start) @ way).max()), float(((below - start) @ way).min())
        places[lower] = start + way * (ends[0] + ends[1]) / 2 / length**2
    return places
