"""A hash of built geometry, equal across runs and machines."""

from __future__ import annotations

import hashlib

import bpy
import numpy as np


def geometry_hash(mesh: bpy.types.Mesh) -> str:
    """Return 16 hex digits of the vertices (rounded to 0.01 mm), the faces and their materials."""
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    slots = np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("material_index", slots)
    starts = np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("loop_start", starts)
    digest = hashlib.sha256()
    digest.update(np.rint(points.astype(np.float64) * 1e5).astype("<i8").tobytes())
    for numbers in (corners, starts, slots):
        digest.update(numbers.astype("<i4").tobytes())
    return digest.hexdigest()[:16]
