"""Many rotations at once: matrices (..., 3, 3) and quaternions (..., 4) w, x, y, z. Pure numpy."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from storyblender.geometry.solids import Floats

_TINY = 1e-9


def unit(vectors: ArrayLike) -> Floats:
    """Return vectors (..., 3) at length 1; those of no length stay as they are."""
    values = np.asarray(vectors, float)
    lengths = np.linalg.norm(values, axis=-1, keepdims=True)
    return values / np.where(lengths > _TINY, lengths, 1.0)


def about_axis(axis: int, angles: ArrayLike) -> Floats:
    """Return the rotations (..., 3, 3) by angles (...) in radians about the axis x (0), y (1) or z (2)."""
    angles = np.asarray(angles, float)
    cos, sin = np.cos(angles), np.sin(angles)
    turn = np.zeros((*angles.shape, 3, 3))
    one, two = (axis + 1) % 3, (axis + 2) % 3
    turn[..., axis, axis] = 1.0
    turn[..., one, one] = turn[..., two, two] = cos
    turn[..., two, one], turn[..., one, two] = sin, -sin
    return turn


def shortest_arc(start: ArrayLike, end: ArrayLike) -> Floats:
    """Return the shortest rotation (3, 3) that brings the direction ``start`` to the direction ``end``."""
    a, b = unit(start), unit(end)
    cosine = float(a @ b)
    if cosine < -1 + 1e-7:  # half a turn, about any axis across
        across = unit(np.cross(a, np.eye(3)[int(np.argmin(np.abs(a)))]))
        return 2 * np.outer(across, across) - np.eye(3)
    x, y, z = np.cross(a, b)
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + skew + skew @ skew / (1 + cosine)


def axes_along(direction: ArrayLike, normal: ArrayLike) -> Floats:
    """Return axes (..., 3, 3) in columns: the direction, the normal made square to it, and their cross product.

    Args:
        direction: (..., 3).
        normal: (..., 3), not along the direction.
    """
    along = unit(direction)
    square = np.asarray(normal, float)
    square = unit(square - along * np.sum(along * square, axis=-1, keepdims=True))
    return np.stack([along, square, np.cross(along, square)], axis=-1)


def matrices_of(quaternions: ArrayLike) -> Floats:
    """Return the rotations (..., 3, 3) of unit quaternions (..., 4)."""
    w, x, y, z = np.moveaxis(np.asarray(quaternions, float), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def quaternions_of(turns: ArrayLike) -> Floats:
    """Return the unit quaternions (..., 4) of rotations (..., 3, 3)."""
    m = np.asarray(turns, float)
    trace = m[..., 0, 0] + m[..., 1, 1] + m[..., 2, 2]
    diagonal = np.stack([trace, m[..., 0, 0], m[..., 1, 1], m[..., 2, 2]], axis=-1)
    squares = np.maximum(0.0, 1 + 2 * diagonal - trace[..., None])
    squares[..., 0] = np.maximum(0.0, 1 + trace)
    products = np.zeros((*trace.shape, 4, 4))  # four times the products of the parts, in pairs
    products[..., range(4), range(4)] = squares
    for i, (j, k) in enumerate(((2, 1), (0, 2), (1, 0)), 1):
        products[..., 0, i] = products[..., i, 0] = m[..., j, k] - m[..., k, j]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        products[..., i + 1, j + 1] = products[..., j + 1, i + 1] = m[..., j, i] + m[..., i, j]
    best = np.argmax(squares, axis=-1)
    rows = np.take_along_axis(products, best[..., None, None], axis=-2)[..., 0, :]
    return rows / np.linalg.norm(rows, axis=-1, keepdims=True)


def continuous(quaternions: Floats) -> Floats:
    """Return quaternions (N, ..., 4) of a motion with neighbours in time on one hemisphere."""
    flips = np.where(np.sum(quaternions[1:] * quaternions[:-1], axis=-1, keepdims=True) < 0, -1.0, 1.0)
    signs = np.concatenate([np.ones_like(quaternions[:1, ..., :1]), np.cumprod(flips, axis=0)])
    return quaternions * signs


def blended(start: Floats, end: Floats, share: ArrayLike) -> Floats:
    """Return quaternions (..., 4) on the short way from ``start`` to ``end``; ``share`` (...) is 0 to 1."""
    weight = np.asarray(share, float)[..., None]
    near = np.where(np.sum(start * end, axis=-1, keepdims=True) < 0, -end, end)
    cosine = np.clip(np.sum(start * near, axis=-1, keepdims=True), -1.0, 1.0)
    angle = np.arccos(cosine)
    sine = np.where(angle > 1e-4, np.sin(angle), 1.0)
    one = np.where(angle > 1e-4, np.sin((1 - weight) * angle) / sine, 1 - weight)
    two = np.where(angle > 1e-4, np.sin(weight * angle) / sine, weight)
    mixed = one * start + two * near
    return mixed / np.linalg.norm(mixed, axis=-1, keepdims=True)
