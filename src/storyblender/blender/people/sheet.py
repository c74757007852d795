"""Sheets: polygon meshes with skin weights, from which garments, fur and hair are made. Pure numpy.

A sheet is cut from a part of the base mesh, so it has skin weights and follows every morph. ``clip`` cuts it: it keeps
where a scalar field is positive, with a clean hem along the zero line (notes: humans, 4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.solids import Floats

Ints = NDArray[np.int64]
BLENDED_ARRAYS = ("points", "weights", "base", "skin")
"""Arrays of a sheet with a row for each vertex that a cut interpolates."""
VERTEX_ARRAYS = (*BLENDED_ARRAYS, "source")
"""Arrays of a sheet with a row for each vertex."""


@dataclass
class Sheet:
    """A polygon mesh with skin weights; V vertices, F faces.

    Attributes:
        points: (V, 3) metres.
        faces: (F, K) corners in order, rows padded with -1.
        weights: (V, 35) columns as in ``catalog.skeleton``.
        base: (V, 3) position on the base mesh, decimetres; selections made there fit every morph.
        skin: (V, 3) position on the body before the cloth was loosened, metres; garments are compared there.
        source: (V,) vertex of the base mesh, -1 where a cut made a new one.
        slot: (F,) material slot.
    """

    points: Floats
    faces: Ints
    weights: Floats
    base: Floats
    skin: Floats
    source: Ints
    slot: Ints

    def keep_faces(self, kept: NDArray[np.bool_]) -> Sheet:
        """Return the sheet of the faces where ``kept`` (F,) is true, without loose vertices."""
        faces = self.faces[kept]
        used = np.zeros(len(self.points) + 1, bool)
        used[faces] = True
        used[-1] = False
        renumber = np.full(len(self.points) + 1, -1)
        renumber[used] = np.arange(used.sum())
        vertices = {name: getattr(self, name)[used[:-1]] for name in VERTEX_ARRAYS}
        return Sheet(faces=renumber[faces], slot=self.slot[kept], **vertices)

    def moved(self, points: Floats) -> Sheet:
        """Return the same sheet with other vertex positions, (V, 3) metres."""
        return replace(self, points=points)


def rigid_sheet(
    points: Floats, faces: Sequence[Sequence[int]], weights: Floats, slots: Sequence[int] | int = 0
) -> Sheet:
    """Return a sheet that is not cut from the body, for example a button or a hat.

    Args:
        points: (V, 3) metres.
        faces: Corners of each face.
        weights: (35,) for all vertices, or (V, 35).
        slots: Material slot of each face, or one for all.
    """
    width = max(len(face) for face in faces)
    padded = np.array([[*face, *[-1] * (width - len(face))] for face in faces])
    points = np.asarray(points, float)
    return Sheet(
        points,
        padded,
        np.broadcast_to(weights, (len(points), np.shape(weights)[-1])).astype(float),
        np.zeros_like(points),
        points.copy(),
        np.full(len(points), -1),
        np.broadcast_to(slots, len(padded)).astype(np.int64),
    )


def join(sheets: Sequence[Sheet]) -> Sheet:
    """Return several sheets as one, in order."""
    width = max(sheet.faces.shape[1] for sheet in sheets)
    faces, start = [], 0
    for sheet in sheets:
        shifted = np.where(sheet.faces >= 0, sheet.faces + start, -1)
        faces.append(np.pad(shifted, ((0, 0), (0, width - shifted.shape[1])), constant_values=-1))
        start += len(sheet.points)
    stacked = {name: np.concatenate([getattr(sheet, name) for sheet in sheets]) for name in (*VERTEX_ARRAYS, "slot")}
    return Sheet(faces=np.concatenate(faces), **stacked)


def clip(sheet: Sheet, field: Floats) -> Sheet:
    """Return the part of a sheet where ``field`` (V,) is not negative, with faces cut along its zero line."""
    inside = field >= 0
    real = sheet.faces >= 0
    corner_in = inside[sheet.faces] & real
    whole = corner_in.sum(1) == real.sum(1)
    mixed = np.flatnonzero(corner_in.any(1) & ~whole)
    cuts: dict[tuple[int, int], int] = {}
    pieces: list[list[int]] = []
    for row in mixed:
        corners = [int(corner) for corner in sheet.faces[row] if corner >= 0]
        piece: list[int] = []
        for here, there in zip(corners, corners[1:] + corners[:1], strict=True):
            if inside[here]:
                piece.append(here)
            if inside[here] != inside[there]:
                edge = (min(here, there), max(here, there))
                piece.append(cuts.setdefault(edge, len(sheet.points) + len(cuts)))
        pieces.append(piece)
    width = max([sheet.faces.shape[1], *(len(piece) for piece in pieces)])
    kept = np.pad(sheet.faces[whole], ((0, 0), (0, width - sheet.faces.shape[1])), constant_values=-1)
    new = np.array([[*piece, *[-1] * (width - len(piece))] for piece in pieces], int).reshape(-1, width)
    ends = np.array(list(cuts), int).reshape(-1, 2)
    first, second = ends[:, 0], ends[:, 1]
    share = (field[first] / (field[first] - field[second]))[:, None]

    def blend(values: Floats) -> Floats:
        return np.concatenate([values, values[first] * (1 - share) + values[second] * share])

    faces = np.concatenate([kept, new])
    blended = {name: blend(getattr(sheet, name)) for name in BLENDED_ARRAYS}
    source = np.concatenate([sheet.source, np.full(len(ends), -1)])
    slot = np.concatenate([sheet.slot[whole], sheet.slot[mixed]])
    return Sheet(faces=faces, source=source, slot=slot, **blended).keep_faces(np.ones(len(faces), bool))


def half_edges(sheet: Sheet) -> Ints:
    """Return every side of every face as (start, end) vertices, (N, 2)."""
    real = sheet.faces >= 0
    following = np.where(np.arange(sheet.faces.shape[1]) == real.sum(1)[:, None] - 1, sheet.faces[:, :1],
                         np.roll(sheet.faces, -1, axis=1))  # fmt: skip
    return np.stack([sheet.faces[real], following[real]], 1)


def edges(sheet: Sheet) -> tuple[Ints, Ints]:
    """Return the distinct edges (E, 2) and the number of faces at each (E,)."""
    pairs = np.sort(half_edges(sheet), axis=1)
    keys, counts = np.unique(pairs[:, 0] * len(sheet.points) + pairs[:, 1], return_counts=True)
    return np.stack(np.divmod(keys, len(sheet.points)), 1), counts


def rim(sheet: Sheet) -> NDArray[np.bool_]:
    """Return which vertices lie on a hem, (V,)."""
    pairs, counts = edges(sheet)
    on_rim = np.zeros(len(sheet.points), bool)
    on_rim[pairs[counts == 1]] = True
    return on_rim


def _scatter(rows: Ints, values: Floats, count: int) -> Floats:
    """Return the sums (count, 3) of ``values`` (N, 3) by row number."""
    return np.stack([np.bincount(rows, values[:, axis], count).astype(float) for axis in range(3)], 1)


def normals(sheet: Sheet) -> Floats:
    """Return unit vertex normals (V, 3), weighted by face area."""
    pairs = half_edges(sheet)
    real = sheet.faces >= 0
    per_edge = np.cross(sheet.points[pairs[:, 0]], sheet.points[pairs[:, 1]])
    rows = np.nonzero(real)[0]
    per_face = _scatter(rows, per_edge, len(sheet.faces))
    total = _scatter(sheet.faces[real], per_face[rows], len(sheet.points))
    return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)


def smoothed(sheet: Sheet, rounds: int, strength: float | Floats = 0.5) -> Floats:
    """Return the points (V, 3) after Laplacian smoothing, metres; hems stay.

    Args:
        sheet: The mesh.
        rounds: How often it is smoothed.
        strength: Share of the way to the mean of its neighbours that a vertex moves, one value or (V,).
    """
    pairs, counts = edges(sheet)
    amount = np.broadcast_to(strength, len(sheet.points)).copy()
    amount[pairs[counts == 1]] = 0
    both = np.concatenate([pairs, pairs[:, ::-1]])
    degree = np.maximum(np.bincount(both[:, 0], minlength=len(sheet.points)), 1)[:, None]
    points = sheet.points.copy()
    for _ in range(rounds):
        mean = _scatter(both[:, 0], points[both[:, 1]], len(points)) / degree
        points += (mean - points) * amount[:, None]
    return points


def loosened(sheet: Sheet, ease: float | Floats, rounds: int) -> Sheet:
    """Return a sheet smoothed to cloth that keeps off the surface it lay on.

    Args:
        sheet: The mesh, on that surface.
        ease: Metres between them at least, one value or (V,).
        rounds: How often it is smoothed.
    """
    outward = normals(sheet)
    points = smoothed(sheet, rounds)
    clearance = ((points - sheet.points) * outward).sum(1)
    return sheet.moved(points + outward * np.maximum(0, ease - clearance)[:, None])


def hemmed(sheet: Sheet, thickness: float) -> Sheet:
    """Return a sheet with its hems folded inwards by ``thickness`` metres, so that the cloth shows its thickness."""
    pairs = half_edges(sheet)
    count = len(sheet.points)
    keys = pairs.min(1) * count + pairs.max(1)
    _, where, counts = np.unique(keys, return_inverse=True, return_counts=True)
    outer = pairs[counts[where] == 1]
    ring = np.unique(outer)
    if not len(ring):
        return sheet
    fold = np.full(count, -1)
    fold[ring] = count + np.arange(len(ring))
    inner = sheet.points[ring] - normals(sheet)[ring] * thickness
    owner = np.nonzero(sheet.faces >= 0)[0][counts[where] == 1]
    width = max(4, sheet.faces.shape[1])
    sides = np.full((len(outer), width), -1)
    sides[:, :4] = np.stack([outer[:, 1], outer[:, 0], fold[outer[:, 0]], fold[outer[:, 1]]], 1)
    faces = np.pad(sheet.faces, ((0, 0), (0, width - sheet.faces.shape[1])), constant_values=-1)
    doubled = {name: np.concatenate([values := getattr(sheet, name), values[ring]]) for name in BLENDED_ARRAYS}
    doubled["points"][count:] = inner
    source = np.concatenate([sheet.source, np.full(len(ring), -1)])
    slot = np.concatenate([sheet.slot, sheet.slot[owner]])
    return Sheet(faces=np.concatenate([faces, sides]), source=source, slot=slot, **doubled)
