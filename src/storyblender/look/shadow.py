"""Shadow maps: the depth a lamp sees, and what of a picture it therefore reaches."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.look.raster import Image

_TAPS = (
    (0.0, 0.0),
    (0.9, 0.3),
    (-0.3, 0.9),
    (-0.9, -0.3),
    (0.3, -0.9),
    (1.6, -1.1),
    (1.1, 1.6),
    (-1.6, 1.1),
    (-1.1, -1.6),
)
"""Offsets in texels over which the shadow's edge is softened."""


@dataclass(frozen=True)
class ShadowMap:
    """Depth seen from a lamp through a square frame.

    Attributes:
        eye: (3,) lamp position, or a point far up a sun's ray, world, metres.
        axes: (3, 3) world from lamp; it looks along its -Z.
        half_extent: Tangent of half the opening angle; metres for a sun.
        parallel: True for a sun.
        depth: float32 (n, n), metres along the axis; large where nothing is hit.
    """

    eye: NDArray[np.float64]
    axes: NDArray[np.float64]
    half_extent: float
    parallel: bool
    depth: NDArray[np.float32]

    def visibility(self, positions: Image, normal: Image, softness: float = 1.0) -> Image:
        """Return the lit share, 0 to 1, of (h, w, 3) world positions; what lies outside the map is lit.

        Args:
            positions: World, metres.
            normal: World, unit.
            softness: Width of the edge in texels.
        """
        # Receivers are lifted off their surface by two texels, so that slanted ones do not shade themselves.
        texel = 2 * self.half_extent / self.depth.shape[0]
        lift = np.float32(texel) if self.parallel else texel * np.linalg.norm(positions - self.eye, axis=2)[..., None]
        lifted = positions + normal * (2 * lift + 0.01).astype(np.float32)
        local = (lifted - self.eye.astype(np.float32)) @ self.axes.astype(np.float32)
        distance = -local[..., 2]
        scale = self.half_extent if self.parallel else self.half_extent * np.maximum(distance, 1e-3)
        size = self.depth.shape[0]
        column = (local[..., 0] / scale + 1) * (size / 2)
        row = (1 - local[..., 1] / scale) * (size / 2)
        inside = (column >= 0) & (column < size) & (row >= 0) & (row < size) & (distance > 0)
        nearer = distance - (0.01 + 2 * scale / size)
        lit = np.zeros(distance.shape, np.float32)
        for dx, dy in _TAPS:
            x = np.clip(column + dx * softness, 0, size - 1).astype(np.int32)
            y = np.clip(row + dy * softness, 0, size - 1).astype(np.int32)
            lit += self.depth[y, x] >= nearer
        return np.where(inside, lit / len(_TAPS), 1.0).astype(np.float32)
