"""Implicit surfaces: rounded solids as signed distance fields, smooth unions, and meshing. Pure numpy."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Field = Callable[[Floats], Floats]
"""Signed distance field: (N, 3) points to (N,) distances, negative inside."""

_CORNERS = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)])
_EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if np.abs(_CORNERS[a] - _CORNERS[b]).sum() == 1]


def ellipsoid(center: ArrayLike, half: ArrayLike) -> Field:
    """Return the field of an ellipsoid.

    Args:
        center: (3,) centre.
        half: (3,) semi-axes along x, y, z, in the same unit.
    """
    middle, semi = np.asarray(center, float), np.asarray(half, float)

    def field(points: Floats) -> Floats:
        away = points - middle
        near = np.linalg.norm(away / semi, axis=1)
        slope = np.linalg.norm(away / semi**2, axis=1)
        return near * (near - 1) / np.maximum(slope, 1e-9)

    return field


def rod(start: ArrayLike, end: ArrayLike, radii: tuple[float, float], *, flat: float = 1.0) -> Field:
    """Return the field of a rod with round ends.

    Args:
        start: Centre of one end.
        end: Centre of the other end.
        radii: Radius at the start and at the end.
        flat: Ratio of height (along z) to width of a cross-section.
    """
    squeeze = np.array((1.0, 1.0, 1 / flat))
    first, last = np.asarray(start, float) * squeeze, np.asarray(end, float) * squeeze
    along = last - first

    def field(points: Floats) -> Floats:
        away = points * squeeze - first
        share = np.clip(away @ along / (along @ along), 0, 1)
        reach = radii[0] + (radii[1] - radii[0]) * share
        return np.linalg.norm(away - share[:, None] * along, axis=1) - reach

    return field


def melted(fields: Sequence[Field], blend: float) -> Field:
    """Return the smooth union of ``fields``; seams are rounded over the distance ``blend``, in the fields' own unit."""

    def field(points: Floats) -> Floats:
        total = fields[0](points)
        for each in fields[1:]:
            other = each(points)
            near = np.clip(blend - np.abs(total - other), 0, None) / blend
            total = np.minimum(total, other) - near**2 * blend / 4
        return total

    return field


def surface(field: Field, low: ArrayLike, high: ArrayLike, step: float) -> tuple[Floats, Ints]:
    """Return vertices (V, 3) and outward quads (F, 4) of the surface where ``field`` is zero (surface nets).

    Args:
        field: The signed distance field.
        low: Corner of the box that holds all of it.
        high: The opposite corner.
        step: Edge length of a grid cell.
    """
    start = np.asarray(low, float)
    counts = np.ceil((np.asarray(high, float) - start) / step).astype(int) + 1
    grid = np.stack(np.meshgrid(*(np.arange(count) for count in counts), indexing="ij"), -1)
    values = field(start + grid.reshape(-1, 3) * step).reshape(counts)
    cells = counts - 1

    def at(corner: NDArray[np.int64]) -> Floats:
        x, y, z = corner
        return values[x : x + cells[0], y : y + cells[1], z : z + cells[2]]

    total, crossings = np.zeros((*cells, 3)), np.zeros(cells)
    for a, b in _EDGES:
        first, last = at(_CORNERS[a]), at(_CORNERS[b])
        cut = (first < 0) != (last < 0)
        share = np.where(cut, first / np.where(cut, first - last, 1), 0)
        total += np.where(cut[..., None], _CORNERS[a] + share[..., None] * (_CORNERS[b] - _CORNERS[a]), 0)
        crossings += cut
    used = crossings > 0
    number = np.full(cells, -1)
    number[used] = np.arange(used.sum())
    points = start + (grid[: cells[0], : cells[1], : cells[2]][used] + total[used] / crossings[used, None]) * step
    return points, np.concatenate([_quads(values, number, axis) for axis in range(3)])


def _quads(values: Floats, number: Ints, axis: int) -> Ints:
    """Return the quads around the grid edges along one axis that cross the surface."""
    turned, cells = np.moveaxis(values, axis, 0), np.moveaxis(number, axis, 0)
    first, last = turned[:-1, 1:-1, 1:-1], turned[1:, 1:-1, 1:-1]
    cut = (first < 0) != (last < 0)
    around = [cells[:, :-1, :-1], cells[:, 1:, :-1], cells[:, 1:, 1:], cells[:, :-1, 1:]]
    faces = np.stack([corner[cut] for corner in around], 1)
    # Face normals point from inside to outside; taking y for the first axis mirrors the other two.
    backwards = (first[cut] >= 0) ^ (axis == 1)
    faces[backwards] = faces[backwards, ::-1]
    return faces
