"""Joins the parts of a model to one surface, and refuses what no surface can be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.models.limits import COORDINATE, CORNERS, FACES, VERTICES
from storyblender.blender.models.plain import PlainModel
from storyblender.errors import InputError

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Part:
    """Triangles of one material.

    Attributes:
        vertices: (n, 3) where they stand.
        triangles: (m, 3) vertex indices.
        slot: Material, or -1.
        smooth: Whether it is shaded smooth.
        layers: Up to two (3 m, 2) texture coordinates, of the corners.
        paint: (3 m, 3) scene-linear colours of the corners.
        joints: (n, 4) nodes of the file that move each vertex, -1 for none; None where nothing is skinned.
        weights: (n, 4) how much.
    """

    vertices: Floats
    triangles: NDArray[np.int64]
    slot: int
    smooth: bool
    layers: Sequence[Floats]
    paint: Floats | None
    joints: NDArray[np.int64] | None = None
    weights: Floats | None = None


def joined(parts: Sequence[Part]) -> PlainModel:
    """Return one model of all parts.

    Raises:
        InputError: There is no surface, it is too large, or a place in it is no number.
    """
    if not parts:
        raise InputError("the file holds no mesh")
    total = sum(len(part.vertices) for part in parts), sum(len(part.triangles) for part in parts)
    within_bounds(*total)
    corners = [part.triangles + start for part, start in zip(parts, _starts(parts), strict=True)]
    depth = max(len(part.layers) for part in parts)
    layers = [
        np.concatenate([_of_corners(part, part.layers[k] if k < len(part.layers) else None, 2) for part in parts])
        for k in range(depth)
    ]
    painted = any(part.paint is not None for part in parts)
    paint = [_of_corners(part, part.paint, 3, 1.0) for part in parts] if painted else [np.zeros((0, 3))]
    counts = [len(part.triangles) for part in parts]
    return checked(
        PlainModel(
            vertices=np.concatenate([part.vertices for part in parts]).astype(np.float32),
            corners=np.concatenate(corners).ravel().astype(np.int32),
            sizes=np.full(total[1], 3, np.int32),
            slots=np.repeat([part.slot for part in parts], counts).astype(np.int32),
            smooth=np.repeat([part.smooth for part in parts], counts).astype(bool),
            layers=np.array(layers, np.float32).reshape(depth, total[1] * 3, 2),
            paint=np.concatenate(paint).astype(np.float32),
        )
    )


def within_bounds(vertices: int, faces: int) -> None:
    """Refuse a model without a surface, and one that is larger than a story can bear.

    Args:
        vertices: Number read so far.
        faces: Number read so far.

    Raises:
        InputError: It has none, or too many.
    """
    if not vertices or not faces:
        raise InputError("the file holds no mesh")
    if faces > FACES or vertices > VERTICES:
        raise InputError(
            f"it has {max(faces, vertices)} faces or vertices; at most {FACES} faces are read",
            mend="make it simpler, for example with Blender's Decimate",
        )


def checked(model: PlainModel) -> PlainModel:
    """Return a model whose numbers can be trusted.

    Raises:
        InputError: A place is no number or far off, a corner is not there, or everything is in one point.
    """
    within_bounds(len(model.vertices), len(model.sizes))
    if not np.isfinite(model.vertices).all() or np.abs(model.vertices).max() > COORDINATE:
        raise InputError("a vertex in it is nowhere: its place is no number, or very far away")
    if len(model.corners) > CORNERS or int(model.sizes.sum()) != len(model.corners) or model.sizes.min() < 3:
        raise InputError("a face in it has fewer than three corners, or far too many")
    if model.corners.min() < 0 or model.corners.max() >= len(model.vertices):
        raise InputError("a face in it has a corner that is not there")
    used = model.vertices[model.corners]
    if np.sort(np.ptp(used, axis=0))[1] <= 1e-9:
        raise InputError("its surface has no extent")
    return model


def _starts(parts: Sequence[Part]) -> list[int]:
    return np.cumsum([0, *(len(part.vertices) for part in parts[:-1])]).tolist()


def _of_corners(part: Part, values: Floats | None, width: int, missing: float = 0.0) -> Floats:
    """Return a part's values at the corners of its faces, the same for all where it has none."""
    return np.full((part.triangles.size, width), missing) if values is None else values
