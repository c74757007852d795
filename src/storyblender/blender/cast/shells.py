"""The connected pieces of a mesh, and values that are passed along its edges. Pure numpy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.solids import Floats

Ints = NDArray[np.int64]


def edges_of(triangles: Ints) -> Ints:
    """Return the (E, 2) edges of triangles, each once."""
    pairs = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return np.unique(np.sort(pairs, axis=1), axis=0)


def pieces_of(count: int, edges: Ints) -> Ints:
    """Return the number of the piece that each of ``count`` vertices belongs to, from 0."""
    label = np.arange(count)
    while True:
        low = np.minimum(label[edges[:, 0]], label[edges[:, 1]])
        fresh = label.copy()
        np.minimum.at(fresh, label[edges[:, 0]], low)
        np.minimum.at(fresh, label[edges[:, 1]], low)
        fresh = fresh[fresh]
        if np.array_equal(fresh, label):
            return np.unique(label, return_inverse=True)[1].ravel().astype(np.int64)
        label = fresh


def smoothed(values: Floats, edges: Ints, rounds: int, share: float) -> Floats:
    """Return values (V, k), each moved towards the mean of its neighbours' by ``share``, some rounds."""
    ends = np.concatenate([edges, edges[:, ::-1]])
    order = np.argsort(ends[:, 0], kind="stable")
    source, counts = ends[order, 1], np.bincount(ends[:, 0], minlength=len(values))
    has = np.flatnonzero(counts)
    starts = (np.cumsum(counts) - counts)[has]
    for _ in range(rounds):
        means = np.add.reduceat(values[source], starts, axis=0) / counts[has][:, None]
        values = values.copy()
        values[has] += share * (means - values[has])
    return values
