"""Lettering on props: flat letters in Blender's built-in font, laid on the lettered side of a built prop."""

from __future__ import annotations

import textwrap

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from numpy.typing import NDArray

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.catalog.writing import MAX_LETTERS, Writing

Floats = NDArray[np.float64]
LINES = 7
LIFT = 0.0025
"""Offset in metres of the plate from the surface, and of the letters from the plate, on a prop of half a metre."""
MOST_PROUD = 0.05
"""Largest relief in metres that the plate covers; farther parts are not old lettering."""
BOLD = 0.018
"""Thickening of the strokes, as a share of the letter height."""


def write_on(b: MeshBuilder, mesh: bpy.types.Mesh, place: Writing, text: str) -> bool:
    """Add text to a builder, on the text area of the mesh built so far.

    Args:
        b: The builder of ``mesh``.
        mesh: The mesh built so far.
        place: Text area of the prop.
        text: Text to write; at most ``MAX_LETTERS`` characters are shown.

    Returns:
        Whether there was a surface to write on.
    """
    frame = _frame(mesh, place)
    points, faces, aspect = _fitted(text.strip()[:MAX_LETTERS], frame)
    if frame is None or not faces:
        return False
    middle, right, up, normal, width, height, proud = frame
    lift = LIFT * max(0.25, min(width, height) / 0.3)
    middle = middle + normal * proud
    if place.ground:
        corners = [middle + normal * lift + right * x * width / 2 + up * y * height / 2
                   for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]  # fmt: skip
        b.quad(place.ground, *corners)
    scale = min(width * 0.92 / aspect[0], height * 0.86 / aspect[1])
    flat = points * scale
    laid = middle + normal * 2 * lift + np.outer(flat[:, 0], right) + np.outer(flat[:, 1], up)
    b.add(place.ink, laid, faces)
    return True


def face_on(b: MeshBuilder, mesh: bpy.types.Mesh, place: Writing) -> bool:
    """Add a caller's head and shoulders to a builder, on the screen of the mesh built so far.

    Args:
        b: The builder of ``mesh``.
        mesh: The mesh built so far.
        place: The screen.

    Returns:
        Whether there was a screen.
    """
    frame = _frame(mesh, place)
    if frame is None:
        return False
    middle, right, up, normal, width, height, proud = frame
    lift = LIFT * max(0.25, min(width, height) / 0.3)
    turn = np.linspace(0, 2 * np.pi, 28, endpoint=False)
    size = min(width, height)
    half = np.linspace(0, np.pi, 16)
    shapes = (
        ("plaster", np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (width / 2, height / 2)),
        ("fabric_blue", np.c_[0.42 * size * np.cos(half), -height / 2 + 0.34 * size * np.sin(half)]),
        ("wood_dark", np.c_[0.19 * size * np.cos(turn), 0.09 * size + 0.25 * size * np.sin(turn)]),
        ("wax", np.c_[0.155 * size * np.cos(turn), 0.04 * size + 0.2 * size * np.sin(turn)]),
    )
    for layer, (material, flat) in enumerate(shapes, 1):
        corners = middle + normal * (proud + layer * lift) + np.outer(flat[:, 0], right) + np.outer(flat[:, 1], up)
        b.polygon(material, corners)
    return True


def _frame(mesh: bpy.types.Mesh, place: Writing) -> tuple[Floats, Floats, Floats, Floats, float, float, float] | None:
    """Return centre, right, up and normal of the text surface, width and height of the text area, and the relief
    in front of it, in metres; None without a surface."""
    cloud = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", cloud)
    points = cloud.reshape(-1, 3).astype(float)
    low, high = points.min(axis=0), points.max(axis=0)
    size, center = high - low, (high + low) / 2
    across, along = place.middle
    front = place.side == "front"
    tree = BVHTree.FromPolygons(points.tolist(), [tuple(polygon.vertices) for polygon in mesh.polygons])
    x = center[0] + across * size[0]
    if front:
        start, way = Vector((x, low[1] - 1.0, center[2] + along * size[2])), Vector((0, 1, 0))
    else:
        start, way = Vector((x, center[1] + along * size[1], high[2] + 1.0)), Vector((0, 0, -1))
    hit, normal, _, _ = tree.ray_cast(start, way)
    if hit is None or normal is None:
        return None
    out = np.array(normal) * (1.0 if normal.dot(way) < 0 else -1.0)
    rise = np.array((0.0, 0.0, 1.0) if front else (0.0, 1.0, 0.0))
    up = rise - (rise @ out) * out
    up /= np.linalg.norm(up)
    right = np.cross(up, out)
    tall = size[2] if front else size[1]
    width, height = float(place.size[0] * size[0]), float(place.size[1] * tall)
    proud = 0.0
    for u in np.linspace(-0.46, 0.46, 17):
        for v in np.linspace(-0.46, 0.46, 17):
            above = np.array(hit) + right * u * width + up * v * height + out * MOST_PROUD
            near, *_ = tree.ray_cast(Vector(above), Vector(-out), MOST_PROUD)
            if near is not None and place.ground:
                proud = max(proud, float((np.array(near) - np.array(hit)) @ out))
    return np.array(hit), right, up, out, width, height, proud


def _fitted(
    text: str, frame: tuple[Floats, Floats, Floats, Floats, float, float, float] | None
) -> tuple[Floats, list[tuple[int, ...]], tuple[float, float]]:
    """Return vertices, faces, width and height of the text, with the line breaks that give the largest letters."""
    if frame is None or not text:
        return np.zeros((0, 2)), [], (1.0, 1.0)
    best: tuple[float, str] = (0.0, text)
    for count in range(1, LINES + 1):
        longest = max(len(word) for word in text.split())
        wrapped = textwrap.wrap(text, max(longest, -(-len(text) // count) + 2), break_long_words=False)
        wide = 0.62 * max(len(line) for line in wrapped)
        scale = min(frame[4] / wide, frame[5] / (1.1 * len(wrapped)))
        if scale > best[0]:
            best = (scale, "\n".join(wrapped))
    points, faces = _letters(best[1])
    extent = np.ptp(points, axis=0) if len(points) else np.ones(2)
    return points, faces, (max(float(extent[0]), 1e-4), max(float(extent[1]), 1e-4))


def _letters(text: str) -> tuple[Floats, list[tuple[int, ...]]]:
    """Return vertices and faces of flat, centred text, one unit high."""
    curve = bpy.data.curves.new("writing", "FONT")
    curve.body, curve.align_x, curve.align_y = text, "CENTER", "CENTER"
    curve.resolution_u, curve.offset = 3, BOLD
    carrier = bpy.data.objects.new("writing", curve)
    mesh = bpy.data.meshes.new_from_object(carrier)
    flat = np.array([vertex.co[:2] for vertex in mesh.vertices], float).reshape(-1, 2)
    faces = [tuple(polygon.vertices) for polygon in mesh.polygons]
    bpy.data.objects.remove(carrier)
    bpy.data.curves.remove(curve)
    bpy.data.meshes.remove(mesh)
    if len(flat):
        flat = flat - (flat.min(axis=0) + flat.max(axis=0)) / 2
    return flat, faces
