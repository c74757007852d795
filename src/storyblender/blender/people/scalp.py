"""The head under the hair: where hair grows, how thick it is, and points on skull and hair by direction."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from numpy.typing import NDArray

from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.sheet import Sheet, clip, normals, smoothed
from storyblender.blender.people.worn_layers import polygons
from storyblender.catalog.hair import HairSpec
from storyblender.geometry.solids import Floats

HAIRLINE = np.array([
    (-1.0, 6.50), (-0.1, 6.58), (0.15, 6.88), (0.35, 7.22), (0.60, 7.36), (0.78, 7.08), (0.90, 7.12), (0.98, 7.62),
    (1.12, 7.86), (1.30, 7.95), (2.0, 7.98),
])  # fmt: skip
"""Height of the hairline over depth (z, front positive) on the base mesh: nape, ear, sideburn, temple, forehead."""


def above_hairline(base: Floats, spec: HairSpec, masculine: float) -> Floats:
    """Return how far points of the base mesh lie above the hairline, (N,) decimetres.

    Args:
        base: (N, 3) positions on the base mesh, decimetres.
        spec: The hairstyle.
        masculine: 0 to 1, raises the hairline at the temples.
    """
    x, depth = np.abs(base[:, 0]), base[:, 2]
    line = np.interp(depth, HAIRLINE[:, 0], HAIRLINE[:, 1])
    temples = np.clip(1 - np.abs(x - 0.52) / 0.22, 0, 1) * np.clip((depth - 0.85) / 0.2, 0, 1)
    line = line + temples * (0.06 + 0.10 * masculine)
    if spec.growth == "receding":
        line = line + np.interp(depth, (0.7, 1.1), (0, 0.16)) + 0.22 * temples
    grown = base[:, 1] - line
    if spec.growth == "wreath":
        grown = np.minimum(grown, 7.72 - base[:, 1] - 0.45 * np.clip(depth - 0.2, 0, 1))
    return grown


def covered_scalp(figure: BodyFigure, skin: Sheet, spec: HairSpec, masculine: float) -> NDArray[np.bool_]:
    """Return which faces of the skin lie well under the hair, (F,).

    Args:
        figure: The body.
        skin: Its skin, not yet cut.
        spec: The hairstyle.
        masculine: 0 to 1, shapes the hairline.
    """
    if not spec.top and not spec.side:
        return np.zeros(len(skin.faces), bool)
    deep = (above_hairline(skin.base, spec, masculine) > 0.25) & (skin.base[:, 1] > 6.8) & (skin.base[:, 2] < 1.6)
    return deep[skin.faces].all(1) & ~figure.pack.ears[skin.source][skin.faces].any(1)


@dataclass(frozen=True, eq=False)
class Scalp:
    """A head with a hairstyle's growth and thickness.

    Attributes:
        figure: The body.
        spec: The hairstyle.
        masculine: 0 to 1, shapes the hairline.
        hatted: Whether a hat presses the hair on top flat.
    """

    figure: BodyFigure
    spec: HairSpec
    masculine: float
    hatted: bool = False

    @cached_property
    def center(self) -> Floats:
        """A point inside the skull: between the ears, a little above them."""
        ears = self.figure.points[: len(self.figure.pack.ears)][self.figure.pack.ears].mean(0)
        return ears + np.array((0.0, 0.0, 0.042 * self.figure.head_scale))

    @cached_property
    def _skull(self) -> Sheet:
        """The skin of the head above the neck, without the ears."""
        sheet = self.figure.part("skin")
        base = sheet.base
        kept = (base[:, 1] > 6.3) & ~self.figure.pack.ears & (np.abs(base[:, 0]) < 1.2)
        return sheet.keep_faces(kept[sheet.faces].all(1))

    @cached_property
    def _tree(self) -> BVHTree:
        """The skull for ray casts."""
        return BVHTree.FromPolygons(self._skull.points.tolist(), polygons(self._skull))

    @cached_property
    def _corners(self) -> list[list[tuple[Vector, float]]]:
        """Corners of every face of the skull, each with its decimetres above the hairline."""
        grown = above_hairline(self._skull.base, self.spec, self.masculine).tolist()
        corners = [(Vector(point), high) for point, high in zip(self._skull.points.tolist(), grown, strict=True)]
        return [[corners[index] for index in face] for face in polygons(self._skull)]

    def thickness(self, base: Floats) -> Floats:
        """Return the thickness of the hair over points of the base mesh (N, 3), metres."""
        spec = self.spec
        high = np.clip((base[:, 1] - 7.4) / 0.9, 0, 1)
        full = spec.side * (1 - high) + spec.top * high
        if self.hatted:
            full = full * (1 - 0.85 * np.clip((base[:, 1] - 7.3) / 0.3, 0, 1))
        grown = np.clip(above_hairline(base, spec, self.masculine) / 0.22, 0, 1) ** 0.6
        return (0.0015 + full * grown) * self.figure.head_scale

    def shell(self) -> Sheet:
        """Return the hair as one thin sheet over the scalp, below the locks."""
        sheet = self._skull
        back = sheet.base[:, 2] < 1.6
        sheet = sheet.keep_faces(back[sheet.faces].all(1))
        sheet = clip(sheet, above_hairline(sheet.base, self.spec, self.masculine))
        ears = self.figure.pack.points[np.flatnonzero(self.figure.pack.ears)[::4]]
        distance = np.sqrt(((sheet.base[:, None] - ears) ** 2).sum(2).min(1))
        thick = self.thickness(sheet.base) * np.clip(distance / 0.12, 0.12, 1)
        if self.spec.comb == "part":
            groove = np.exp(-(((sheet.base[:, 0] / 0.8 - self.spec.parting) / 0.05) ** 2))
            thick *= 1 - 0.6 * groove * np.clip((sheet.base[:, 1] - 7.8) / 0.3, 0, 1)
        outward, lifted = normals(sheet), smoothed(sheet, 2)
        clearance = ((lifted - sheet.points) * outward).sum(1)
        return sheet.moved(lifted + outward * np.maximum(0.8 * thick - clearance, 0)[:, None])

    def skull_surface(self, direction: Floats) -> tuple[Floats, float] | None:
        """Return the skull point in a direction and its decimetres above the hairline; None if it misses."""
        hit, _, face, _ = self._tree.ray_cast(Vector(self.center), Vector(direction))
        if hit is None:
            return None
        shares = [(1 / ((corner - hit).length + 1e-6), high) for corner, high in self._corners[face]]
        return np.array(hit), sum(share * high for share, high in shares) / sum(share for share, _ in shares)

    def hair_surface(self, direction: Floats, lift: float) -> tuple[Floats, float] | None:
        """Return a point (3,) over the hair, metres, and its decimetres above the hairline, or None.

        Args:
            direction: Unit vector (3,) from the middle of the head.
            lift: Metres over the hair, negative into it; at most 0 under a hat.
        """
        found = self.skull_surface(direction)
        if found is None:
            return None
        point, grown = found
        up = float(direction[2])
        high = min(max((up + 0.1) / 0.9, 0.0), 1.0)
        full = self.spec.side * (1 - high) + self.spec.top * high
        if self.hatted:
            full *= 1 - 0.9 * min(max((up + 0.05) / 0.3, 0.0), 1.0)
            lift = min(lift, 0.0)
        thick = 0.0015 + full * min(max((grown + 0.12) / 0.4, 0.25), 1.0) ** 0.6
        return point + direction * (thick * self.figure.head_scale + lift), grown
