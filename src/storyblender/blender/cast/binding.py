"""Skin weights for a user's mesh, from the template that was fitted into it. No bpy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.cast.shells import Ints, edges_of, pieces_of, smoothed
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.geometry.solids import Floats

NEIGHBOURS = 8
"""Points of the template that a vertex takes its weights from."""
BATCH = 2048
_LIMBS = {
    **dict.fromkeys(("neck", "head", "jaw", "eye"), 1),
    **dict.fromkeys(("upper_arm", "forearm", "hand", "thumb", "index1", "index2", "fingers1", "fingers2"), 2),
    **dict.fromkeys(("thigh", "shin", "foot", "toe"), 4),
}
LIMB = np.array(
    [
        limb + (bone.name.endswith(".R") and limb > 1)
        for bone in SKELETON
        for limb in [_LIMBS.get(bone.name.split(".")[0], 0)]
    ]
)
"""(B,) limb of each bone: 0 trunk, 1 head, 2 and 3 arms, 4 and 5 legs."""


def weights_for(
    points: Floats, normals: Floats, triangles: Ints, body: Floats, facing: Floats, given: Floats, scale: float
) -> Floats:
    """Return skin weights (V, B) for a mesh.

    Args:
        points: (V, 3) vertices, metres.
        normals: (V, 3) outward.
        triangles: (T, 3).
        body: (n, 3) the fitted template.
        facing: (n, 3) its normals.
        given: (n, B) its weights.
        scale: Stature over 1.7 m.
    """
    weights, distances = _nearest(points, normals, body, facing, given, scale)
    edges = edges_of(triangles)
    pieces = pieces_of(len(points), edges)
    weights = _without_islands(weights, edges, pieces)
    loose = np.clip(distances / (0.06 * scale), 0, 1)[:, None]
    close, wide = smoothed(weights, edges, 4, 0.5), smoothed(weights, edges, 8, 0.6)
    weights = close * (1 - loose) + wide * loose
    return _rigid_pieces(weights, points, pieces, distances, scale)


def _nearest(
    points: Floats, normals: Floats, body: Floats, facing: Floats, given: Floats, scale: float
) -> tuple[Floats, Floats]:
    """Return the weights of the points of the body nearby that face the same way, and the distance to them."""
    turn = 0.035 * scale
    theirs = np.c_[body, facing * turn].astype(np.float32)
    squares = (theirs**2).sum(1)
    weights, distances = np.zeros((len(points), given.shape[1])), np.zeros(len(points))
    for start in range(0, len(points), BATCH):
        rows = slice(start, start + BATCH)
        mine = np.c_[points[rows], normals[rows] * turn].astype(np.float32)
        apart = (mine**2).sum(1)[:, None] + squares - 2 * mine @ theirs.T
        near = np.argpartition(apart, NEIGHBOURS, axis=1)[:, :NEIGHBOURS]
        square = np.maximum(np.take_along_axis(apart, near, 1), 0).astype(float)
        least = square.min(1, keepdims=True)
        spread = (0.010 * scale) ** 2 + 0.12 * least
        share = np.exp(-(square - least) / (2 * spread))
        weights[rows] = np.einsum("nk,nkb->nb", share / share.sum(1, keepdims=True), given[near])
        distances[rows] = np.linalg.norm(body[near[np.arange(len(near)), square.argmin(1)]] - points[rows], axis=1)
    return weights, distances


def limbs_of(weights: Floats) -> Ints:
    """Return the limb (V,) that each vertex mostly moves with."""
    shares = np.stack([weights[:, limb == LIMB].sum(1) for limb in range(6)], 1)
    return shares.argmax(1)


def _without_islands(weights: Floats, edges: Ints, pieces: Ints) -> Floats:
    """Return the weights without small islands of another limb within a piece, such as fingers' on a thigh."""
    limbs = limbs_of(weights)
    same = limbs[edges[:, 0]] == limbs[edges[:, 1]]
    islands = pieces_of(len(weights), edges[same])
    sizes = np.bincount(islands)
    largest = np.zeros((pieces.max() + 1, 6), np.int64)
    np.maximum.at(largest, (pieces, limbs), sizes[islands])
    whole = np.bincount(pieces)
    stray = (sizes[islands] < 0.35 * largest[pieces, limbs]) | (sizes[islands] < 0.004 * whole[pieces])
    return filled(weights, edges, ~stray)


def filled(values: Floats, edges: Ints, known: NDArray[np.bool_]) -> Floats:
    """Return values (V, k) in which those that are not known are taken from neighbours, step by step."""
    values, known = values.copy(), known.copy()
    ends = np.concatenate([edges, edges[:, ::-1]])
    while not known.all():
        reach = ends[known[ends[:, 1]] & ~known[ends[:, 0]]]
        if not len(reach):
            return values
        target = np.unique(reach[:, 0])
        total, count = np.zeros_like(values), np.bincount(reach[:, 0], minlength=len(values))
        np.add.at(total, reach[:, 0], values[reach[:, 1]])
        values[target] = total[target] / count[target][:, None]
        known[target] = True
    return values


def _rigid_pieces(weights: Floats, points: Floats, pieces: Ints, distances: Floats, scale: float) -> Floats:
    """Return weights in which a piece that is carried or worn on one limb, such as a sword or a hat, stays stiff."""
    weights = weights.copy()
    for piece in range(int(pieces.max()) + 1):
        rows = np.flatnonzero(pieces == piece)
        bone = _carrier(weights[rows], points[rows], distances[rows], scale)
        if bone is not None:
            weights[rows] = 0
            weights[rows, bone] = 1
    return weights


def _carrier(weights: Floats, points: Floats, distances: Floats, scale: float) -> int | None:
    """Return the bone that moves a whole piece; None for what bends with the body: skin and clothes."""
    near = distances <= np.percentile(distances, 20) + 0.004 * scale
    limbs = np.bincount(limbs_of(weights[near]), minlength=6) / near.sum()
    limb, share = int(limbs.argmax()), float(limbs.max())
    extent = np.sort(np.ptp(points, axis=0))
    mean = weights[near].mean(0)
    small = extent[2] < 0.16 * scale
    worn = limb == 1 and share > 0.8
    carried = limb in (2, 3) and share > 0.8 and float(np.mean(distances > 0.05 * scale)) > 0.3
    if not (small or worn or carried):
        return None
    if worn:
        return BONE_INDEX["head"] if mean[BONE_INDEX["neck"]] < 0.6 else None
    if small and not carried:  # a button or a buckle, not a glove or a shoe
        strongest = int(mean.argmax())
        return strongest if mean[strongest] > 0.5 and not extent[2] > 0.07 * scale else None
    side = "LR"[limb - 2]
    upper = mean[[BONE_INDEX[f"upper_arm.{side}"], BONE_INDEX[f"forearm.{side}"]]].sum()
    held = mean[limb == LIMB].sum() - upper > 0.4
    return BONE_INDEX[f"hand.{side}"] if held else int(mean.argmax())
