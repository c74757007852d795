"""Finds where a hand takes hold of any small shape: its slender part, or its side at the height of its mass. Pure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

MAX_GRIP = 0.095
"""Metres that a hand closes around."""
MAX_HELD_LENGTH = 1.3
"""Metres: the longest side of what is carried in a hand."""
MAX_HELD_WIDTH = 0.6
"""Metres: the second longest."""
_SLICES = 32
_MIN_GRIP_LENGTH = 0.05
"""Metres of a shaft that a hand needs, at least."""
_MAX_HANDLE_RATIO = 1.6
"""How many times wider than thick a handle may be; a blade is more."""


@dataclass(frozen=True)
class Hold:
    """Where a hand closes.

    Attributes:
        place: (3,) middle of the part that is held.
        axis: 0, 1 or 2: the way that part runs.
        half: Metres from the middle to its surface on -X (on +Z where it runs along X).
        closed: 0..1: how far the hand closes around it.
    """

    place: tuple[float, float, float]
    axis: int
    half: float
    closed: float


def find_hold(vertices: Floats, triangles: NDArray[np.int64]) -> Hold | None:
    """Return where a thing is held; None if it is too large to be carried in a hand.

    Args:
        vertices: (n, 3) in metres, Z up.
        triangles: (m, 3) vertex indices.
    """
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    extent = np.sort(high - low)
    if extent[2] > MAX_HELD_LENGTH or extent[1] > MAX_HELD_WIDTH:
        return None
    corners = vertices[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    mass = np.average(corners.mean(axis=1), axis=0, weights=np.maximum(areas, 1e-12))
    axis = int((high - low).argmax())
    slender = _find_handle(_measure_slices(corners, low, high, axis), mass[axis])
    if slender is not None:
        middle = [0.0, 0.0, 0.0]
        middle[axis] = slender[0]
        sides = [side for side in range(3) if side != axis]
        for side, value in zip(sides, slender[1], strict=True):
            middle[side] = value
        across = 1 if axis == 0 else 0
        half = slender[2][across]
        return Hold((middle[0], middle[1], middle[2]), axis, half, _grip_closure(max(slender[2])))
    x, y, z = ((low + high) / 2).tolist()
    z = float(np.clip(mass[2], low[2] + 0.3 * (high - low)[2], low[2] + 0.7 * (high - low)[2]))
    half = float((high - low)[0] / 2)
    return Hold((x, y, z), 2, half, _grip_closure(half))


def _grip_closure(half: float) -> float:
    """Return how far a hand closes around something of a half width: a fist around a rod, flat against a box."""
    return float(np.interp(half, (0.012, 0.05, 0.12), (0.9, 0.55, 0.3)))


def _measure_slices(corners: Floats, low: Floats, high: Floats, axis: int) -> Floats:
    """Return (slices, 5): place along the axis, and low and high of the other two sides in each slice; NaN if empty."""
    edges = np.linspace(low[axis], high[axis], _SLICES + 1)
    others = [side for side in range(3) if side != axis]
    reach = corners[:, :, axis]
    starts = np.clip(np.searchsorted(edges, reach.min(axis=1), side="right") - 1, 0, _SLICES - 1)
    ends = np.clip(np.searchsorted(edges, reach.max(axis=1), side="left") - 1, 0, _SLICES - 1)
    outline = np.full((_SLICES, 5), np.nan)
    outline[:, 0] = (edges[:-1] + edges[1:]) / 2
    for index in range(_SLICES):
        inside = (starts <= index) & (ends >= index)
        if not inside.any():
            continue
        cut = _slice_triangles(corners[inside], axis, float(edges[index]), float(edges[index + 1]))
        for column, side in enumerate(others):
            outline[index, 1 + 2 * column : 3 + 2 * column] = cut[:, side].min(), cut[:, side].max()
    return outline


def _slice_triangles(corners: Floats, axis: int, low: float, high: float) -> Floats:
    """Return the points of triangles' edges within a slice, and where the edges enter and leave it."""
    first, second = corners.reshape(-1, 3), np.roll(corners, -1, axis=1).reshape(-1, 3)
    start, step = first[:, axis], second[:, axis] - first[:, axis]
    safe = np.where(np.abs(step) < 1e-12, 1.0, step)
    shares = np.sort(np.stack([(low - start) / safe, (high - start) / safe]), axis=0)
    flat = np.abs(step) < 1e-12
    within = (start >= low) & (start <= high)
    shares[0] = np.where(flat, 0.0, np.clip(shares[0], 0, 1))
    shares[1] = np.where(flat, 1.0, np.clip(shares[1], 0, 1))
    touched = np.where(flat, within, shares[1] > shares[0]) | within
    ways = second - first
    points = np.concatenate([first[touched] + ways[touched] * share[touched, None] for share in shares])
    return points if len(points) else corners.reshape(-1, 3)


def _find_handle(outline: Floats, mass: float) -> tuple[float, tuple[float, float], tuple[float, float]] | None:
    """Return place along the axis, middle and half widths of the graspable run that is nearest to the mass."""
    width = np.stack([outline[:, 2] - outline[:, 1], outline[:, 4] - outline[:, 3]], axis=1)
    thick, thin = np.nan_to_num(width, nan=9.0).max(axis=1), np.nan_to_num(width, nan=9.0).min(axis=1)
    fits = (thick < MAX_GRIP) & (thick > 0.006)
    round_ = fits & (thick < _MAX_HANDLE_RATIO * np.maximum(thin, 1e-6)) & (thin > 0.01)
    step = float(outline[1, 0] - outline[0, 0])
    for chosen in (round_, fits):
        runs = [run for run in _runs(chosen) if len(run) * step >= _MIN_GRIP_LENGTH]
        if not runs:
            continue
        best = min(runs, key=lambda run: float(np.abs(outline[run, 0] - mass).min()))
        inner = best[(best - best[0]) * step >= _MIN_GRIP_LENGTH / 2]
        inner = inner[(best[-1] - inner) * step >= _MIN_GRIP_LENGTH / 2 - step] if len(inner) else best
        inner = inner if len(inner) else best
        at = int(inner[np.abs(outline[inner, 0] - mass).argmin()])
        middle = ((outline[at, 1] + outline[at, 2]) / 2, (outline[at, 3] + outline[at, 4]) / 2)
        half = (float(width[at, 0] / 2), float(width[at, 1] / 2))
        return float(outline[at, 0]), (float(middle[0]), float(middle[1])), half
    return None


def _runs(chosen: NDArray[np.bool_]) -> list[NDArray[np.int64]]:
    places = np.flatnonzero(chosen)
    return [run for run in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1) if len(run)]
