"""Finds what is wrong with a surface from outside: ground planes, strays, doubled and inside-out faces. Pure.

A surface comes as polygons: the vertex of each corner, and how many corners each face has. Parts are faces that hang
together by their vertices. Z is up, the unit is any.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Mask = NDArray[np.bool_]

_GROUND = 1.6
"""How many times longer, both ways, a sheet under or behind a thing is than the thing, to be none of it."""
_FLAT = 0.003
"""Thickness of a sheet, as a share of its length."""
_SINGLE = 1.3
"""Most area of a sheet, as a share of its outline: what has an upper and a lower side is a slab."""
_FAR = 3.0
"""Lengths of the thing between it and a stray."""
_STRAY = 0.05
"""Most of the area that strays may have together."""
_MOST_PARTS = 5000
"""A model of more parts is foliage or hair, of which no part is looked at alone."""


@dataclass(frozen=True)
class Surface:
    """Polygons with what is needed to look at their parts.

    Attributes:
        vertices: (n, 3).
        corners: (c,) vertex of each corner.
        sizes: (f,) corners of each face.
    """

    vertices: Floats
    corners: Ints
    sizes: Ints

    @cached_property
    def starts(self) -> Ints:
        """(f,) first corner of each face."""
        return np.cumsum(self.sizes) - self.sizes

    @cached_property
    def after(self) -> Ints:
        """(c,) the next corner of the same face."""
        after = np.arange(len(self.corners)) + 1
        after[self.starts + self.sizes - 1] = self.starts
        return after

    @cached_property
    def places(self) -> Ints:
        """(c,) number of each corner's place: vertices within a millionth of the size are one."""
        grid = max(float(np.ptp(self.vertices, axis=0).max()), 1e-9) * 1e-6
        x, y, z = ((self.vertices - self.vertices.min(axis=0)) / grid).round().astype(np.int64).T
        _, place = np.unique((x << 42) | (y << 21) | z, return_inverse=True)
        return place[self.corners]

    @cached_property
    def normals(self) -> Floats:
        """(f, 3) vectors across the faces, as long as twice their area (Newell)."""
        place = self.vertices[self.corners]
        return np.add.reduceat(np.cross(place, place[self.after]), self.starts, axis=0)

    @cached_property
    def parts(self) -> Ints:
        """(f,) number of the part that each face belongs to."""
        at = self.places
        face_of = np.repeat(np.arange(len(self.sizes)), self.sizes)
        label = np.arange(int(at.max()) + 1)
        while True:
            lowest = np.minimum.reduceat(label[at], self.starts)
            joined = label.copy()
            np.minimum.at(joined, at, lowest[face_of])
            np.minimum.at(joined, label[at], lowest[face_of])
            while not np.array_equal(further := joined[joined], joined):
                joined = further
            if np.array_equal(joined, label):
                break
            label = joined
        return np.unique(label[at[self.starts]], return_inverse=True)[1]


def find_foreign(surface: Surface) -> tuple[Mask, tuple[str, ...]]:
    """Return the faces that are none of the thing, and sentences about them.

    Args:
        surface: The whole model, Z up.
    """
    foreign = _doubled(surface)
    notes = [f"{foreign.sum()} doubled faces are left out"] if foreign.any() else []
    part = surface.parts
    count = int(part.max()) + 1
    if 1 < count <= _MOST_PARTS:
        areas = np.linalg.norm(surface.normals, axis=1) / 2
        boxes = _boxes(surface, part, count)
        for name, found in (("what is far away from it", _strays), ("the ground or a backdrop", _sheets)):
            chosen = found(boxes, np.bincount(part, areas, count).astype(np.float64))
            if chosen.any() and not chosen.all():
                boxes[chosen] = np.nan
                foreign |= chosen[part]
                notes.append(f"{name} ({chosen[part].sum()} faces) is left out")
    return foreign, tuple(notes)


