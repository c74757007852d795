"""The clothes already worn: the next garment is pushed outside them; trimmings are sewn to their front."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from storyblender.blender.people.sheet import Sheet
from storyblender.geometry.solids import Floats

REACH = 0.05
"""Metres within which a layer pushes."""


@dataclass
class FrontPoint:
    """A point on the front of the clothes: location (metres), outward normal and skin weights (35,)."""

    location: Floats
    normal: Floats
    weights: Floats


def polygons(sheet: Sheet) -> list[list[int]]:
    """Return the faces of a sheet as lists of vertex numbers, without padding."""
    sizes = (sheet.faces >= 0).sum(1)
    return [row[:size] for row, size in zip(sheet.faces.tolist(), sizes.tolist(), strict=True)]


class WornLayers:
    """The clothes worn so far.

    Args:
        back: y of the neck in metres; what lies farther back is never the front.
    """

    def __init__(self, back: float) -> None:
        self._back = back
        self._layers: list[tuple[Sheet, BVHTree]] = []

    def add(self, sheet: Sheet) -> None:
        """Add a garment's ``sheet`` as the outermost layer."""
        self._layers.append((sheet, BVHTree.FromPolygons(sheet.points.tolist(), polygons(sheet))))

    def push_out(self, sheet: Sheet, gap: float) -> Sheet:
        """Return a sheet with every vertex outside all layers that are within ``REACH`` of it.

        Args:
            sheet: The next garment, metres.
            gap: Metres between it and the layers at least.
        """
        points = sheet.points.copy()
        for _, tree in self._layers:
            for row, point in enumerate(points.tolist()):
                nearest, normal, _, _ = tree.find_nearest(point, REACH)
                if nearest is None:
                    continue
                depth = gap - (Vector(point) - nearest).dot(normal)
                if depth > 0:
                    points[row] += np.array(normal) * depth
        return sheet.moved(points)

    def front(self, x: float, z: float) -> FrontPoint | None:
        """Return the foremost point of the clothes at ``x`` and ``z`` (metres), or None if they have no front there."""
        best: FrontPoint | None = None
        for sheet, tree in self._layers:
            hit, normal, face, _ = tree.ray_cast((x, -2.0, z), (0.0, 1.0, 0.0))
            if hit is None or hit.y > self._back or (best is not None and hit.y >= best.location[1]):
                continue
            corners = sheet.faces[face]
            corners = corners[corners >= 0]
            nearest = corners[np.linalg.norm(sheet.points[corners] - np.array(hit), axis=1).argmin()]
            outward = np.array(normal) * (1.0 if normal.y < 0 else -1.0)
            best = FrontPoint(np.array(hit), outward, sheet.weights[nearest])
        return best
