"""The features: eyes, brows, lashes, teeth, tongue, glasses."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from mathutils.interpolate import poly_3d_calc
from numpy.typing import NDArray

from storyblender.blender.people.figure import Figure
from storyblender.blender.people.pack import PARTS, BodyPack
from storyblender.blender.people.sheet import Sheet, join, rigid
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

EYE_RINGS = ((0.0, 0), (0.19, 0), (0.20, 1), (0.43, 1), (0.44, 2), (0.50, 2), (0.51, 3), (0.9, 3), (1.4, 3), (1.9, 3))
"""Angle from the optical axis in radians and the slot of the band that ends there: pupil, iris, limbus, sclera."""
EYE_SEGMENTS = 16


def bone_weights(bone: str) -> Floats:
    """Return the weights (35,) of something fixed to one bone."""
    weights = np.zeros(len(SKELETON))
    weights[BONE_INDEX[bone]] = 1
    return weights


def eyes(figure: Figure) -> Sheet:
    """Return both eyeballs; slots: 0 pupil, 1 iris, 2 limbus, 3 sclera, 4 highlight."""
    return join([_eye(figure, side) for side in "LR"])


def _eye(figure: Figure, side: str) -> Sheet:
    shape = figure.points[PARTS[f"eye.{side}"]]
    low, high = shape.min(0), shape.max(0)
    center, radius = (low + high) / 2, float((high - low).max()) / 2
    points, faces, slots = [], [], []
    for angle, _ in EYE_RINGS:
        bulge = 1.03 if angle < 0.45 else 1.0
        for step in range(EYE_SEGMENTS):
            turn = 2 * math.pi * step / EYE_SEGMENTS
            direction = (math.sin(angle) * math.cos(turn), -math.cos(angle), math.sin(angle) * math.sin(turn))
            points.append(center + radius * bulge * np.array(direction))
    for ring, (_, slot) in enumerate(EYE_RINGS[1:]):
        for step in range(EYE_SEGMENTS):
            a, b = ring * EYE_SEGMENTS + step, ring * EYE_SEGMENTS + (step + 1) % EYE_SEGMENTS
            faces.append((a, b, b + EYE_SEGMENTS, a + EYE_SEGMENTS))
            slots.append(slot)
    start = len(points)
    glint = center + radius * np.array((-0.16, -1.05, 0.20))
    for step in range(6):
        turn = 2 * math.pi * step / 6
        points.append(glint + radius * 0.085 * np.array((math.cos(turn), 0.0, math.sin(turn))))
    faces.append(tuple(range(start, start + 6)))
    slots.append(4)
    return rigid(np.array(points), faces, bone_weights(f"eye.{side}"), slots)


@lru_cache(maxsize=1)
def base_tree(pack: BodyPack) -> tuple[BVHTree, Ints]:
    """Return the skin of the base mesh, decimetres, for rays, and the corners of its faces."""
    skin = PARTS["skin"].stop
    faces = pack.faces[pack.faces[:, 0] < skin]
    return BVHTree.FromPolygons(pack.points[:skin].tolist(), faces.tolist()), faces


class Pin:
    """A place on the face, found once on the base mesh and valid on every morph.

    Args:
        pack: The body data.
        x: Decimetres on the base mesh, the person's left positive.
        y: Height on the base mesh.
    """

    def __init__(self, pack: BodyPack, x: float, y: float) -> None:
        tree, faces = base_tree(pack)
        hit, _, face, _ = tree.ray_cast((x, y, 5.0), (0.0, 0.0, -1.0))
        if face is None or hit.z < 0:  # past the jaw's edge: the nearest place on it
            hit, _, face, _ = tree.find_nearest((x, y, 1.0))
        self._corners = faces[face]
        self._shares = np.array(poly_3d_calc([Vector(pack.points[corner]) for corner in self._corners], hit))

    def on(self, values: Floats) -> Floats:
        """Return the value there of an array over the base mesh."""
        return self._shares @ values[self._corners]


def brows(figure: Figure, height: float, keys: dict[str, Floats]) -> tuple[Sheet, dict[str, Floats]]:
    """Return both eyebrows and their shape keys.

    Args:
        figure: Whose.
        height: Half height in decimetres on the base mesh.
        keys: Shape keys of the whole base mesh.
    """
    pins: list[tuple[Pin, float]] = []
    faces: list[tuple[int, int, int, int]] = []
    columns = 10
    for sign in (1, -1):
        first = len(pins)
        for step in range(columns):
            u = step / (columns - 1)
            x = 0.12 + u * 0.46
            y = 7.50 + 0.055 * math.sin(u * math.pi * 0.85) - 0.03 * u
            half = height * (1 - 0.75 * u**1.5) * min(1.0, 0.55 + u * 2)
            pins += [(Pin(figure.pack, sign * x, y + at * half), lift) for at, lift in ((-1, 0.8), (0, 3.2), (1, 0.8))]
        for step in range(columns - 1):
            for row in range(2):
                a = first + step * 3 + row
                faces.append((a, a + 3, a + 4, a + 1) if sign > 0 else (a, a + 1, a + 4, a + 3))
    scale = figure.head_scale * 0.001
    points = np.array([pin.on(figure.points) + np.array((0, -lift * scale, 0)) for pin, lift in pins])
    weights = np.array([pin.on(figure.pack.weights) for pin, _ in pins])
    offsets = {key: np.array([pin.on(values) for pin, _ in pins]) for key, values in keys.items()}
    return rigid(points, faces, weights), offsets
