"""Reads the body pack: base mesh, joints, skin weights and morph targets of the CC0 MakeHuman data. No bpy."""

from __future__ import annotations

import io
import lzma
import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from storyblender.catalog.bodies import BodyRecipe, body_pack_path, macro_targets
from storyblender.geometry.solids import Floats

Ints = NDArray[np.int64]

PARTS: dict[str, slice] = {
    "skin": slice(0, 13380), "tongue": slice(13380, 13606), "eye.L": slice(14598, 14670), "eye.R": slice(14670, 14742),
    "lashes": slice(14742, 14992), "teeth": slice(14992, 15128), "tights": slice(15328, 18002),
    "skirt": slice(18002, 18722), "ribbons": slice(18722, 19150),
}  # fmt: skip
"""Vertex ranges of the base mesh (notes on humans, section 1)."""


@dataclass(frozen=True, eq=False)
class BodyPack:
    """The repacked body data.

    Attributes:
        points: (V, 3) base mesh in decimetres: Y up, facing +Z, +X the person's left.
        faces: (F, 4) quads.
        joints: First of the 8 vertices around each joint, by name.
        weights: (V, 35) skin weights, columns as in ``catalog.skeleton.SKELETON``.
        ears: (13380,) whether a skin vertex belongs to an ear.
        lips: (13380,) how much a skin vertex belongs to the lips, 0..1.
        targets: Start and end of each morph target in the two arrays below.
        target_vertices: (N,) moved vertices.
        target_offsets: (3, N) offsets in 0.1 mm.
    """

    points: Floats
    faces: Ints
    joints: Mapping[str, int]
    weights: Floats
    ears: NDArray[np.bool_]
    lips: Floats
    targets: Mapping[str, tuple[int, int]]
    target_vertices: Ints
    target_offsets: NDArray[np.int16]

    def displacement(self, targets: Mapping[str, float]) -> Floats:
        """Return the sum of morph targets, weighted by amount, (V, 3) in decimetres, base axes."""
        total = np.zeros_like(self.points)
        for name, amount in targets.items():
            start, end = self.targets[name]
            total[self.target_vertices[start:end]] += self.target_offsets[:, start:end].T * (amount * 0.001)
        return total

    def joint(self, points: Floats, name: str) -> Floats:
        """Return the position (3,) of a joint, the mean of the 8 vertices that mark it, in the unit of the points.

        Args:
            points: (V, 3) all vertices of a morphed base mesh.
            name: The joint, for example ``l-knee``.
        """
        first = self.joints[name]
        return points[first : first + 8].mean(0)

    def shape(self, body: BodyRecipe) -> Floats:
        """Return the morphed mesh, (V, 3) in metres, Z up, facing -Y, soles at z = 0, of exactly the wanted stature.

        The stature is piecewise linear in the MakeHuman height on each side of 0.5, so two evaluations solve it.
        """
        steady = self.points + self.displacement(body.details)

        def at(height: float) -> Floats:
            return steady + self.displacement(macro_targets(body, height))

        def stature(points: Floats) -> float:
            return float(np.ptp(points[PARTS["skin"], 1])) * 0.1

        middle = at(0.5)
        end = 0.0 if body.stature < stature(middle) else 1.0
        outer = at(end)
        share = (body.stature - stature(middle)) / (stature(outer) - stature(middle))
        share = min(share, 1.15)
        points = to_scene(middle + (outer - middle) * share)
        points[:, 2] -= points[PARTS["skin"], 2].min()
        return points


def to_scene(points: Floats) -> Floats:
    """Convert base axes and decimetres to Blender's axes and metres, (V, 3)."""
    return np.stack([points[:, 0], -points[:, 2], points[:, 1]], 1) * 0.1


def load_body_pack() -> BodyPack | None:
    """Return the body pack of this user, or None where set-up has not made it."""
    path = body_pack_path(os.environ, Path.home())
    return _load(path) if path.is_file() else None


@lru_cache(maxsize=1)
def _load(path: Path) -> BodyPack:
    """Return the body pack of a file, cached."""
    with np.load(io.BytesIO(lzma.decompress(path.read_bytes()))) as data:
        ends = data["target_ends"].tolist()
        names = data["target_names"].tolist()
        return BodyPack(
            points=data["points"].astype(np.float64),
            faces=data["faces"].astype(np.int64),
            joints=dict(zip(data["joint_names"].tolist(), data["joint_first"].tolist(), strict=True)),
            weights=data["weights"].astype(np.float64),
            ears=data["ears"],
            lips=data["lips"].astype(np.float64),
            targets=dict(zip(names, zip([0, *ends[:-1]], ends, strict=True), strict=True)),
            target_vertices=data["target_vertices"],
            target_offsets=data["target_offsets"],
        )