def find_inside_out(surface: Surface) -> Mask:
    """Return the faces of closed parts whose outer side is within."""
    part, normals = surface.parts, surface.normals
    middles = surface.vertices[surface.corners[surface.starts]]
    count = int(part.max()) + 1
    volumes = np.bincount(part, np.einsum("ij,ij->i", middles - surface.vertices.mean(axis=0), normals), count)
    return (_closed(surface, part, count) & (volumes < 0))[part]


def _closed(surface: Surface, part: Ints, count: int) -> Mask:
    """Return the parts of which every edge has two faces that run along it in opposite ways."""
    first = surface.places.astype(np.int64)
    second = first[surface.after]
    width = int(first.max()) + 1
    there, back = first * width + second, second * width + first
    edges, index, times = np.unique(there, return_inverse=True, return_counts=True)
    at = np.minimum(np.searchsorted(edges, back), len(edges) - 1)
    whole = (edges[at] == back) & (first != second) & (times[index] == 1)
    return np.bincount(part[np.repeat(np.arange(len(surface.sizes)), surface.sizes)], ~whole, count) == 0


def _doubled(surface: Surface) -> Mask:
    """Return the triangles and quads that lie on an earlier face, whichever way they look."""
    at = surface.places
    doubled = np.zeros(len(surface.sizes), bool)
    for size in (3, 4):
        chosen = np.flatnonzero(surface.sizes == size)
        keys = np.sort(at[surface.starts[chosen][:, None] + np.arange(size)], axis=1)
        order = np.lexsort(keys.T[::-1])  # stable: the first of equal faces stays
        equal = (keys[order[1:]] == keys[order[:-1]]).all(axis=1)
        doubled[chosen[order[1:][equal]]] = True
    return doubled


def _boxes(surface: Surface, part: Ints, count: int) -> Floats:
    """Return (parts, 2, 3) lower and upper corners."""
    boxes = np.stack([np.full((count, 3), np.inf), np.full((count, 3), -np.inf)], axis=1)
    of = np.repeat(part, surface.sizes)
    np.minimum.at(boxes[:, 0], of, surface.vertices[surface.corners])
    np.maximum.at(boxes[:, 1], of, surface.vertices[surface.corners])
    return boxes


def _strays(boxes: Floats, areas: Floats) -> Mask:
    """Return small parts that are far away from all that is near the largest one."""
    near: Mask = np.zeros(len(boxes), bool)
    near[int(areas.argmax())] = True
    while True:
        low, high = boxes[near, 0].min(axis=0), boxes[near, 1].max(axis=0)
        gaps = np.maximum(low - boxes[:, 1], boxes[:, 0] - high).max(axis=1)
        reached = near | (gaps < _FAR * (high - low).max())
        if np.array_equal(reached, near):
            break
        near = reached
    return ~near & (areas[~near].sum() < _STRAY * areas.sum())


def _sheets(boxes: Floats, areas: Floats) -> Mask:
    """Return flat single sheets under or behind the rest and much larger than it."""
    sides = boxes[:, 1] - boxes[:, 0]
    lengths = np.sort(sides, axis=1)
    sheets = (lengths[:, 0] <= _FLAT * lengths[:, 2]) & (areas < _SINGLE * lengths[:, 1] * lengths[:, 2])
    others = ~sheets & ~np.isnan(boxes[:, 0, 0])
    found = np.zeros(len(boxes), bool)
    if not others.any():
        return found
    low, high = boxes[others, 0].min(axis=0), boxes[others, 1].max(axis=0)
    margin = 0.03 * (high - low)
    for index in np.flatnonzero(sheets):
        axis = int(sides[index].argmin())
        along = [side for side in range(3) if side != axis]
        wider = (sides[index, along] > _GROUND * (high - low)[along]).all()
        beside = boxes[index, 0, axis] <= low[axis] + margin[axis]
        beside |= axis < 2 and boxes[index, 1, axis] >= high[axis] - margin[axis]
        found[index] = wider and beside
    return found
