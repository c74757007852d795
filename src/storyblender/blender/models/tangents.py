"""Tangents of a mesh as a colour attribute: the direction along its surface in which its pictures go to the right."""

from __future__ import annotations

import bpy
import numpy as np

TANGENTS = "tangent"
"""Name of the attribute: half a unit vector plus a half; half as long where the picture is mirrored."""
_MIRRORED = 0.5


def add_tangents(mesh: bpy.types.Mesh) -> None:
    """Add the tangents of a mesh's texture coordinates, one for each face, in the mesh's own frame.

    Args:
        mesh: In its final pose; one without texture coordinates stays as it is.
    """
    if not mesh.uv_layers:
        return
    starts = _read(mesh.polygons, "loop_start", 1, np.int32)[:, 0]
    sizes = _read(mesh.polygons, "loop_total", 1, np.int32)[:, 0]
    vertices = _read(mesh.loops, "vertex_index", 1, np.int32)[:, 0]
    points = _read(mesh.vertices, "co", 3, np.float32)[vertices]
    laid = _read(mesh.uv_layers[0].uv, "vector", 2, np.float32)
    edges = [points[starts + corner] - points[starts] for corner in (1, 2)]
    steps = [laid[starts + corner] - laid[starts] for corner in (1, 2)]
    area = steps[0][:, 0] * steps[1][:, 1] - steps[0][:, 1] * steps[1][:, 0]
    along = edges[0] * steps[1][:, 1:] - edges[1] * steps[0][:, 1:]
    along *= np.where(area < 0, -1, 1)[:, None]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along = np.where(length > 0, along / np.maximum(length, 1e-30), 0) * np.where(area < 0, _MIRRORED, 1)[:, None]
    attribute = mesh.color_attributes.new(TANGENTS, "FLOAT_COLOR", "CORNER")
    colors = np.ones((len(vertices), 4), np.float32)
    colors[:, :3] = np.repeat(0.5 + 0.5 * along, sizes, axis=0)
    attribute.data.foreach_set("color", colors.ravel())
    mesh.color_attributes.active_color = attribute
    mesh.color_attributes.render_color_index = mesh.color_attributes.active_color_index


def tangents_in(colors: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the (n, 3) tangents of attribute colours, and (n,) -1 where the picture is mirrored, else 1."""
    along = colors * 2 - 1
    length = np.linalg.norm(along, axis=1)
    return along / np.maximum(length, 1e-6)[:, None], np.where(length < (1 + _MIRRORED) / 2, -1.0, 1.0)


def _read(items: bpy.types.bpy_prop_collection, name: str, width: int, kind: type) -> np.ndarray:
    values = np.empty(len(items) * width, kind)
    items.foreach_get(name, values)
    return values.reshape(-1, width)
