"""Painted skin as a few plain materials: a moving frame shows brows, lips and blush without a picture of their own.

Workbench draws textures or painted vertices, not both; a second pass for the skin would double the cost of a frame.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
import numpy as np
from numpy.typing import NDArray
from PIL import Image

_SHADES = 24
"""Number of materials that a skin is reduced to."""


@contextmanager
def told_in_shades(skin: bpy.types.Object) -> Iterator[None]:
    """Give every face of a painted mesh a material of its colour; the mesh is as it was afterwards.

    Args:
        skin: A mesh with a colour attribute on its corners or vertices.
    """
    mesh = skin.data
    colors = _face_colors(mesh)
    shades, index = _shades(colors)
    before, materials = np.empty(len(mesh.polygons), np.int32), list(mesh.materials)
    mesh.polygons.foreach_get("material_index", before)
    made = [bpy.data.materials.new("shade") for _ in shades]
    try:
        mesh.materials.clear()
        for material, shade in zip(made, shades, strict=True):
            material.diffuse_color = (*shade.tolist(), 1.0)
            mesh.materials.append(material)
        _assign(mesh, index)
        yield
    finally:
        mesh.materials.clear()
        for material in materials:
            mesh.materials.append(material)
        _assign(mesh, before)
        bpy.data.batch_remove(made)


def _assign(mesh: bpy.types.Mesh, index: NDArray[np.int32]) -> None:
    mesh.polygons.foreach_set("material_index", index)
    mesh.update()


def _face_colors(mesh: bpy.types.Mesh) -> NDArray[np.float32]:
    """Return the (faces, 3) mean linear colour of each face's corners."""
    layer = mesh.color_attributes[0]
    colors = np.empty(len(layer.data) * 4, np.float32)
    layer.data.foreach_get("color", colors)
    colors = colors.reshape(-1, 4)[:, :3]
    if layer.domain == "POINT":
        corners = np.empty(len(mesh.loops), np.int32)
        mesh.loops.foreach_get("vertex_index", corners)
        colors = colors[corners]
    first = np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("loop_start", first)
    sums = np.add.reduceat(colors, first, axis=0)
    return (sums / np.diff(np.append(first, len(colors)))[:, None]).astype(np.float32)


def _shades(colors: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Return (n, 3) shades by median cut of the display colours, and the shade of each face."""
    display = np.clip(colors ** np.float32(1 / 2.2) * 255 + 0.5, 0, 255).astype(np.uint8)
    strip = Image.fromarray(display[None]).quantize(_SHADES, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    names, index = np.unique(np.asarray(strip)[0], return_inverse=True)
    counts = np.bincount(index, minlength=len(names))[:, None]
    sums = np.stack([np.bincount(index, colors[:, band], len(names)) for band in range(3)], axis=1)
    return (sums / counts).astype(np.float32), index.astype(np.int32)
