"""Builds a stand-in: a plain shape with its name in raised letters, so that nobody takes it for the real thing."""

from __future__ import annotations

import math

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.build import PropBuild, settle
from storyblender.blender.props.registry import Anchors, two_hands
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS, StandIn
from storyblender.memory.asset_sheet import AssetDimension

LABEL = "plastic_black"
CONE = (1.0, 0.98, 0.42, 0.12, 0.05)
"""Width of the cone from foot to tip."""


def build_stand_in(name: str, key: str, seed: int = 0, dimension: AssetDimension | None = None) -> PropBuild:
    """Build the stand-in of a thing.

    Args:
        name: Written on its front.
        key: A key of ``catalog.stand_ins``; an unknown one gives the default class.
        seed: Taken for symmetry with ``build_prop``; stand-ins do not vary.
        dimension: The wanted size.
    """
    entry = STAND_INS.get(key, STAND_INS[DEFAULT])
    builder = MeshBuilder(f"stand_in_{entry.key}")
    _body(builder, entry)
    _label(builder, name, entry)
    return settle(builder.mesh(), _grips(entry), dimension)


def _body(b: MeshBuilder, entry: StandIn) -> None:
    (w, d, h), skin = entry.size, entry.material
    edge = 0.08 * min(w, d, h)
    match entry.shape:
        case "box":
            b.rounded_box(skin, (0, 0, h / 2), (w, d, h), edge)
        case "slab":
            b.box(skin, (0, 0, h / 2), (w, d, h), bevel=edge)
        case "drum":
            r = w / 2
            b.lathe(skin, [(r - edge, 0), (r, edge), (r, h - edge), (r - edge, h)], segments=32)
        case "rod":
            b.lathe(
                skin,
                [(w * 0.3, 0), (w * 0.5, h * 0.02), (w * 0.4, h * 0.5), (w * 0.5, h * 0.98), (w * 0.3, h)],
                segments=16,
            )
        case "ball":
            r = w / 2
            arc = [(r * math.cos(a), r + r * math.sin(a)) for a in np.linspace(-1.2, math.pi / 2, 14)]
            b.lathe(skin, arc, segments=28)
        case "cone":
            rings = []
            for t, s in zip((0.0, 0.12, 0.75, 0.95, 1.0), CONE, strict=True):
                angle = np.linspace(0, math.tau, 28, endpoint=False)
                rings.append(np.c_[w / 2 * s * np.cos(angle), d / 2 * s * np.sin(angle), np.full(28, h * t)])
            b.loft(skin, rings)


def _label(b: MeshBuilder, name: str, entry: StandIn) -> None:
    """Write the name on the front, raised; on top where the front is too low to read."""
    w, d, h = entry.size
    points, faces = _letters(name.replace("_", " ").strip() or entry.name)
    if not faces:
        return
    extent = np.ptp(points, axis=0)
    flat = h < 0.25 * d
    wide, tall = (w, d) if flat else (w, h)
    wide *= 0.8 if entry.shape in ("box", "slab") else 0.62
    scale = min(wide / max(extent[0], 1e-6), 0.3 * tall / max(extent[1], 1e-6))
    x, across, out = (points * (scale, scale, 0.06 * scale / max(extent[2], 1e-6))).T
    if flat:
        with b.at((0, 0, h), (0, 0, 180)):
            b.add(LABEL, np.c_[x, across, out], faces)
        return
    z = across + h * (0.3 if entry.shape == "cone" else 0.5)
    b.add(LABEL, np.c_[x, _front(entry, x, z) - out, z], faces)


def _front(entry: StandIn, x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return the y of the shape's front under the letters, so that they follow its curve."""
    w, d, h = entry.size
    match entry.shape:
        case "ball":
            reach = np.sqrt(np.clip(1 - ((z - w / 2) / (w / 2)) ** 2, 0.01, 1))
        case "cone":
            reach = np.interp(z / h, (0.0, 0.12, 0.75, 0.95, 1.0), CONE)
        case "rod":
            reach = np.interp(z / h, (0.02, 0.5, 0.98), (1.0, 0.8, 1.0))
        case "drum":
            reach = np.ones_like(z)
        case _:
            return np.full_like(z, -d / 2)
    return -d / 2 * reach * np.sqrt(np.clip(1 - (x / (w / 2 * reach)) ** 2, 0, 1))


def _letters(text: str) -> tuple[np.ndarray, list[tuple[int, ...]]]:
    """Return the vertices and faces of centred extruded text in Blender's own font."""
    curve = bpy.data.curves.new("label", "FONT")
    curve.body, curve.align_x, curve.align_y = text.upper(), "CENTER", "CENTER"
    curve.extrude, curve.resolution_u = 0.04, 2
    carrier = bpy.data.objects.new("label", curve)
    mesh = bpy.data.meshes.new_from_object(carrier)
    points = np.array([vertex.co[:] for vertex in mesh.vertices], float).reshape(-1, 3)
    faces = [tuple(polygon.vertices) for polygon in mesh.polygons]
    bpy.data.objects.remove(carrier)
    bpy.data.curves.remove(curve)
    bpy.data.meshes.remove(mesh)
    return points, faces


def _grips(entry: StandIn) -> Anchors:
    if not entry.holdable:
        return ()
    w, d, h = entry.size
    if entry.shape == "slab":
        return two_hands((0, d * 0.35, -0.012), (0, -1, 0), (0, 0, 1), (0.15, 0.2, 0.0))
    return two_hands((-w / 2, 0, h * 0.45), (0.25, -1, 0), (1, 0.2, 0), (0.45, 0.5, 0.3))
