"""Finds where things can be put on a mesh: level faces with room above them, as rectangles (notes: engine, section 2).

Rays fall on a grid and are peeled layer by layer, so every board of a shelf is a top, and a dressing table gives its
desk, not the upper edge of its mirror.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np
from mathutils.bvhtree import BVHTree
from numpy.typing import NDArray

from storyblender.geometry.rectangles import close_seams, largest_rectangle
from storyblender.geometry.resting import LevelGrid
from storyblender.geometry.solids import Floats
from storyblender.memory.asset_sheet import Anchor

LEVEL = 0.8
"""Least z of the normal of a level face."""
ROOM = 0.07
"""Least free height above a top, metres."""
RAYS = 2600
"""Rays over the footprint, whatever its size."""
LAYERS = 24
"""Most surfaces that a ray crosses."""
"""Most surfaces that a ray crosses."""
"""Most surfaces that a ray crosses."""
SPREAD = 0.035
"""Metres of height that one top may vary: cushions and blankets are not flat."""
LEAST_AREA = 0.006
"""Square metres of the smallest top."""
MOST_TOPS = 16
SEAM = 0.025
"""Metres between the boards of one top: a bench of two planks is not two narrow tops."""


@dataclass(frozen=True)
class _Hits:
    """Level, uncovered points of a mesh.

    Attributes:
        row: Grid row of each point.
        column: Grid column of each point.
        z: Height, metres.
        room: Free height above, inf if open.
        solid: (N, 4) each piece of matter that a ray crosses: grid row and column, upper and lower end.
    """

    row: NDArray[np.int64]
    column: NDArray[np.int64]
    z: Floats
    room: Floats
    solid: Floats

    def is_blocked(self, shape: tuple[int, int], z: float) -> NDArray[np.bool_]:
        """Return the cells of a grid of ``shape`` in which something stands on a level at height ``z``."""
        _, _, upper, lower = self.solid.T
        rows, columns, *_ = self.solid[(upper > z + SPREAD) & (lower < z + ROOM)].T.astype(int)
        blocked = np.zeros(shape, bool)
        blocked[rows, columns] = True
        return blocked


def find_tops(mesh: bpy.types.Mesh) -> tuple[Anchor, ...]:
    """Return the tops of a mesh, the largest first, named ``top_1``, ``top_2``, ...

    Args:
        mesh: In the asset's own frame, metres, Z up.
    """
    if not mesh.polygons:
        return ()
    cell, origin, shape = _grid(mesh)
    hits = _fall(mesh, cell, origin, shape)
    rectangles = [found for level in _levels(hits.z) for found in _rectangles(hits, level, shape, cell)]
    rectangles.sort(key=lambda found: (-found[0], found[1]))
    tops = []
    for _, (z, row, column, rows, columns, room) in rectangles[:MOST_TOPS]:
        center = origin + cell * np.array([column + columns / 2, row + rows / 2])
        tops.append(
            Anchor(
                kind="top",
                name=f"top_{len(tops) + 1}",
                location=(float(center[0]), float(center[1]), z),
                direction=(0.0, -1.0, 0.0),
                size=(float(columns * cell), float(rows * cell)),
                clearance=None if np.isinf(room) else room,
            )
        )
    return tuple(tops)


def _grid(mesh: bpy.types.Mesh) -> tuple[float, Floats, tuple[int, int]]:
    """Return the cell size, the lower corner in x, y, and the number of rows and columns."""
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    flat = points.reshape(-1, 3)[:, :2].astype(float)
    low, extent = flat.min(axis=0), np.maximum(np.ptp(flat, axis=0), 1e-3)
    cell = float(np.sqrt(extent[0] * extent[1] / RAYS))
    columns, rows = (max(1, int(np.ceil(side / cell - 1e-6))) for side in extent)
    return cell, low - (np.array([columns, rows]) * cell - extent) / 2, (rows, columns)


def _cast_rays(
    mesh: bpy.types.Mesh, cell: float, origin: Floats, shape: tuple[int, int]
) -> Iterator[tuple[int, int, list[tuple[float, float]]]]:
    """Yield row and column of each cell, and z and normal z of the surfaces below it, the highest first."""
    solid = bmesh.new()
    solid.from_mesh(mesh)
    tree = BVHTree.FromBMesh(solid)
    solid.free()
    start = max(vertex.co.z for vertex in mesh.vertices) + 1.0
    for row, column in np.ndindex(shape):
        x, y, z = origin[0] + (column + 0.5) * cell, origin[1] + (row + 0.5) * cell, start
        surfaces: list[tuple[float, float]] = []
        for _ in range(LAYERS):
            point, normal, _, _ = tree.ray_cast((x, y, z), (0, 0, -1))
            if point is None:
                break
            surfaces.append((point.z, normal.z))
            z = point.z - 1e-4
        yield row, column, surfaces


def _fall(mesh: bpy.types.Mesh, cell: float, origin: Floats, shape: tuple[int, int]) -> _Hits:
    """Drop one ray through every cell and return the level faces that are entered from outside."""
    found: list[tuple[int, int, float, float]] = []
    matter: list[tuple[int, int, float, float]] = []
    start = max(vertex.co.z for vertex in mesh.vertices) + 1.0
    for row, column, surfaces in _cast_rays(mesh, cell, origin, shape):
        ceiling, inside, upper = np.inf, 0, start
        for z, rise in surfaces:
            if rise > 0:
                if inside == 0 and rise > LEVEL and ceiling - z > ROOM:
                    found.append((row, column, z, ceiling - z))
                upper = z if inside == 0 else upper
                inside += 1
            else:
                inside = max(0, inside - 1)
                if inside == 0:
                    matter.append((row, column, upper, z))
            ceiling = z
    table = np.array(found).reshape(-1, 4)
    solids = np.array(matter).reshape(-1, 4)
    return _Hits(table[:, 0].astype(int), table[:, 1].astype(int), table[:, 2], table[:, 3], solids)


def level_field(mesh: bpy.types.Mesh) -> LevelGrid:
    """Return the level places of a mesh in metres, Z up; the direction of its face normals does not matter."""
    cell, origin, shape = _grid(mesh)
    top = np.full(shape, -np.inf)
    found: list[tuple[int, int, float, float]] = []
    for row, column, surfaces in _cast_rays(mesh, cell, origin, shape):
        ceiling = np.inf
        for z, rise in surfaces:
            top[row, column] = max(top[row, column], z)
            if abs(rise) > LEVEL and ceiling - z > ROOM:
                found.append((row, column, z, ceiling - z))
            ceiling = z
    table = np.array(found).reshape(-1, 4)
    return LevelGrid(cell, origin, top, table[:, 0].astype(int), table[:, 1].astype(int), table[:, 2], table[:, 3])


def _levels(heights: Floats) -> list[NDArray[np.int64]]:
    """Return groups of hits within ``SPREAD`` of each other, the largest first."""
    left = np.argsort(heights, kind="stable")
    groups = []
    while len(left):
        z = heights[left]
        last = np.searchsorted(z, z + SPREAD, side="right")
        first = int(np.argmax(last - np.arange(len(z))))
        groups.append(left[first : last[first]])
        left = np.r_[left[:first], left[last[first] :]]
    return groups


def _rectangles(
    hits: _Hits, level: NDArray[np.int64], shape: tuple[int, int], cell: float
) -> list[tuple[float, tuple[float, int, int, int, int, float]]]:
    """Return (area, (z, row, column, rows, columns, room)) of the largest free rectangles of one level."""
    height, room = np.full(shape, np.nan), np.full(shape, np.inf)
    height[hits.row[level], hits.column[level]] = hits.z[level]
    room[hits.row[level], hits.column[level]] = hits.room[level]
    free = ~np.isnan(height)
    free |= close_seams(free, cell, SEAM) & ~hits.is_blocked(shape, float(np.median(hits.z[level])))
    found = []
    while free.sum() * cell * cell >= LEAST_AREA:
        row, column, rows, columns = largest_rectangle(free)
        area = rows * columns * cell * cell
        if area < LEAST_AREA or min(rows, columns) * cell < 0.06:
            return found
        part = np.s_[row : row + rows, column : column + columns]
        found.append((area, (float(np.nanmedian(height[part])), row, column, rows, columns, float(room[part].min()))))
        free[part] = False
    return found
