"""Facial features: eyes, brows, lashes, teeth, tongue."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from mathutils.interpolate import poly_3d_calc
from numpy.typing import NDArray

from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.pack import PARTS, BodyPack
from storyblender.blender.people.sheet import Sheet, join, rigid_sheet
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON
from storyblender.geometry.solids import Floats, skin_faces

Ints = NDArray[np.int64]

EYE_RINGS = ((0.0, 0), (0.19, 0), (0.20, 1), (0.43, 1), (0.44, 2), (0.50, 2), (0.51, 3), (0.9, 3), (1.4, 3), (1.9, 3))
"""Angle from the optical axis in radians and the slot of the band that ends there: pupil, iris, limbus, sclera."""
EYE_SEGMENTS = 16


def bone_weights(bone: str) -> Floats:
    """Return the weights (35,) of something fixed to one bone."""
    weights = np.zeros(len(SKELETON))
    weights[BONE_INDEX[bone]] = 1
    return weights


def eyes(figure: BodyFigure) -> Sheet:
    """Return both eyeballs; slots: 0 pupil, 1 iris, 2 limbus, 3 sclera, 4 highlight."""
    return join([_eye(figure, side) for side in "LR"])


def _eye(figure: BodyFigure, side: str) -> Sheet:
    """Return the eyeball of a person, its cornea bulging."""
    shape = figure.points[PARTS[f"eye.{side}"]]
    low, high = shape.min(0), shape.max(0)
    radius = float((high - low).max()) / 2
    radii = [radius * (1.03 if angle < 0.45 else 1.0) for angle, _ in EYE_RINGS]
    glint = Glint((-0.16, -1.05, 0.20), 0.085, 6)
    return eyeball((low + high) / 2, radii, side, EYE_RINGS, EYE_SEGMENTS, glint)


class Glint(NamedTuple):
    """The highlight on an eyeball: a disc with its centre and size in radii of the ball."""

    center: tuple[float, float, float]
    size: float
    corners: int


def eyeball(
    center: Floats, radii: Sequence[float], side: str, rings: Sequence[tuple[float, int]], segments: int, glint: Glint
) -> Sheet:
    """Return an eyeball that looks along -Y, on the eye bone of a side.

    Args:
        center: Its middle, metres.
        radii: Radius of the ball at each ring, metres; the last is that of the ball itself.
        side: ``L`` or ``R``.
        rings: Angle of each ring from the axis in radians, and the material slot of the band that ends there.
        segments: Corners of a ring.
        glint: Highlight, in slot 4.
    """
    points: list[Floats] = []
    for radius, (angle, _) in zip(radii, rings, strict=True):
        for turn in (2 * math.pi * step / segments for step in range(segments)):
            way = (math.sin(angle) * math.cos(turn), -math.cos(angle), math.sin(angle) * math.sin(turn))
            points.append(center + radius * np.array(way))
    faces: list[tuple[int, ...]] = [*skin_faces(len(rings), segments, True)]
    slots = [slot for _, slot in rings[1:] for _ in range(segments)]
    start, middle = len(points), center + radii[-1] * np.array(glint.center)
    for turn in (2 * math.pi * step / glint.corners for step in range(glint.corners)):
        points.append(middle + radii[-1] * glint.size * np.array((math.cos(turn), 0.0, math.sin(turn))))
    faces.append(tuple(range(start, start + glint.corners)))
    return rigid_sheet(np.array(points), faces, bone_weights(f"eye.{side}"), [*slots, 4])


@lru_cache(maxsize=1)
def base_tree(pack: BodyPack) -> tuple[BVHTree, Ints]:
    """Return the skin of the base mesh for ray casts, decimetres, and the corners (F, 4) of its faces."""
    skin = PARTS["skin"].stop
    faces = pack.faces[pack.faces[:, 0] < skin]
    return BVHTree.FromPolygons(pack.points[:skin].tolist(), faces.tolist()), faces


class Pin:
    """A place on the face, found once on the base mesh and valid on every morph.

    Args:
        pack: The body data.
        x: Decimetres on the base mesh, the person's left positive.
        y: Height on the base mesh, decimetres.
    """

    def __init__(self, pack: BodyPack, x: float, y: float) -> None:
        tree, faces = base_tree(pack)
        hit, _, face, _ = tree.ray_cast((x, y, 5.0), (0.0, 0.0, -1.0))
        if face is None or hit.z < 0:  # past the jaw's edge: the nearest place on it
            hit, _, face, _ = tree.find_nearest((x, y, 1.0))
        self._corners = faces[face]
        self._shares = np.array(poly_3d_calc([Vector(pack.points[corner]) for corner in self._corners], hit))

    def on(self, values: Floats) -> Floats:
        """Return the value at the pin of an array with a row per base mesh vertex."""
        return self._shares @ values[self._corners]


def brows(figure: BodyFigure, height: float, keys: dict[str, Floats]) -> tuple[Sheet, dict[str, Floats]]:
    """Return both eyebrows and the offsets (V, 3) of their shape keys, metres.

    Args:
        figure: The body.
        height: Half the height of a brow where it is thickest, decimetres on the base mesh.
        keys: Offsets of each shape key for the whole base mesh, (V, 3) metres.
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
    return rigid_sheet(points, faces, weights), offsets
