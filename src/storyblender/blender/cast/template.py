"""The body that is fitted into a user's mesh: a thinned average grown-up with its skeleton and skin weights. No bpy."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.pack import PARTS, BodyPack
from storyblender.catalog.bodies import recipe
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.geometry.solids import Floats
from storyblender.memory.asset_sheet import CharacterLook

Ints = NDArray[np.int64]

SPACING, HAND_SPACING = 0.028, 0.011
"""Metres between the points that are kept of the skin, and of the hands and feet."""
STILL_BONES = ("jaw", "eye.L", "eye.R")
"""A user's mesh has no jaw and no eyes that move; the head takes their weight."""
_FINE = ("hand", "thumb", "index", "fingers", "foot", "toe")


@dataclass(frozen=True, eq=False)
class Template:
    """An average body in the A-pose, metres, Z up, facing -Y, soles at z = 0; V points, B bones of ``SKELETON``.

    Attributes:
        points: (V, 3) thinned skin.
        normals: (V, 3) outward.
        weights: (V, B).
        heads: (B, 3) joints.
        tails: (B, 3).
        parents: (B,) -1 for the hips.
        areas: (V,) share of the whole skin that each point stands for; they sum to 1.
        stature: Metres.
    """

    points: Floats
    normals: Floats
    weights: Floats
    heads: Floats
    tails: Floats
    parents: tuple[int, ...]
    areas: Floats
    stature: float


@lru_cache(maxsize=1)
def template_of(pack: BodyPack) -> Template:
    """Return the template of the body data."""
    whole = pack.shape(recipe(CharacterLook(gender="male", age=25.0, stature=1.7), 1))
    skin = PARTS["skin"]
    points = whole[skin]
    faces = pack.faces[(pack.faces[:, 0] >= skin.start) & (pack.faces[:, 0] < skin.stop)] - skin.start
    normals, areas = _normals_and_areas(points, faces)
    weights = _without_face(pack.weights[skin])
    fine = weights[:, [index for bone, index in BONE_INDEX.items() if bone.startswith(_FINE)]].sum(1) > 0.5
    kept, nearest = _thinned(points, normals, np.where(fine, HAND_SPACING, SPACING))
    shares = np.bincount(nearest, areas, len(kept))
    joints = {name: pack.joint(whole, name) for bone in SKELETON for name in (bone.head, bone.tail)}
    return Template(
        points=points[kept],
        normals=normals[kept],
        weights=weights[kept],
        heads=np.array([joints[bone.head] for bone in SKELETON]),
        tails=np.array([joints[bone.tail] for bone in SKELETON]),
        parents=tuple(BONE_INDEX[bone.parent] if bone.parent else -1 for bone in SKELETON),
        areas=shares / shares.sum(),
        stature=float(points[:, 2].max()),
    )


def _without_face(weights: Floats) -> Floats:
    """Return skin weights (V, B) in which the head moves jaw and eyes."""
    moved = weights.copy()
    for name in STILL_BONES:
        moved[:, BONE_INDEX["head"]] += moved[:, BONE_INDEX[name]]
        moved[:, BONE_INDEX[name]] = 0
    return moved / moved.sum(1, keepdims=True)


def _normals_and_areas(points: Floats, faces: Ints) -> tuple[Floats, Floats]:
    """Return the outward normal (V, 3) and the area (V,) of each vertex of quads."""
    a, b, c, d = (points[faces[:, corner]] for corner in range(4))
    across = np.cross(c - a, d - b)
    normals, areas = np.zeros_like(points), np.zeros(len(points))
    for corner in range(4):
        for axis in range(3):
            normals[:, axis] += np.bincount(faces[:, corner], across[:, axis], len(points))
        areas += np.bincount(faces[:, corner], np.linalg.norm(across, axis=1) / 8, len(points))
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12), areas


def _thinned(points: Floats, normals: Floats, spacing: Floats) -> tuple[Ints, Ints]:
    """Return the rows that are kept, one for each cell of the local spacing and each side, and each row's kept one."""
    cells = np.c_[np.floor(points / spacing[:, None]), spacing * 1e4, np.floor(normals * 0.99 + 0.5)].astype(np.int64)
    _, first, inverse = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return first[order], rank[inverse.ravel()]
